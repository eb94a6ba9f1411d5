//! Charts of the part "chain" of the page "Products": the stages of a chain.
