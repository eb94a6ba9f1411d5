//! What is wished of a mixture, and the faders for it.

use super::{
    desk::{Desk, words},
    mix::Mix,
};
use crate::{
    app::{document::Document, make::table_of, pages::states::in_reach, state::App},
    color::{
        Swatch, Xyz,
        quality::diagram::xy_from_uv_1976,
        xyz::{FIRST_NM, LAST_NM},
    },
    design::{
        SampleTables,
        mixture::{Channel, MixError},
        solve::{Care, Mixer, Problem, Solution, Target},
    },
    languages::{fixed, with_sign},
    spectrum::Outside,
};

pub use crate::app::pages::MixWish;

impl MixWish {
    /// The colour.
    ///
    /// # Errors
    /// Why there is none, a sentence.
    pub fn target(&self, document: &Document) -> Result<Target, String> {
        let refused = |why: MixError| tr!("No such colour: {why}.", why);
        let Some(key) = &self.light else {
            return match self.xy {
                Some(xy) => Target::of_xy(xy),
                None => Target::of_kelvin(self.kelvin, self.duv),
            }
            .map_err(refused);
        };
        let table = table_of(document, key);
        let table = table.ok_or_else(|| tr!("The library has no light {key} any more.", key))?;
        Target::of_light(&table).map_err(refused)
    }

    /// The same wish told by x and y: those of what it was, to four digits.
    #[must_use]
    pub fn by_xy(self, document: &Document) -> Self {
        let xy = self.target(document).map_or([1.0 / 3.0; 2], Target::xy);
        let xy = xy.map(|v| (1e4 * v).round() / 1e4);
        Self {
            light: None,
            xy: Some(xy),
            ..self
        }
    }

    /// The same wish for the colour at a place of CIE 1976 u'v'.
    #[must_use]
    pub fn at_uv(self, uv: [f64; 2]) -> Self {
        in_reach(Self {
            light: None,
            xy: Some(xy_from_uv_1976(uv)),
            ..self
        })
    }

    pub fn colour_words(&self, document: &Document) -> String {
        match (&self.light, self.xy) {
            (Some(key), _) => document.name_of(key),
            (None, Some([x, y])) => format!("x {}, y {}", fixed(x, 4), fixed(y, 4)),
            (None, None) if self.duv == 0.0 => format!("{:.0} K", self.kelvin),
            (None, None) => format!(
                "{} K, Duv {}",
                fixed(self.kelvin, 0),
                with_sign(format!("{:+.4}", self.duv))
            ),
        }
    }
}

/// The faders that a wish asks for.
#[derive(Clone, Debug)]
pub struct Solved {
    /// The colour asked for, CIE 1976 u'v'.
    pub target_uv: [f64; 2],
    /// The desk with its faders so.
    pub mix: Mix,
    /// The colour of what was solved for, where `target_uv` is that asked for.
    pub swatch: Swatch,
    /// Whether the colour and the floors are met.
    pub reached: bool,
    /// The result in a sentence.
    pub sentence: String,
}

impl Solved {
    /// Solves for the faders of a desk: those that are locked stay, those that are silent stay so.
    ///
    /// # Errors
    /// Why nothing can be solved for, a sentence.
    pub fn of(
        wish: &MixWish,
        desk: &Desk,
        document: &Document,
        care: Care,
    ) -> Result<Self, String> {
        let target = wish.target(document)?;
        let heard = desk.heard();
        let channels: Vec<Channel> = heard
            .iter()
            .map(|(index, channel)| {
                let strip = &desk.mix.channels[*index];
                let mut channel = (*channel).clone();
                channel.spec.fixed = strip.lock.then_some(strip.level);
                channel
            })
            .collect();
        let mixer = Mixer::new(&channels, SampleTables::shipped()).map_err(|_| {
            said!("There is no channel to solve with: add some on the page Mix.").to_owned()
        })?;
        let alike = wish.light.as_ref().filter(|_| wish.alike);
        let alike = alike.and_then(|key| table_of(document, key));
        let alike = alike.map(|light| light.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero));
        let solution = mixer.solve(&Problem {
            target: Some(target),
            objective: wish.favour,
            floors: wish.floors,
            alike: alike.as_deref(),
            care,
        });
        let mut powers = vec![0.0; desk.mix.channels.len()];
        for ((index, _), weight) in heard.iter().zip(&solution.weights) {
            powers[*index] = *weight;
        }
        let mut mix = desk.mix.clone().at_powers(&powers);
        mix.settle();
        Ok(Self {
            target_uv: target.uv(),
            mix,
            swatch: Swatch::of_light(solution.figures.xyz.unwrap_or(Xyz::ZERO)),
            reached: solution.reached,
            sentence: told(&wish.colour_words(document), &solution),
        })
    }
}

/// The answer to a wish, solved for once: neither a press that moves nothing nor faders that follow
/// the answer ask for it again.
#[derive(Debug, Default)]
pub struct Answered {
    held: Option<Held>,
    solves: usize,
}

/// An answer with all that it depends on.
#[derive(Debug)]
struct Held {
    revision: u64,
    wish: MixWish,
    care: Care,
    found: Result<Solved, String>,
    /// The faders are being set to it, which is the next revision.
    is_followed: bool,
}

impl Held {
    fn answers(&self, app: &App, wish: &MixWish, mix: &Mix, care: Care) -> bool {
        let is_careful = self.care == Care::Full || care == Care::Quick;
        let (revision, now) = (self.revision, app.changes());
        let stands_so = || self.found.as_ref().is_ok_and(|found| found.mix == *mix);
        let is_followed = self.is_followed && now == revision + 1 && stands_so();
        is_careful && self.wish.asks_as(wish) && (now == revision || is_followed)
    }
}

impl Answered {
    /// The answer for the desk of the program; `care`: how a new one is looked for.
    ///
    /// # Errors
    /// Why nothing can be solved for, a sentence.
    pub fn get(
        &mut self,
        app: &App,
        wish: &MixWish,
        desk: &Desk,
        care: Care,
    ) -> &Result<Solved, String> {
        let revision = app.changes();
        let held = self.held.take();
        let held = held.filter(|held| held.answers(app, wish, &desk.mix, care));
        let held = match held {
            Some(held) => Held {
                is_followed: held.is_followed && held.revision == revision,
                revision,
                ..held
            },
            None => {
                self.solves += 1;
                Held {
                    revision,
                    wish: wish.clone(),
                    care,
                    found: Solved::of(wish, desk, app.document(), care),
                    is_followed: false,
                }
            }
        };
        &self.held.insert(held).found
    }

    /// How often it was solved.
    pub fn solves(&self) -> usize {
        self.solves
    }

    /// The desk that is to be set for the faders to stand as the answer has them; `None` where they
    /// do, or where there is no answer.
    pub fn follow(&mut self, mix: &Mix) -> Option<Mix> {
        let held = self.held.as_mut()?;
        let found = held.found.as_ref().ok()?;
        held.is_followed = found.mix != *mix;
        held.is_followed.then(|| found.mix.clone())
    }
}

fn told(asked: &str, solution: &Solution) -> String {
    let found = words(&solution.figures, None);
    match (solution.reached, solution.delta_uv_to_target) {
        (true, _) => tr!(
            "These channels can make the colour of {asked} exactly. {found}",
            asked,
            found
        ),
        (false, Some(off)) if off < 1e-6 => tr!(
            "The colour of {asked} is met, the floors are not: {why}. {found}",
            asked,
            why = solution.why,
            found
        ),
        _ => tr!(
            "The colour of {asked} is not met: {why}. {found}",
            asked,
            why = solution.why,
            found
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{
            assert_says,
            design::{desk::put_on_desk, mix::MixChannel},
            pages::states::in_reach,
        },
        design::{mixture::Source, solve::Floors},
    };

    fn tried(app: &App, wish: &MixWish) -> Result<Solved, String> {
        Solved::of(wish, &Desk::of(app.document()), app.document(), Care::Full)
    }

    fn solved(app: &App, wish: &MixWish) -> Solved {
        tried(app, wish).expect("channels and a colour")
    }

    #[test]
    fn the_faders_make_the_colour_that_is_wished_for() {
        let mut app = App::new();
        for kelvin in [2700.0, 4000.0, 6500.0] {
            let wish = MixWish {
                kelvin,
                ..MixWish::default()
            };
            let found = solved(&app, &wish);
            assert!(found.reached, "{}", found.sentence);
            let figures = put_on_desk(&mut app, found.mix).figures;
            let [u, v] = figures.and_then(|f| f.uv).expect("it shines");
            let off = (u - found.target_uv[0]).hypot(v - found.target_uv[1]);
            assert!(off < 1e-6, "{off}");
            // What is shown as solved for is what the desk then shows.
            let shown = Desk::of(app.document()).swatch();
            assert_eq!(found.swatch.hex(), shown.hex());
            // Solving again changes nothing.
            assert_eq!(solved(&app, &wish).mix, app.document().pages.mix.desk);
        }
    }

    #[test]
    fn a_press_solves_once_whether_it_moves_anything_and_whether_the_faders_follow() {
        let mut app = App::new();
        let mut answered = Answered::default();
        let ask = |answered: &mut Answered, app: &App, wish: &MixWish, care: Care| {
            let desk = Desk::of(app.document());
            let found = answered.get(app, wish, &desk, care).clone();
            found.expect("channels and a colour").mix
        };
        let wish = MixWish::default();
        let found = ask(&mut answered, &app, &wish, Care::Full);
        // The pointer goes down and up; the front is asked for more lines.
        ask(&mut answered, &app, &wish, Care::Quick);
        let lines = MixWish {
            lines: 4,
            ..wish.clone()
        };
        assert_eq!(ask(&mut answered, &app, &lines, Care::Full), found);
        assert_eq!(answered.solves(), 1);
        // The faders are set to it.
        let followed = answered.follow(&app.document().pages.mix.desk);
        assert_eq!(followed.as_ref(), Some(&found));
        put_on_desk(&mut app, found.clone());
        for _ in 0..2 {
            assert_eq!(ask(&mut answered, &app, &wish, Care::Full), found);
        }
        assert_eq!(answered.solves(), 1);
        assert_eq!(answered.follow(&found), None);
        // What is dragged gets a first answer, and one more when it is let go.
        let warm = MixWish {
            kelvin: 3000.0,
            ..wish
        };
        for care in [Care::Quick, Care::Quick, Care::Full, Care::Full] {
            ask(&mut answered, &app, &warm, care);
        }
        assert_eq!(answered.solves(), 3);
        // Another desk is another question.
        let mut mix = app.document().pages.mix.desk.clone();
        mix.channels[0].level *= 0.5;
        put_on_desk(&mut app, mix);
        ask(&mut answered, &app, &warm, Care::Full);
        assert_eq!(answered.solves(), 4);
    }

    #[test]
    fn a_chromaticity_can_be_wished_for_and_begins_with_that_of_the_temperature() {
        let mut app = App::new();
        let warm = MixWish {
            kelvin: 3000.0,
            ..MixWish::default()
        };
        let by_xy = in_reach(warm.by_xy(app.document()));
        let [x, y] = by_xy.xy.expect("x and y");
        let off = [(x - 0.4369).abs(), (y - 0.4041).abs()];
        assert!(off.iter().all(|off| *off < 2e-4), "{x} {y}");
        let found = solved(&app, &by_xy);
        assert_says(&found.sentence, &format!("x {x:.4}, y {y:.4}"));
        let figures = put_on_desk(&mut app, found.mix).figures.expect("it shines");
        let [a, b] = figures.xy.expect("a colour");
        assert!((a - x).hypot(b - y) < 1e-6, "{a} {b}");
        // What is no chromaticity says so; a light goes before x and y.
        let odd = MixWish {
            xy: Some([0.9, 0.9]),
            ..MixWish::default()
        };
        let why = tried(&app, &odd).expect_err("no colour");
        assert_says(&why, "x + y");
        let light = MixWish {
            light: Some("cie_illuminants/CIE A".to_owned()),
            xy: Some([f64::NAN, 0.3]),
            ..MixWish::default()
        };
        let light = in_reach(light);
        assert_eq!(light.colour_words(app.document()), "CIE A");
        let of_light = light.target(app.document()).expect("a white");
        assert!((of_light.xy()[0] - 0.4476).abs() < 1e-3);
        assert_eq!(light.xy, Some([1.0 / 3.0, 0.3]));
    }

    #[test]
    fn a_locked_fader_keeps_its_share_and_a_silent_one_its_place() {
        let mut app = App::new();
        let mut mix = app.document().pages.mix.desk.clone();
        mix.channels[2].lock = true;
        mix.channels[2].level = 5.0;
        put_on_desk(&mut app, mix);
        let found = solved(&app, &MixWish::default());
        assert!(found.reached, "{}", found.sentence);
        assert_eq!(found.mix.channels[2].level, 5.0);
        let mut mix = app.document().pages.mix.desk.clone();
        mix.channels[2].lock = false;
        mix.channels[2].mute = true;
        put_on_desk(&mut app, mix);
        let found = solved(&app, &MixWish::default());
        assert_eq!(found.mix.channels[2].level, 5.0);
    }

    #[test]
    fn what_cannot_be_met_says_how_near_and_what_is_missing() {
        let mut app = App::new();
        let wish = MixWish {
            floors: Floors {
                ler: Some(600.0),
                ..Floors::default()
            },
            ..MixWish::default()
        };
        let found = solved(&app, &wish);
        assert!(!found.reached);
        assert_says(&found.sentence, "LER");
        let mut mix = app.document().pages.mix.desk.clone();
        mix.channels.truncate(2);
        put_on_desk(&mut app, mix);
        let found = solved(&app, &MixWish::default());
        assert_says(&found.sentence, "from the nearest");
    }

    #[test]
    fn without_channels_or_without_its_light_a_wish_says_so() {
        let mut app = App::new();
        let gone = MixWish {
            light: Some("own/99".to_owned()),
            ..MixWish::default()
        };
        let why = tried(&app, &gone).expect_err("no light");
        assert!(why.contains("own/99"));
        put_on_desk(&mut app, Mix::default());
        let why = tried(&app, &MixWish::default()).expect_err("no channel");
        assert!(why.contains("add some"));
    }

    #[test]
    fn a_light_among_the_channels_is_found_again_by_its_spectrum() {
        let mut app = App::new();
        let key = "cie_illuminants/CIE A".to_owned();
        let mut mix = app.document().pages.mix.desk.clone();
        mix.channels
            .push(MixChannel::new(Source::Named(key.clone())));
        put_on_desk(&mut app, mix);
        let wish = MixWish {
            light: Some(key),
            alike: true,
            ..MixWish::default()
        };
        let found = solved(&app, &wish);
        let levels: Vec<f64> = found.mix.channels.iter().map(|c| c.level).collect();
        assert_eq!(levels[4], 100.0);
        assert!(levels[..4].iter().all(|level| *level < 1e-3), "{levels:?}");
    }
}
