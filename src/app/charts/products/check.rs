//! Charts of the part "check" of the page "Products": the reflection check.
