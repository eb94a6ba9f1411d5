//! The subject's colour as measured and as modelled.

use super::{
    Question,
    fitted::{Fitted, is_positive},
};
use crate::{
    app::tables::Tables,
    color::{
        Adaptation, Cct, NoCct, Srgb, Xyz, cct_from_xyz, delta_e_2000, lab_from_xyz, srgb::Swatch,
        uv_1976_from_xyz, xy_from_xyz, xyz_of_lines, xyz_of_parts,
    },
};

/// A colour with everything that is said about it; XYZ has the exact light's Y at 100.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colour {
    /// Tristimulus values; 100 is the Y of the exact light.
    pub xyz: Xyz,
    /// Chromaticity x, y.
    pub xy: [f64; 2],
    /// CIE 1976 u', v'.
    pub uv: [f64; 2],
    /// What the screen shows.
    pub swatch: Swatch,
    /// Correlated colour temperature of a light; `None` for a reflectance, which has none.
    pub cct: Option<Result<Cct, NoCct>>,
}

/// The subject's colour as measured and as modelled.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ColourComparison {
    /// The measured spectrum on the model's range and quadrature.
    pub exact: Option<Colour>,
    pub model: Option<Colour>,
    /// The measured spectrum by plain 1 nm sums over 360-830 nm.
    pub full: Option<Colour>,
    /// CIEDE2000 between exact and model; the white is the exact light.
    pub delta_e_2000: Option<f64>,
    /// Distance in CIE 1976 u'v' between exact and model.
    pub delta_uv: Option<f64>,
    /// Share of the light's Y (360-830 nm) that the model's range leaves out, 0-1.
    pub missing_luminance: f64,
}

impl Fitted {
    /// Both colours, and the measured one over 360-830 nm.
    pub(super) fn colour(
        &self,
        question: Question<'_>,
        tables: &Tables,
        coefficients: &[f64],
    ) -> ColourComparison {
        let band = tables.band();
        let weights_1931 = &tables.viewing.weights_1931;
        let is_light = question.is_light;
        let exact_1931 = xyz_of_parts(band, question.measured, &[], weights_1931);
        let model_1931 = Xyz::from_array(tables.colour_1931.of(coefficients))
            + xyz_of_lines(&self.lines, weights_1931);
        let missing_luminance = if question.full_luminance > 0.0 {
            let seen = band.inner(
                question.light,
                &question.settings.observer.table().on_band(band)[1],
            );
            (1.0 - seen / question.full_luminance).max(0.0)
        } else {
            0.0
        };
        // It knows no range: there is one where the model's range is dark, too.
        let full = question.full.and_then(|(xyz, xyz_1931)| {
            // Of a reflectance's light nothing but Y, at 100 here, is needed.
            let white = if is_light {
                xyz
            } else {
                Xyz::new(0.0, 100.0, 0.0)
            };
            Colour::of(xyz, xyz_1931, white, is_light)
        });
        if !is_positive(self.white.y) {
            return ColourComparison {
                full,
                missing_luminance,
                ..ColourComparison::default()
            };
        }
        let scale = 100.0 / self.white.y;
        let white = self.white * scale;
        let colour = |xyz: Xyz, xyz_1931: Xyz| Colour::of(xyz, xyz_1931, white, is_light);
        let exact = colour(self.exact_xyz * scale, exact_1931);
        let model = colour(self.model_xyz(tables, coefficients) * scale, model_1931);
        let both = exact.zip(model);
        ColourComparison {
            exact,
            model,
            full,
            delta_e_2000: both
                .map(|(e, m)| delta_e_2000(lab_from_xyz(e.xyz, white), lab_from_xyz(m.xyz, white))),
            delta_uv: both.map(|(e, m)| (e.uv[0] - m.uv[0]).hypot(e.uv[1] - m.uv[1])),
            missing_luminance,
        }
    }
}

impl Colour {
    /// `None` when there is no colour to speak of. `white` is the light in the same scale.
    pub(in crate::app) fn of(xyz: Xyz, xyz_1931: Xyz, white: Xyz, is_light: bool) -> Option<Self> {
        if !xyz.is_finite() || !is_positive(white.y) {
            return None;
        }
        Some(Self {
            xyz,
            xy: xy_from_xyz(xyz)?,
            uv: uv_1976_from_xyz(xyz)?,
            swatch: if is_light {
                Swatch::of_light(xyz)
            } else {
                Swatch::of_patch(xyz, white, Adaptation::None)
            },
            cct: is_light.then(|| cct_from_xyz(xyz_1931)),
        })
    }

    /// The screen colour.
    pub fn srgb(&self) -> Srgb {
        self.swatch.rgb8
    }
}
