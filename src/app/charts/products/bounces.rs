//! Charts of the part "bounces" of the page "Products": error against bounces.
