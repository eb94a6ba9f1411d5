//! Sentences with figures in them: `{ra}` of what is shown, `{ra of model}`, `{ra of FL11}`.

use super::{
    figures::{figure, is_known_of},
    scene::Scene,
};

/// A part of a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Part<'a> {
    Words(&'a str),
    Figure { key: &'a str, of: Option<&'a str> },
}

fn parts(text: &str) -> Result<Vec<Part<'_>>, String> {
    let (mut parts, mut rest) = (Vec::new(), text);
    while let Some((before, after)) = rest.split_once('{') {
        let Some((inside, behind)) = after.split_once('}') else {
            return Err(format!("found {{ without }} in \"{text}\", expected both"));
        };
        parts.push(Part::Words(before));
        let (key, of) = match inside.split_once(" of ") {
            Some((key, of)) => (key, Some(of.trim())),
            None => (inside, None),
        };
        parts.push(Part::Figure {
            key: key.trim(),
            of,
        });
        rest = behind;
    }
    parts.push(Part::Words(rest));
    Ok(parts)
}

/// The text with each figure's present value in its place.
///
/// # Errors
/// What was found and what was expected: an unknown figure or light, a brace that is open.
pub(super) fn filled(text: &str, scene: &Scene<'_>) -> Result<String, String> {
    let mut filled = String::new();
    for part in parts(text)? {
        match part {
            Part::Words(words) => filled.push_str(words),
            Part::Figure { key, of } => filled.push_str(&figure(scene, key, of)?.words),
        }
    }
    Ok(filled)
}

/// What is wrong with a text's figures; `made` are the names of spectra that the lesson makes.
///
/// # Errors
/// As [`filled`].
pub(super) fn fault(text: &str, made: &[&str]) -> Result<(), String> {
    for part in parts(text)? {
        if let Part::Figure { key, of } = part {
            is_known_of(key, of, made)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{App, pages::Page};

    #[test]
    fn figures_stand_where_their_keys_stood() {
        let app = App::new();
        let scene = Scene {
            app: &app,
            page: Page::Spectrum,
        };
        let words = filled("Order {order}, {numbers} numbers; {cct of CIE A}.", &scene);
        let numbers = app.derived().numbers();
        assert_eq!(words, Ok(format!("Order 7, {numbers} numbers; 2860 K.")));
        for wrong in ["{nothing}", "{ra of FL99}", "{ra"] {
            assert!(filled(wrong, &scene).is_err(), "{wrong}");
            assert!(fault(wrong, &[]).is_err(), "{wrong}");
        }
        assert_eq!(fault("{ra of Mine}", &["Mine"]), Ok(()));
    }
}
