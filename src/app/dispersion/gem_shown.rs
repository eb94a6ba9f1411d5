//! A film under a light as the page shows it: which part of the light, how bright, to which eye.

use super::gem::GemFilm;
use crate::{
    app::pages::LightPart,
    color::{Adaptation, Observer},
    languages::fixed,
    optics::Light,
};

/// How a picture is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GemLook {
    /// Who looks.
    pub observer: Observer,
    /// Exposure, stops.
    pub stops: f64,
    /// What the eye is used to.
    pub adaptation: Adaptation,
    /// Which part of the light is shown.
    pub part: LightPart,
}

/// A picture for the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct GemShown {
    /// Side, pixels.
    pub size: usize,
    /// Pixels, row after row from the top.
    pub pixels: Vec<[u8; 3]>,
    /// How it is to be understood.
    pub words: String,
}

impl GemShown {
    /// Of a film under a light. A part of the light is shown as bright as it is in the whole.
    ///
    /// # Errors
    /// A sentence where the light has no such part.
    pub fn of(film: &GemFilm, light: &Light, look: GemLook) -> Result<Self, String> {
        let part = match look.part {
            LightPart::Whole => None,
            LightPart::Lines => {
                let lines = light.lines_alone();
                Some(lines.ok_or_else(|| tr!("{light} has no line.", light = light.name))?)
            }
            LightPart::Smooth => {
                let smooth = light.smooth_alone();
                Some(smooth.ok_or_else(|| tr!("{light} has no smooth part.", light = light.name))?)
            }
        };
        let whole = film.film.picture(light, look.observer);
        let adapted = match look.adaptation {
            Adaptation::None => None,
            Adaptation::ToLight => whole.adapted(),
        };
        let camera = Adaptation::None.words();
        let seen = match (look.adaptation, &adapted) {
            (Adaptation::ToLight, None) => {
                tr!("{camera}: no eye adapts to so narrow a light", camera)
            }
            (adaptation, _) => adaptation.words().to_owned(),
        };
        let whole = adapted.unwrap_or(whole);
        let gain = whole.automatic_gain() * look.stops.exp2();
        let shown = match part {
            None => whole.shown_with(gain),
            Some(part) => {
                let mut picture = film.film.picture(&part, look.observer);
                picture.white = light.white(look.observer);
                let picture = match look.adaptation {
                    Adaptation::None => picture,
                    Adaptation::ToLight => picture.adapted().unwrap_or(picture),
                };
                picture.shown_with(gain)
            }
        };
        let words = tr!(
            "{seen}; of the picture {brighter} % is brighter and {purer} % purer than a screen \
             can show",
            seen,
            brighter = fixed(100.0 * shown.share_too_bright, 1),
            purer = fixed(100.0 * shown.share_outside, 1)
        );
        Ok(Self {
            size: whole.size,
            pixels: shown.pixels,
            words,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{
            App, assert_says,
            dispersion::{GemScene, Sent, document_light, next_pass, places},
            pages::GemMemory,
        },
        spectrum::{Band, Line},
        study::Progress,
    };

    fn film(app: &App, light: &Light) -> GemFilm {
        let memory = GemMemory {
            size: 32,
            ..GemMemory::default()
        };
        let scene = GemScene::of(app, &memory).expect("a gem");
        let pass = next_pass(None, &scene, 64, &places(light), true).expect("a film");
        let lights = std::slice::from_ref(light);
        pass.trace(None, lights, &Progress::default())
            .expect("traced")
    }

    fn look(adaptation: Adaptation, part: LightPart) -> GemLook {
        GemLook {
            observer: Observer::default(),
            stops: 0.0,
            adaptation,
            part,
        }
    }

    #[test]
    fn to_the_eye_a_tube_is_white_and_to_a_camera_it_is_not() {
        let app = App::new();
        let light = document_light(&app, Sent::Measured).expect("FL2 shines");
        let film = film(&app, &light);
        // The first pixel sees the dome alone: the light itself, dim.
        let first = |adaptation| {
            let shown = GemShown::of(&film, &light, look(adaptation, LightPart::Whole));
            let GemShown { words, pixels, .. } = shown.expect("a picture");
            assert!(words.starts_with(adaptation.words()), "{words}");
            pixels[0]
        };
        let [r, g, b] = first(Adaptation::ToLight);
        assert!(r.abs_diff(g) < 4 && b.abs_diff(g) < 4, "{r} {g} {b}");
        let [r, _, b] = first(Adaptation::None);
        assert!(r > b + 10, "{r} {b}");
    }

    #[test]
    fn both_parts_are_darker_than_the_whole_and_a_missing_one_is_said() {
        let app = App::new();
        let light = document_light(&app, Sent::Measured).expect("FL2 shines");
        let film = film(&app, &light);
        let level = |part| {
            let shown = GemShown::of(&film, &light, look(Adaptation::ToLight, part));
            let pixels = shown.expect("FL2 has both").pixels;
            let channels = pixels.iter().flatten();
            channels.map(|v| u32::from(*v)).sum::<u32>()
        };
        let [whole, lines, smooth] = LightPart::ALL.map(level);
        assert!(lines < smooth && smooth < whole, "{lines} {smooth} {whole}");
        let flat = Light::new("flat", Band::VISIBLE, vec![1.0; 401], Vec::new()).expect("a light");
        let none = GemShown::of(&film, &flat, look(Adaptation::None, LightPart::Lines));
        assert_eq!(none, Err("flat has no line.".to_owned()));
    }

    #[test]
    fn a_light_too_narrow_to_adapt_to_is_shown_as_it_is() {
        let app = App::new();
        let spike = Line::ideal(589.3, 1.0);
        let dark = vec![0.0; 401];
        let sodium = Light::new("sodium", Band::VISIBLE, dark, vec![spike]).expect("a light");
        let film = film(&app, &sodium);
        let shown = |adaptation| {
            GemShown::of(&film, &sodium, look(adaptation, LightPart::Whole)).expect("a picture")
        };
        let (eye, camera) = (shown(Adaptation::ToLight), shown(Adaptation::None));
        assert_eq!(eye.pixels, camera.pixels);
        assert_says(&eye.words, "no eye adapts");
    }
}
