//! From the light in columns to the colours of a screen.

use super::sent::Sent;
use crate::{
    app::chart::Rgb,
    color::{Observer, Srgb, Xyz},
    languages::fixed,
    optics::{Light, into_gamut},
};

/// Columns of light as a screen shows them.
#[derive(Clone, Debug, PartialEq)]
pub struct Colours {
    /// A colour a column.
    pub rgb: Vec<Rgb>,
    /// Share of the lit columns that are mixed with white, for no screen shows such colours.
    pub mixed: f64,
    /// Share of the lit columns that are brighter than the screen: shown as bright as it can.
    pub too_bright: f64,
    /// Whether some column has light below zero, which is drawn black.
    pub below_zero: bool,
}

/// Where among the lit columns the one is that exposure 0 shows at [`LEVEL`]: above it are the
/// lines, which would leave the smooth part black.
const SHARE: f64 = 0.9;

/// What is dimmer than exposure 0 shows holds at least this share of all light. Else columns
/// beside the lines would decide, however little light falls there: a mercury tube, whose weak
/// lines and glow are a few thousandths of its light, would show a rainbow.
const LEAST_SHARE: f64 = 0.02;

/// Whether exposure 0 shows what lies beside a light's lines.
pub(super) fn smooth_is_seen(light: &Light, observer: Observer) -> bool {
    let smooth = light.smooth_alone();
    let smooth = smooth.map_or(0.0, |smooth| smooth.white(observer).y);
    smooth >= LEAST_SHARE * light.white(observer).y
}

/// How bright that column is shown, of the screen's largest channel.
const LEVEL: f64 = 0.45;

/// The power of its brightness that a column is shown by: what is dim is seen beside what is bright,
/// violet beside green.
const DIM: f64 = 0.6;

/// A column below this share of the brightest is dark.
const DARK: f64 = 1e-6;

impl Colours {
    /// Of X, Y, Z, `stops` brighter than usual. What is too bright keeps its hue.
    pub fn of(xyz: &[Xyz], stops: f64) -> Self {
        let mixed: Vec<([f64; 3], bool)> = xyz.iter().map(|xyz| into_gamut(*xyz)).collect();
        let peak = |linear: &[f64; 3]| linear.iter().copied().fold(0.0, f64::max);
        let mut levels: Vec<f64> = mixed.iter().map(|(linear, _)| peak(linear)).collect();
        let least = DARK * levels.iter().copied().fold(0.0, f64::max);
        let lit = |linear: &[f64; 3]| peak(linear) > least;
        levels.retain(|level| *level > least);
        levels.sort_by(f64::total_cmp);
        let all: f64 = levels.iter().sum();
        let mut dimmer = levels.iter().scan(0.0, |sum, level| {
            *sum += level;
            Some(*sum)
        });
        let least = dimmer.position(|sum| sum >= LEAST_SHARE * all);
        let place = ((SHARE * levels.len() as f64) as usize).max(least.unwrap_or(0));
        let usual = levels.get(place.min(levels.len().saturating_sub(1)));
        let gain = usual.map_or(0.0, |level| LEVEL / level) * stops.exp2();
        let share = |count: usize| count as f64 / levels.len().max(1) as f64;
        let colour = |(linear, _): &([f64; 3], bool)| {
            let level = peak(linear);
            let shown = (gain * level).max(0.0).powf(DIM).min(1.0);
            let scale = if level > 0.0 { shown / level } else { 0.0 };
            Srgb::from_linear(linear.map(|v| v * scale)).0
        };
        Self {
            rgb: mixed.iter().map(colour).collect(),
            mixed: share(mixed.iter().filter(|(l, out)| *out && lit(l)).count()),
            too_bright: share(levels.iter().filter(|level| gain * **level > 1.0).count()),
            below_zero: xyz.iter().any(|xyz| xyz.y < 0.0),
        }
    }

    /// What is not shown as it is, sentences; empty where all is.
    pub fn words(&self, sent: Sent) -> String {
        let mut said = Vec::new();
        if self.mixed > 0.0 {
            said.push(
                said!("These colours are purer than a screen can show, so white is mixed in.")
                    .to_owned(),
            );
        }
        if self.too_bright > 0.0 {
            said.push(tr!(
                "{share} % of it is brighter than the screen at this exposure.",
                share = fixed(100.0 * self.too_bright, 0)
            ));
        }
        // Beside a measured line so little may be left that it is below zero: that is no dark place.
        if self.below_zero && sent == Sent::Model {
            said.push(said!("The model is below zero in places: they are drawn black.").to_owned());
        }
        said.join(" ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::srgb::WHITE;

    #[test]
    fn what_is_too_bright_keeps_its_hue_and_darkness_is_black() {
        let mut columns = vec![WHITE * 0.1; 99];
        columns.push(Xyz::new(0.3, 0.6, 0.1) * 100.0);
        columns.push(Xyz::ZERO);
        let shown = Colours::of(&columns, 0.0);
        let [r, g, b] = shown.rgb[99];
        assert!(g == 255 && r < g && b < g, "{:?}", shown.rgb[99]);
        assert_eq!(shown.rgb[100], [0; 3]);
        assert_eq!(
            (shown.rgb[0][0], shown.rgb[0][1]),
            (shown.rgb[0][1], shown.rgb[0][2])
        );
        assert!(shown.too_bright > 0.0 && !shown.below_zero);
        let brighter = Colours::of(&columns, 1.0);
        assert!(brighter.rgb[0][0] > shown.rgb[0][0]);
    }

    #[test]
    fn what_is_a_thousandth_of_a_line_lamp_stays_dark() {
        // Five lines over a glow that holds 1 % of the light; then half of it.
        let strip = |glow: f64| {
            let mut columns = vec![WHITE * (glow / 995.0); 1000];
            (0..5).for_each(|i| columns[200 * i] = WHITE * ((1.0 - glow) / 5.0));
            Colours::of(&columns, 0.0)
        };
        let (tube, phosphor) = (strip(0.01), strip(0.5));
        // A column of the glow is 1e-5 of all light, a line .2 of it: (.45 x 5e-5)^.6 of full scale
        // is 5 of 255, darker than a dark room.
        assert_eq!((tube.rgb[100], tube.rgb[200]), ([5; 3], tube.rgb[0]));
        assert!(tube.rgb[0][1] > 150, "{:?}", tube.rgb[0]);
        assert!(phosphor.rgb[100][1] > 150, "{:?}", phosphor.rgb[100]);
    }

    #[test]
    fn no_light_is_black_without_a_word_missing() {
        let shown = Colours::of(&[Xyz::ZERO, Xyz::new(-1.0, -1.0, -1.0)], 3.0);
        assert_eq!(shown.rgb, [[0; 3]; 2]);
        assert!(shown.words(Sent::Model).contains("below zero"));
        assert!(!shown.words(Sent::Measured).contains("below zero"));
        assert!(Colours::of(&[], 0.0).rgb.is_empty());
    }
}
