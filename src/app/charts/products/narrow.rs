//! Charts of the part "narrow" of the page "Products": a narrow band-pass.
