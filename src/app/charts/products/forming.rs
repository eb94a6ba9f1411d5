//! Charts of the part "forming" of the page "Products": one product in every way.
