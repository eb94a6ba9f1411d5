//! What an instrument sees: light and model behind a slit of 10 nm, as a difference and as a strip
//! of colours.

use super::{answers::Worst, numbers::two_digits, state::App, verdicts::Seen};
use crate::{
    color::{Srgb, srgb_of_fill},
    languages::fixed,
    spectrum::Band,
    study::Measure,
};

/// The model against the measured spectrum behind the slit.
#[derive(Clone, Debug, PartialEq)]
pub struct BehindSlit {
    /// Rms of the difference, a share of the spectrum's own.
    pub off: f64,
    /// How large that is to an instrument.
    pub step: Seen,
}

impl BehindSlit {
    /// Of the present model; `None` where there is nothing to compare.
    pub fn of(app: &App) -> Option<Self> {
        let off = app.derived().figures[Measure::RmsBlurred]?;
        let step = Seen::of_slit(off);
        Some(Self { off, step })
    }

    /// "0.48", "< 0.01": per cent in the two digits that such a figure is read for.
    pub fn percent(&self) -> String {
        let percent = 100.0 * self.off;
        match percent < 0.01 {
            true => format!("< {}", fixed(0.01, 2)),
            false => two_digits(percent),
        }
    }
}

/// The colours of the visible part of the range, from the short wavelengths to the long, 1 nm apart:
/// as measured and by the model, each as bright as the light behind the slit, relative to the
/// brightest of the measured. Empty where nothing was measured or no wavelength is seen.
pub fn strip(app: &App) -> Vec<[Srgb; 2]> {
    let (derived, blur) = (app.derived(), &app.tables().blur);
    let measured = blur.values(&derived.measured);
    let mut model = blur.values(&derived.outline());
    blur.add_lines(&derived.ideal_spikes(), &mut model);
    let most = measured.iter().copied().fold(0.0, f64::max);
    if most <= 0.0 || !most.is_finite() {
        return Vec::new();
    }
    let seen = |nm: f64| (Band::VISIBLE.min_nm()..=Band::VISIBLE.max_nm()).contains(&nm);
    let both = derived.band.grid().zip(measured.iter().zip(&model));
    both.filter(|(nm, _)| seen(*nm))
        .map(|(nm, (measured, model))| {
            let colour = srgb_of_fill(nm).to_linear();
            [measured, model].map(|value| {
                let share = (value / most).clamp(0.0, 1.0);
                Srgb::from_linear(colour.map(|part| share * part))
            })
        })
        .collect()
}

/// What a model without lines loses, where the spectrum has lines that could be kept: to the eye, and
/// to an instrument. `None` where its lines are on or there are none.
pub fn without_lines(app: &App, left_out: &[f64]) -> Option<String> {
    if !app.derived().model.lines().is_empty() || left_out.is_empty() {
        return None;
    }
    let behind = BehindSlit::of(app)?;
    let worst = Worst::of(app)?;
    let share = behind.percent();
    Some(match (Seen::of(worst.delta_e_2000), behind.step) {
        (Seen::Hardly, Seen::Hardly) => tr!(
            "The eye hardly notices, and an instrument sees only {share} % of error behind a 10 \
             nm slit.",
            share
        ),
        (Seen::Hardly, _) => tr!(
            "The eye hardly notices, but an instrument sees {share} % of error behind a 10 nm \
             slit.",
            share
        ),
        (Seen::SideBySide, _) => tr!(
            "The eye notices only side by side; an instrument sees {share} % of error behind a 10 \
             nm slit.",
            share
        ),
        (Seen::Visible | Seen::Large, _) => tr!(
            "The eye notices, and an instrument sees {share} % of error behind a 10 nm slit.",
            share
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{Command, Settings, answers::line_shares, showing};

    fn fl2(threshold_percent: f64) -> App {
        let mut app = showing("cie_fluorescent_1nm/FL2");
        let settings = Settings {
            threshold_percent,
            ..app.document().settings
        };
        app.apply(Command::Edit(settings));
        app
    }

    #[test]
    fn without_its_lines_fl2_looks_alike_to_the_eye_and_not_to_an_instrument() {
        let with_lines = fl2(0.5);
        assert_eq!(with_lines.derived().model.lines().len(), 4);
        let behind = BehindSlit::of(&with_lines).expect("a light");
        assert_eq!(behind.step, Seen::Hardly, "{behind:?}");
        assert_eq!(without_lines(&with_lines, &line_shares(&with_lines)), None);
        let off = fl2(20.0);
        let behind = BehindSlit::of(&off).expect("a light");
        assert_eq!(behind.step, Seen::Large, "{behind:?}");
        let said = without_lines(&off, &line_shares(&off)).expect("lines are left out");
        // The sentence has the figure of the report.
        let figure = Measure::RmsBlurred.figure();
        let value = off.derived().figures[Measure::RmsBlurred].expect("an error");
        assert_eq!(
            said,
            format!(
                "The eye hardly notices, but an instrument sees {:.0} % of error behind a 10 nm slit.",
                figure.shown(value)
            )
        );
    }

    #[test]
    fn the_strip_shows_the_lines_of_the_lamp_and_of_a_model_that_keeps_them_alone() {
        let brightness = |Srgb(rgb): Srgb| rgb.map(u32::from).iter().sum::<u32>();
        // 435.8 nm: the brightest line of FL2, in a strip that begins at 380 nm.
        let at_line = 436 - 380;
        let [lamp, model] = strip(&fl2(0.5))[at_line].map(brightness);
        assert!(lamp.abs_diff(model) < 12, "{lamp} {model}");
        let [lamp, model] = strip(&fl2(20.0))[at_line].map(brightness);
        // The waves draw some of the line, about half of its light.
        assert!(lamp > model + 72, "{lamp} {model}");
        assert_eq!(strip(&fl2(0.5)).len(), 401);
    }
}
