//! Jumps of a stream in words.

use crate::{
    app::{
        combining::words::{change_words, part_name},
        readings::names_of_lines,
    },
    live::{Jump, clock},
    measurements::{Feature, Part},
    spectrum::Sampled,
};

/// Most parts of a jump that are named.
const MOST_PARTS: usize = 4;

/// A level that rises or falls by so large a factor is a light that comes or goes.
const COMES: f64 = 50.0;

/// `0:05:12.0: Hg 546.1 +12 ± 2 %, glow -3 ± 1 %`; `light` names the lines.
pub fn jump_words(jump: &Jump, light: Option<&Sampled>) -> String {
    let place = |part: &Part| match part.feature {
        Feature::Line(at) => Some(at),
        _ => None,
    };
    let parts: Vec<&Part> = jump.parts.iter().take(MOST_PARTS).collect();
    let places: Vec<f64> = parts.iter().filter_map(|part| place(part)).collect();
    let names = light.map(|light| names_of_lines(light, &places));
    let mut names = names.unwrap_or_default().into_iter();
    let words = parts.into_iter().map(|part| {
        let name = place(part).and_then(|_| names.next().flatten());
        match part.feature {
            Feature::Level if part.change > COMES => said!("the light comes on").to_owned(),
            Feature::Level if part.change < 1.0 / COMES - 1.0 => {
                said!("the light goes out").to_owned()
            }
            _ => format!(
                "{} {}",
                part_name(part, name.as_deref()),
                change_words(part)
            ),
        }
    });
    let words: Vec<String> = words.collect();
    crate::languages::with_colon(clock(jump.time_ms), words.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_jump_is_told_with_its_time_its_parts_and_their_doubt() {
        let part = |feature, change, u| Part {
            feature,
            change,
            u,
            p: 1e-9,
            is_different: true,
        };
        let jump = |parts| Jump {
            time_ms: 312_000.0,
            parts,
        };
        let of_line = vec![
            part(Feature::Line(546.1), 0.12, 0.01),
            part(Feature::Glow, -0.031, 0.005),
        ];
        assert_eq!(
            jump_words(&jump(of_line), None),
            "0:05:12.0: line 546.1 +12.0 \u{b1} 2.0 %, glow -3.1 \u{b1} 1.0 %"
        );
        let on = jump(vec![part(Feature::Level, 900.0, 9.0)]);
        assert_eq!(jump_words(&on, None), "0:05:12.0: the light comes on");
        let out = jump(vec![part(Feature::Level, -0.999, 1e-5)]);
        assert_eq!(jump_words(&out, None), "0:05:12.0: the light goes out");
    }
}
