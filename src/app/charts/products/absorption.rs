//! Charts of the part "absorption" of the page "Products": absorption lines.
