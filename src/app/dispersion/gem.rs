//! The gem: which film is to be traced next, and what is said of it.
//!
//! A film holds transport and no light. A light that changes is summed anew over the film that is
//! there; only places of spikes that it has no rays for yet are traced.

mod words;

use std::sync::Arc;

use web_time::Instant;

use crate::{
    app::{
        memo::ByAddress,
        pages::{GemColour, GemMemory},
        state::App,
        studies::Question,
    },
    color::Observer,
    io::many::capitalised,
    optics::{
        Absorption, Brilliant, Film, FilmSettings, IndexError, Light, MOST_LINES, Material, Noise,
        Scene, Studio, View,
    },
    spectrum::Kind,
    study::Progress,
};

pub use words::{facts_of, noise_words, sentence};

/// Side of the first, quick picture, pixels, and its rays a pixel.
const QUICK: (usize, u32) = (96, 4);

/// Rays a pixel of the first picture of the size asked for.
const FIRST_RAYS: u32 = 2;

/// How wide the camera looks, degrees: the gem fills the picture.
const ANGLE_DEG: f64 = 15.0;

/// Places of spikes that only the second light has get one ray in so many of the light's.
const SHARE_OF_OTHERS: u32 = 8;

/// Most places of spikes that a film keeps: those of two lights with as many as get planes.
const MOST_PLACES: usize = 2 * MOST_LINES;

/// What the camera looks at.
#[derive(Clone, Debug, PartialEq)]
pub struct GemScene {
    material: Material,
    absorption: Absorption,
    cut: Brilliant,
    turn_deg: f64,
    height_deg: f64,
    size: usize,
}

/// A film so far: what it shows, the rays a pixel it has, and the places of spikes it has rays
/// for.
#[derive(Clone, Debug, PartialEq)]
pub struct GemPass {
    /// What is seen.
    pub scene: GemScene,
    /// Rays a pixel.
    pub rays: u32,
    /// Places of spikes, nm, rising.
    pub lines: Vec<f64>,
}

/// A film that was traced.
#[derive(Clone, Debug)]
pub struct GemFilm {
    pub film: Film,
    /// What it answers.
    pub pass: GemPass,
    /// How long all of it was traced, s.
    pub seconds: f64,
}

impl GemScene {
    /// As the page remembers it.
    ///
    /// # Errors
    /// Why there is no such gem, a sentence.
    pub fn of(app: &App, memory: &GemMemory) -> Result<Self, String> {
        let material = memory.made_of.material(app)?;
        // A film is for every light.
        let opaque = (380..=780).find_map(|nm| match material.index(f64::from(nm)) {
            Err(why @ IndexError::NotTransparent { .. }) => Some(why),
            _ => None,
        });
        if let Some(why) = opaque {
            return Err(capitalised(&tr!("{why}; the last gem stays.", why)));
        }
        let scene = Self {
            material,
            absorption: memory.absorption(app)?,
            cut: memory.cut,
            turn_deg: memory.turn_deg,
            height_deg: memory.height_deg,
            size: memory.size,
        };
        scene.studio()?;
        Ok(scene)
    }

    pub fn cut(&self) -> &Brilliant {
        &self.cut
    }

    /// The gem before the camera.
    ///
    /// # Errors
    /// Why there is no such gem, a sentence.
    pub fn studio(&self) -> Result<Studio, String> {
        let said =
            |why: &dyn std::fmt::Display| capitalised(&tr!("{why}; the last gem stays.", why));
        let solid = self.cut.solid().map_err(|why| said(&why))?;
        let usual = View::A;
        let off = |k: usize| usual.from[k] - usual.towards[k];
        let distance = off(0).hypot(off(1)).hypot(off(2));
        let (turn, height) = (self.turn_deg.to_radians(), self.height_deg.to_radians());
        let level = distance * height.cos();
        let from = [
            usual.towards[0] + level * turn.sin(),
            usual.towards[1] - level * turn.cos(),
            usual.towards[2] + distance * height.sin(),
        ];
        let scene = Scene {
            view: View {
                from,
                angle_deg: ANGLE_DEG,
                ..usual
            },
            ..Scene::jeweller()
        };
        let (material, absorption) = (self.material.clone(), self.absorption.clone());
        Studio::new(solid, material, absorption, scene).map_err(|why| said(&why))
    }

    /// The same in a picture of another size.
    fn sized(&self, size: usize) -> Self {
        Self {
            size,
            ..self.clone()
        }
    }

    /// Whether two scenes differ in the size of the picture alone.
    fn is_like(&self, other: &Self) -> bool {
        self.sized(other.size) == *other
    }
}

impl GemMemory {
    /// What of the light is lost on the way.
    ///
    /// # Errors
    /// A sentence where there is no such filter.
    pub fn absorption(&self, app: &App) -> Result<Absorption, String> {
        let said = |why: crate::optics::AbsorptionError| capitalised(&format!("{why}."));
        match self.colour {
            GemColour::Clear => Ok(Absorption::None),
            GemColour::Grey => Absorption::even(self.grey).map_err(said),
            GemColour::Filter => {
                let entry = app.entry(&self.filter);
                let filter = entry.filter(|entry| entry.kind() == Kind::Transmittance);
                let filter = filter.ok_or_else(|| {
                    said!("The filter that colours the gem is not open: choose another one.")
                        .to_owned()
                })?;
                Absorption::of_filter(&filter.spectrum.samples, self.thickness).map_err(said)
            }
        }
    }
}

/// The film to trace next, so that the picture grows finer: a small one at once, then the whole
/// size with twice the rays each time; `None` where all is there. At once all rays where `whole`.
pub fn next_pass(
    held: Option<&GemPass>,
    scene: &GemScene,
    rays: u32,
    lines: &[f64],
    whole: bool,
) -> Option<GemPass> {
    let pass = |scene: GemScene, rays: u32| GemPass {
        scene,
        rays,
        lines: lines.to_vec(),
    };
    match held {
        Some(held) if held.scene == *scene => {
            let mut all = held.lines.clone();
            all.extend(lines);
            all.sort_by(f64::total_cmp);
            all.dedup();
            if all.len() > MOST_PLACES {
                // Places of lights long gone: a fresh film forgets them.
                return Some(pass(scene.clone(), held.rays));
            }
            let rays = (2 * held.rays).min(rays).max(held.rays);
            let next = GemPass {
                lines: all,
                rays,
                ..held.clone()
            };
            (next != *held).then_some(next)
        }
        _ if whole => Some(pass(scene.clone(), rays)),
        Some(held) if held.scene.is_like(scene) => Some(pass(scene.clone(), FIRST_RAYS.min(rays))),
        _ => Some(pass(scene.sized(QUICK.0), QUICK.1)),
    }
}

impl GemPass {
    /// Traces what is missing of it, rays shared for the first light; `None` when it was cancelled
    /// or there is no such gem.
    pub fn trace(
        &self,
        from: Option<Arc<GemFilm>>,
        lights: &[Light],
        progress: &Progress,
    ) -> Option<GemFilm> {
        let from = from.filter(|from| self.goes_on_from(&from.pass));
        let start = Instant::now();
        let (before, seconds) = from
            .as_ref()
            .map_or((0, 0.0), |from| (from.pass.rays, from.seconds));
        let mut film = match from {
            Some(from) => from.film.clone(),
            None => {
                let settings = FilmSettings {
                    size: self.scene.size,
                    ..FilmSettings::default()
                };
                Film::new(self.scene.studio().ok()?, settings).ok()?
            }
        };
        let (first, others) = lights.split_first()?;
        let more = self.rays.saturating_sub(before);
        if more > 0 {
            film.trace(first, more, None, progress).ok()?;
        }
        let own = places(first);
        let missing = film.missing_lines(first);
        let apart = others
            .iter()
            .flat_map(places)
            .filter(|nm| !own.contains(nm));
        let mut apart: Vec<f64> = apart.collect();
        apart.sort_by(f64::total_cmp);
        apart.dedup();
        let (new, old): (Vec<f64>, Vec<f64>) = apart.into_iter().partition(|nm| {
            others
                .iter()
                .any(|light| film.missing_lines(light).contains(nm))
        });
        // What is new catches up, what is there grows as the rest does.
        let new = [missing, new].concat();
        for (lines, rays) in [(new, self.rays), (old, more)] {
            if !lines.is_empty() && rays > 0 {
                let rays = rays.div_ceil(SHARE_OF_OTHERS);
                film.trace_lines(&lines, rays, None, progress).ok()?;
            }
        }
        Some(GemFilm {
            film,
            pass: self.clone(),
            seconds: seconds + start.elapsed().as_secs_f64(),
        })
    }

    /// Whether a film of another pass is a part of this one's.
    fn goes_on_from(&self, other: &Self) -> bool {
        let has = |nm: &f64| self.lines.contains(nm);
        other.scene == self.scene && other.lines.iter().all(has)
    }

    /// Whether it is of this scene in whatever size.
    pub fn is_of(&self, scene: &GemScene) -> bool {
        self.scene.is_like(scene)
    }

    /// Whether it is the first, quick picture.
    pub fn is_quick(&self) -> bool {
        self.scene.size == QUICK.0
    }
}

/// Places of the spikes of a light that get rays of their own, nm.
pub fn places(light: &Light) -> Vec<f64> {
    Film::lines_of(light)
        .iter()
        .map(|spike| spike.at_nm)
        .collect()
}

/// What the noise of a picture depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseAsk {
    pub film: ByAddress<GemFilm>,
    pub light: Light,
    /// Who looks.
    pub observer: Observer,
}

impl Question for NoiseAsk {
    type Answer = Noise;

    /// The answer; `None` before two rays a pixel.
    fn answer(&self, _: &Progress) -> Option<Noise> {
        self.film.0.film.noise(&self.light, self.observer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{
        App, Command, Settings, assert_says,
        dispersion::{Sent, document_light},
    };

    fn small() -> GemMemory {
        GemMemory {
            size: 240,
            rays: 8,
            ..GemMemory::default()
        }
    }

    fn scene() -> GemScene {
        GemScene::of(&App::new(), &small()).expect("a gem")
    }

    #[test]
    fn the_picture_grows_finer_and_then_rests() {
        let scene = scene();
        let (mut held, mut steps) = (None, Vec::new());
        while let Some(next) = next_pass(held.as_ref(), &scene, 8, &[546.1], false) {
            steps.push((next.scene.size, next.rays));
            held = Some(next);
        }
        assert_eq!(steps, [(96, 4), (240, 2), (240, 4), (240, 8)]);
        let whole = next_pass(None, &scene, 8, &[], true).expect("nothing is there yet");
        assert_eq!((whole.scene.size, whole.rays), (240, 8));
    }

    #[test]
    fn another_light_asks_for_its_new_lines_alone() {
        let scene = scene();
        let held = next_pass(None, &scene, 8, &[546.1], true).expect("a film");
        let next = next_pass(Some(&held), &scene, 8, &[435.8, 546.1], true).expect("a line");
        assert_eq!((next.rays, next.lines.as_slice()), (8, &[435.8, 546.1][..]));
        assert_eq!(next_pass(Some(&next), &scene, 8, &[546.1], true), None);
        // Fewer rays asked for: what is there stays.
        assert_eq!(next_pass(Some(&next), &scene, 4, &[546.1], true), None);
    }

    #[test]
    fn a_film_forgets_the_lines_of_lights_long_gone() {
        let scene = scene();
        let mut held = next_pass(None, &scene, 8, &[546.1], true).expect("a film");
        held.lines = (0..MOST_PLACES).map(|i| 400.0 + i as f64).collect();
        let next = next_pass(Some(&held), &scene, 8, &[435.8], true).expect("a line");
        assert_eq!(next.lines, [435.8]);
        assert!(!next.goes_on_from(&held) && next.goes_on_from(&next));
    }

    #[test]
    fn a_light_that_changes_is_summed_anew_over_the_same_film() {
        let mut app = App::new();
        let scene = scene().sized(16);
        let light = document_light(&app, Sent::Model).expect("it shines");
        let pass = next_pass(None, &scene, 2, &places(&light), true).expect("a film");
        let film = pass
            .trace(None, std::slice::from_ref(&light), &Progress::default())
            .expect("traced");
        assert!(film.film.missing_lines(&light).is_empty());
        app.apply(Command::Edit(Settings {
            order: 3,
            ..app.document().settings
        }));
        let other = document_light(&app, Sent::Model).expect("it shines");
        assert!(film.film.missing_lines(&other).is_empty());
        assert_eq!(
            next_pass(Some(&film.pass), &scene, 2, &places(&other), true),
            None
        );
        let observer = Observer::default();
        let pictures = [&light, &other].map(|light| film.film.picture(light, observer));
        assert!(pictures[0] != pictures[1]);
    }

    #[test]
    fn a_cut_that_is_none_says_which_facets_vanish() {
        let app = App::new();
        let mut memory = small();
        memory.cut.table = 0.85;
        memory.cut.crown_deg = 20.0;
        memory.cut.star = 0.2;
        let why = GemScene::of(&app, &memory).expect_err("no table");
        assert_eq!(
            why,
            "The table vanishes with this table and crown; the last gem stays."
        );
        memory.cut.crown_deg = f64::NAN;
        let why = GemScene::of(&app, &memory).expect_err("no angle");
        assert!(why.ends_with("the last gem stays."), "{why}");
    }

    #[test]
    fn a_filter_colours_the_gem_and_a_lost_one_is_said() {
        let app = App::new();
        let of = |colour: GemColour| GemMemory { colour, ..small() };
        let clear = scene();
        let coloured = GemScene::of(&app, &of(GemColour::Filter)).expect("a gem");
        assert!(coloured != clear && !coloured.is_like(&clear));
        let loss = |nm: f64| coloured.absorption.at(nm);
        // Green glass takes red away.
        assert!(loss(650.0) > 3.0 * loss(530.0));
        let grey = of(GemColour::Grey).absorption(&app);
        assert_eq!(grey, Ok(Absorption::Even(0.1)));
        let lost = GemMemory {
            filter: "cie_illuminants/CIE D65".to_owned(),
            ..of(GemColour::Filter)
        };
        assert_says(
            &lost.absorption(&app).expect_err("a light"),
            "choose another",
        );
    }
}
