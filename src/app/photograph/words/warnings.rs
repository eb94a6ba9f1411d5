//! What is to be known of a photograph before it is believed.

use super::super::{Exposed, Fit, Photograph, Source};
use crate::{
    languages::{fixed, said},
    photographs::axis::Pin,
};

/// What is to be known of a photograph before it is believed.
pub fn warnings(photograph: &Photograph) -> Vec<String> {
    let found = &photograph.found;
    let mut warnings: Vec<String> = photograph
        .notes
        .iter()
        .map(|&note| said(note).to_owned())
        .collect();
    if found.strips > 1 && !photograph.by_hand {
        warnings.push(match found.strips {
            2 => said!("two strips were found, the stronger is read").to_owned(),
            count => tr!("{count} strips were found, the strongest is read", count),
        });
    }
    if found.profile.is_grey {
        warnings.push(
            said!(
                "the strip is grey: no colours to check the axis by, so only a sure match counts"
            )
            .to_owned(),
        );
    }
    if !found.profile.black_seen {
        warnings.push(said!("black level not seen").to_owned());
    }
    let columns = found.profile.columns();
    let clipped = found.profile.clipped_columns();
    if 10 * clipped > columns {
        warnings.push(tr!(
            "{share} % of the columns are clipped",
            share = 100 * clipped / columns
        ));
    }
    let peaks = &photograph.peaks().peaks;
    let of_lines = peaks.iter().filter(|p| p.is_clipped).count();
    if of_lines > 0 {
        warnings.push(tr!("{n} line is clipped: its height is not known"
            | "{n} lines are clipped: their height is not known" % of_lines));
    }
    if photograph.bright.hairlines > 0 {
        let count = photograph.bright.hairlines;
        warnings.push(tr!(
            "{n} thin drawn line was ignored" | "{n} thin drawn lines were ignored" % count
        ));
    }
    warnings.extend(of_axis(photograph));
    warnings.extend(of_light(photograph));
    warnings
}

/// What is to be known of its axis.
fn of_axis(photograph: &Photograph) -> Vec<String> {
    let mut warnings = Vec::new();
    // Beside an instrument or pins it does not matter what the lines alone would say.
    if matches!(
        photograph.source(),
        Source::Found | Source::Suggested | Source::Nothing
    ) && photograph.instrument.is_none()
    {
        warnings.extend(photograph.answer.as_ref().and_then(|a| a.why.clone()));
    }
    if let Some(Fit::No(why)) = photograph.instrument.as_ref().map(|i| &i.fit) {
        warnings.push(why.clone());
    }
    warnings.extend(photograph.pins_refused.clone());
    if let Some(exposed) = &photograph.exposed {
        warnings.extend(of_exposures(exposed));
    }
    if photograph.pins.iter().any(is_a_laser_diode) {
        warnings.push(said!("laser diodes are off by up to 10 nm").to_owned());
    }
    warnings
}

/// What is to be known of its light.
fn of_light(photograph: &Photograph) -> Vec<String> {
    let mut warnings = Vec::new();
    let tone_p = photograph.through.as_ref().map_or(1.0, |t| t.tone_p);
    if tone_p != 1.0 {
        warnings.push(tr!(
            "this camera bends its tones; undone (p = {power})",
            power = fixed(tone_p, 1)
        ));
    }
    let reach = photograph.valid_nm().zip(photograph.reach_nm());
    if let (Some(Ok(_)), Some((valid, reach))) = (&photograph.figures, reach)
        && (reach.0 < valid.0 || reach.1 > valid.1)
    {
        warnings.push(tr!(
            "the figures use the axis from {used_from} to {used_to} nm, its lines fix it from \
             {fixed_from} to {fixed_to}",
            used_from = fixed(reach.0, 0),
            used_to = fixed(reach.1, 0),
            fixed_from = fixed(valid.0, 0),
            fixed_to = fixed(valid.1, 0)
        ));
    }
    if let Some(Err(why)) = &photograph.figures {
        warnings.push(why.clone());
    }
    if photograph.source() == Source::Pins && photograph.pins.len() == 2 {
        warnings.push(said!("two points: 1-8 nm wrong between grating and line").to_owned());
    }
    warnings
}

/// What several exposures told.
fn of_exposures(exposed: &Exposed) -> Vec<String> {
    let mut words = Vec::new();
    if exposed.light_power != 1.0 {
        words.push(tr!(
            "this camera's values go with the light to the power {power}; undone",
            power = fixed(exposed.light_power, 2)
        ));
    }
    if exposed.is_uneven {
        words.push(
            said!(
                "bright columns change by another factor between the exposures than dark ones: \
                 the camera's tones are no power of the light"
            )
            .to_owned(),
        );
    }
    if !exposed.joined.is_empty() {
        let count = exposed.joined.len();
        words.push(tr!("{n} column is from a darker exposure"
            | "{n} columns are from a darker exposure" % count));
    }
    words
}

/// A pin at what a laser diode is called by; 532.0 and 632.8 are of other lasers, which keep to it.
fn is_a_laser_diode(pin: &Pin) -> bool {
    [405.0, 450.0, 520.0, 635.0, 650.0].contains(&pin.nm)
}
