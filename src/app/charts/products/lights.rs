//! Charts of the part "lights" of the page "Products": two lights.
