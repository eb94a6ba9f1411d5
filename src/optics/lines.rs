//! The lines at which indices are quoted, nm in air (ISO 7944, SCHOTT TIE-29; G and B Fraunhofer's).

/// Blue hydrogen line F.
pub(super) const LINE_F_NM: f64 = 486.1327;
/// Blue cadmium line F'.
pub(super) const LINE_F_PRIME_NM: f64 = 479.9914;
/// Green mercury line e.
pub(super) const LINE_E_NM: f64 = 546.074;
/// Yellow helium line d.
pub(super) const LINE_D_NM: f64 = 587.5618;
/// Red cadmium line C'.
pub(super) const LINE_C_PRIME_NM: f64 = 643.8469;
/// Red hydrogen line C.
pub(super) const LINE_C_NM: f64 = 656.2725;
/// Fraunhofer's G, the blue end of the gem trade's "fire".
pub(super) const LINE_G_NM: f64 = 430.8;
/// Fraunhofer's B, its red end.
pub(super) const LINE_B_NM: f64 = 686.7;
