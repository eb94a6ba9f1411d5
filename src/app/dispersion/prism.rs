//! The bench as a person sees it: what it does in a sentence, its drawing, the screen, the lines.

use super::{
    drawing::BenchDrawing,
    lights::document_light,
    strip::Colours,
    words::{Line, lines_of, listed, nm, touching},
};
use crate::{
    app::{pages::PrismMemory, state::App},
    io::many::capitalised,
    languages::{fixed, signed},
    optics::{
        Bench, BenchError, BenchSettings, Incidence, Landing, Light, Limits, Material, Screen,
        Strip, prism_csv,
    },
};

/// Columns of the screen.
const COLUMNS: usize = 1000;

/// What the page shows.
#[derive(Clone, Debug, Default)]
pub struct PrismShown {
    /// The result, or why there is none.
    pub sentence: String,
    /// What must be said beside it, sentences.
    pub notes: Vec<String>,
    /// The drawing, from above; nothing where no light leaves.
    pub drawing: Option<BenchDrawing>,
    /// How the light meets the prism, degrees.
    pub incidence_deg: Option<f64>,
    /// Ends of the screen, mm: the left one, where light is bent more, first.
    pub ends_mm: [f64; 2],
    /// Wavelengths with their places on it, nm and mm, by rising wavelength.
    pub scale: Vec<[f64; 2]>,
    /// What the light and another one leave there.
    pub strips: Vec<StripShown>,
    /// The lines: name, nm, n, turned by, place, width, through, tells apart.
    pub rows: Vec<Vec<String>>,
    /// All figures of each line, a sentence.
    pub told: Vec<String>,
    /// The same figures with more digits.
    pub csv: String,
    bench: Option<Bench>,
}

/// A strip of the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct StripShown {
    /// Whose light it is.
    pub name: String,
    /// What it looks like.
    pub colours: Colours,
    /// Where named lines stand and how they are called.
    pub marks: Vec<(f64, String)>,
    /// What falls on each column, by the root of its share of the most: by all of the light, and by
    /// its smooth part alone. Empty where it is not drawn.
    pub heights: Vec<[f64; 2]>,
    /// Places that rest on an index outside the range it was published for, from and to.
    pub doubtful: Vec<[f64; 2]>,
}

/// What falls on the columns of a screen, for [`StripShown::heights`].
fn heights(strip: &Strip) -> Vec<[f64; 2]> {
    let both = || strip.smooth.iter().zip(&strip.lines);
    let most = both().map(|(smooth, line)| smooth + line);
    let most = most.fold(0.0, f64::max);
    let root = |value: f64| (value / most).max(0.0).sqrt();
    let heights = both().map(|(smooth, line)| [root(smooth + line), root(*smooth)]);
    heights.filter(|_| most > 0.0).collect()
}

/// The bench that the page asks for.
fn settings(memory: &PrismMemory) -> BenchSettings {
    BenchSettings {
        apex_deg: memory.apex_deg,
        incidence: if memory.at_minimum {
            Incidence::MinimumFor(memory.minimum_nm)
        } else {
            Incidence::Degrees(memory.incidence_deg)
        },
        slit_mm: memory.slit_mm,
        screen_mm: memory.screen_mm,
        ..BenchSettings::default()
    }
}

impl PrismShown {
    /// Of the state.
    pub fn of(app: &App, memory: &PrismMemory) -> Self {
        let nothing = |sentence| Self {
            sentence,
            ends_mm: [1.0, 0.0],
            ..Self::default()
        };
        let light = match document_light(app, memory.sent) {
            Ok(light) => light,
            Err(why) => return nothing(why),
        };
        let material = match memory.made_of.material(app) {
            Ok(material) => material,
            Err(why) => return nothing(why),
        };
        if let Some(why) = material.not_transparent_for(&light) {
            return nothing(capitalised(&format!("{why}.")));
        }
        let settings = settings(memory);
        let bench = match Bench::new(settings.clone(), material.clone()) {
            Ok(bench) => bench,
            Err(why) => return Self::dark(app, &settings, &material, (&light, &why)),
        };
        match bench.whole_screen(&light, COLUMNS) {
            Some(screen) => Self::found(app, memory, &light, bench, screen),
            None => nothing(said!("No light reaches the screen.").to_owned()),
        }
    }

    /// Where no light leaves the second face: where it goes instead.
    fn dark(
        app: &App,
        settings: &BenchSettings,
        material: &Material,
        (light, why): (&Light, &BenchError),
    ) -> Self {
        let lines = lines_of(app, light);
        let observer = app.document().settings.observer;
        let sentence = match why.reflected_beyond() {
            None => capitalised(&format!("{why}.")),
            Some(Limits {
                smallest_incidence_deg: Some(smallest),
                ..
            }) => tr!(
                "Total reflection: no light leaves the second face. Let it meet the prism at more \
                 than {angle}\u{b0}.",
                angle = fixed(smallest, 1)
            ),
            Some(Limits {
                largest_apex_deg, ..
            }) => tr!(
                "Total reflection: no light leaves the second face. Make the apex smaller than \
                 {angle}\u{b0}.",
                angle = fixed(largest_apex_deg, 1)
            ),
        };
        let is_reflected = why.reflected_beyond().is_some();
        Self {
            sentence,
            drawing: BenchDrawing::dark(settings, material, (light, &lines, observer))
                .filter(|_| is_reflected),
            ends_mm: [1.0, 0.0],
            ..Self::default()
        }
    }

    fn found(app: &App, memory: &PrismMemory, light: &Light, bench: Bench, screen: Screen) -> Self {
        let observer = app.document().settings.observer;
        let lines = lines_of(app, light);
        let landings: Vec<(&Line, Option<Landing>)> = lines
            .iter()
            .map(|line| (line, bench.landing(line.at_nm).ok().flatten()))
            .collect();
        let mark = |(line, landing): &(&Line, Option<Landing>)| {
            Some((landing.as_ref()?.x_mm, line.name.clone()))
        };
        let scale = scale(&bench);
        let doubtful = doubtful(&bench);
        let on_screen = |light: &Light, marks: Vec<(f64, String)>| {
            let strip = bench.strip(light, screen, observer);
            // What is bent more, violet, stands at the left as on every other axis.
            let mut colours = Colours::of(&strip.xyz, memory.stops);
            colours.rgb.reverse();
            let mut heights = heights(&strip);
            heights.reverse();
            StripShown {
                name: light.name.clone(),
                colours,
                marks,
                heights,
                doubtful: doubtful.clone(),
            }
        };
        let mut notes = notes(&bench, !doubtful.is_empty());
        let mut strips = vec![on_screen(light, landings.iter().filter_map(mark).collect())];
        match memory.beside.light(app, memory.sent) {
            None => {}
            Some(Err(why)) => notes.push(why),
            Some(Ok(other)) => strips.push(StripShown {
                heights: Vec::new(),
                ..on_screen(&other, Vec::new())
            }),
        }
        Self {
            sentence: sentence(app, memory, light, &bench, &landings),
            notes,
            drawing: BenchDrawing::of(&bench, light, &lines, observer),
            incidence_deg: Some(bench.prism().incidence_deg()),
            ends_mm: [screen.ends_mm[1], screen.ends_mm[0]],
            scale,
            strips,
            rows: landings
                .iter()
                .map(|(line, at)| row(line, at.as_ref()))
                .collect(),
            told: landings
                .iter()
                .map(|(_, at)| at.as_ref().map_or_else(String::new, told))
                .collect(),
            csv: prism_csv(&bench, light, &[]),
            bench: Some(bench),
        }
    }

    /// Every figure of the wavelength that lands at a place, mm; `None` where none does.
    pub fn told(&self, x_mm: f64) -> Option<String> {
        let bench = self.bench.as_ref()?;
        let pair = self.scale.windows(2).find(|pair| {
            let along = (x_mm - pair[0][1]) / (pair[1][1] - pair[0][1]);
            (0.0..=1.0).contains(&along)
        })?;
        // Between two that enclose it, halved until no pointer tells them apart.
        let [mut low, mut high] = [pair[0], pair[1]];
        for _ in 0..20 {
            let nm = 0.5 * (low[0] + high[0]);
            let x = bench.landing(nm).ok().flatten()?.x_mm;
            let is_above = (x - x_mm) * (low[1] - x_mm) > 0.0;
            *(if is_above { &mut low } else { &mut high }) = [nm, x];
        }
        let landing = bench.landing(0.5 * (low[0] + high[0])).ok().flatten()?;
        Some(told(&landing))
    }
}

/// What must be said of a bench.
fn notes(bench: &Bench, is_doubtful: bool) -> Vec<String> {
    let mut notes: Vec<String> = Vec::new();
    if let Some(words) = bench.reflected_words() {
        notes.push(format!("{words}."));
    }
    let settings = bench.settings();
    let on_face = 0.5 * settings.slit_mm / bench.prism().incidence_deg().to_radians().cos();
    if on_face > settings.entry_mm {
        notes.push(
            said!(
                "The beam is wider than the prism: what passes beside its apex is counted as if \
                 the prism went on."
            )
            .to_owned(),
        );
    }
    if is_doubtful {
        notes.push(tr!(
            "Hatched: the index of {material} outside the range it was published for.",
            material = crate::languages::translated(&bench.material().name)
        ));
    }
    notes
}

/// Every figure of a wavelength, a sentence.
fn told(at: &Landing) -> String {
    let least = at.minimum_deviation_deg.map_or_else(String::new, |least| {
        tr!(" (at least {least}\u{b0})", least = fixed(least, 3))
    });
    let told_apart = match told_apart(at) {
        None => said!("no lines are told apart").to_owned(),
        Some(apart) => {
            let (apart, power) = (fixed(apart, 2), fixed(at.resolving.power(), 0));
            match at.resolving.limit() {
                GLASS => tr!(
                    "lines {apart} nm apart are told apart (resolving power {power}, by the glass)",
                    apart,
                    power
                ),
                _ => tr!(
                    "lines {apart} nm apart are told apart (resolving power {power}, by the slit)",
                    apart,
                    power
                ),
            }
        }
    };
    tr!(
        "{place} nm: n {index}, turned by {angle}\u{b0}{least}, {change}\u{b0} a nm; {passes} % \
         pass; it lands at {landing} mm, {width} mm wide; {told_apart}.",
        place = fixed(at.at_nm, 1),
        index = fixed(at.n, 5),
        angle = fixed(at.deviation_deg, 3),
        least,
        change = signed(at.d_deviation_d_nm, 4),
        passes = fixed(100.0 * at.transmittance, 1),
        landing = fixed(at.x_mm, 2),
        width = fixed(at.width_mm, 3),
        told_apart
    )
}

/// Two lines nearer than this run together, nm; `None` where the glass does not spread light.
fn told_apart(at: &Landing) -> Option<f64> {
    Some(at.at_nm / at.resolving.power()).filter(|apart| apart.is_finite())
}

/// Step of what is hatched, nm.
const HATCH_NM: usize = 2;

/// Places whose wavelengths have an index outside the range it was published for.
fn doubtful(bench: &Bench) -> Vec<[f64; 2]> {
    let place = |nm: f64| Some(bench.landing(nm).ok()??.x_mm);
    let mut found: Vec<[f64; 2]> = Vec::new();
    for nm in (380..780).step_by(HATCH_NM) {
        let [a, b] = [nm, nm + HATCH_NM].map(|nm| nm as f64);
        let ends = bench
            .material()
            .is_extrapolated(0.5 * (a + b))
            .then(|| (place(a), place(b)));
        let Some((Some(a), Some(b))) = ends else {
            continue;
        };
        match found.last_mut() {
            Some(last) if last[1] == a => last[1] = b,
            _ => found.push([a, b]),
        }
    }
    found
}

/// Where every tenth wavelength lands.
fn scale(bench: &Bench) -> Vec<[f64; 2]> {
    let place = |nm: f64| Some([nm, bench.landing(nm).ok()??.x_mm]);
    (38..=78)
        .filter_map(|i| place(10.0 * f64::from(i)))
        .collect()
}

/// What the prism does to the light.
fn sentence(
    app: &App,
    memory: &PrismMemory,
    light: &Light,
    bench: &Bench,
    landings: &[(&Line, Option<Landing>)],
) -> String {
    let glass = memory.made_of.in_words(app);
    let bends = |nm: f64| Some(bench.landing(nm).ok()??.deviation_deg);
    let bent: Vec<f64> = (380..=780).filter_map(|nm| bends(f64::from(nm))).collect();
    let least = bent.iter().copied().fold(f64::INFINITY, f64::min);
    let most = bent.iter().copied().fold(0.0, f64::max);
    let spreads = tr!(
        "A {apex}\u{b0} prism of {glass} spreads {light} over {angle}\u{b0}",
        apex = fixed(bench.prism().apex_deg(), 0),
        glass,
        light = light.name,
        angle = fixed(most - least, 1)
    );
    let seen: Vec<Landing> = landings
        .iter()
        .filter_map(|(_, landing)| *landing)
        .collect();
    let count = match seen.len() {
        0 => return tr!("{spreads}: no line, one smooth band.", spreads),
        1 => {
            return tr!(
                "{spreads}; its line of {place} is one ray.",
                spreads,
                place = nm(seen[0].at_nm)
            );
        }
        count => count,
    };
    let images: Vec<[f64; 2]> = seen.iter().map(|l| [l.x_mm, l.width_mm]).collect();
    let pair = |i: usize| {
        tr!(
            "{first} with {second}",
            first = fixed(seen[i].at_nm, 1),
            second = nm(seen[i + 1].at_nm)
        )
    };
    let together: Vec<String> = touching(&images).into_iter().map(pair).collect();
    match together.len() {
        0 => tr!(
            "{spreads}; its {count} lines all stand apart.",
            spreads,
            count
        ),
        n if n + 1 == seen.len() => {
            tr!(
                "{spreads}; its {count} lines all run together.",
                spreads,
                count
            )
        }
        _ => tr!(
            "{spreads}; of its {count} lines {pairs} runs together, the others stand apart.",
            spreads,
            count,
            pairs = listed(&together)
        ),
    }
}

/// The word of what limits the resolving power where that is not the slit.
const GLASS: &str = "glass";

/// A line's figures in the order of the table.
fn row(line: &Line, landing: Option<&Landing>) -> Vec<String> {
    let mut cells = vec![line.name.clone(), fixed(line.at_nm, 2)];
    match landing {
        Some(at) => {
            cells.extend([
                fixed(at.n, 5),
                fixed(at.deviation_deg, 3),
                fixed(at.x_mm, 3),
                fixed(at.width_mm, 3),
                fixed(100.0 * at.transmittance, 1),
                told_apart(at).map_or_else(
                    || "-".to_owned(),
                    |apart| {
                        let limit = match at.resolving.limit() {
                            GLASS => said!("glass"),
                            _ => said!("slit"),
                        };
                        format!("{} ({limit})", fixed(apart, 2))
                    },
                ),
            ]);
        }
        None => cells.extend(std::iter::repeat_n("-".to_owned(), 6)),
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{Command, Settings, assert_says, dispersion::Substance},
        io::many::many,
        optics::BuiltinMaterial,
    };

    fn usual() -> PrismMemory {
        PrismMemory::default()
    }

    /// Of the first light.
    fn shown(memory: &PrismMemory) -> PrismShown {
        PrismShown::of(&App::new(), memory)
    }

    #[test]
    fn every_line_of_the_model_is_one_ray_one_mark_and_one_row() {
        let app = App::new();
        let count = app.derived().model.lines().len();
        let shown = PrismShown::of(&app, &usual());
        let drawing = shown.drawing.expect("light leaves");
        assert_eq!(drawing.lines.len(), count);
        assert_eq!(shown.strips[0].marks.len(), count);
        assert_eq!(shown.rows.len(), count);
        assert_says(&shown.sentence, &many(count, "line", "lines"));
        assert_eq!(shown.strips.len(), 2);
        assert!(shown.strips[1].marks.is_empty());
    }

    #[test]
    fn a_higher_threshold_takes_lines_out_of_the_picture() {
        let mut app = App::new();
        let before = PrismShown::of(&app, &usual()).rows.len();
        app.apply(Command::Edit(Settings {
            threshold_percent: 3.0,
            ..app.document().settings
        }));
        let after = PrismShown::of(&app, &usual());
        assert!(after.rows.len() < before);
        app.apply(Command::Edit(Settings {
            spikes: false,
            ..app.document().settings
        }));
        let none = PrismShown::of(&app, &usual());
        assert_says(&none.sentence, "no line");
        assert!(none.drawing.is_some_and(|drawing| drawing.lines.is_empty()));
    }

    #[test]
    fn a_wide_slit_runs_lines_together() {
        let narrow = shown(&usual()).sentence;
        let wide = PrismMemory {
            slit_mm: 30.0,
            ..usual()
        };
        assert_says(&narrow, "apart");
        assert!(!narrow.contains("all run together"), "{narrow}");
        assert_says(&shown(&wide).sentence, "together");
    }

    #[test]
    fn a_bench_without_light_says_why_and_shows_where_it_goes() {
        for memory in [
            PrismMemory {
                made_of: Substance::Shipped(BuiltinMaterial::Diamond),
                ..usual()
            },
            PrismMemory {
                at_minimum: false,
                incidence_deg: 5.0,
                ..usual()
            },
        ] {
            let shown = shown(&memory);
            assert_says(&shown.sentence, "Total reflection");
            // The light goes somewhere, and the handles stay.
            let drawing = shown.drawing.expect("total reflection is drawn");
            assert!(drawing.most_bent.is_none() && shown.strips.is_empty());
            assert!(drawing.lines.iter().all(|ray| ray.way.len() > 2));
        }
        let grazing = PrismMemory {
            at_minimum: false,
            incidence_deg: 51.5,
            ..usual()
        };
        let shown = shown(&grazing);
        assert_says(&shown.notes.join(" "), "totally reflected");
        assert!(shown.rows.iter().any(|row| row[2] == "-"));
    }

    #[test]
    fn the_pointer_is_told_all_of_the_wavelength_that_lands_there() {
        let shown = shown(&usual());
        // The reference lands in the middle, at its least deviation.
        let words = shown.told(0.0).expect("546.075 nm");
        for part in [
            "546.1 nm: n 1.79192",
            "67.264\u{b0} (at least 67.264\u{b0})",
            "by the slit",
        ] {
            assert_says(&words, part);
        }
        assert_eq!(shown.told(1e6), None);
        assert_eq!(shown.told.len(), shown.rows.len());
        let line = &shown.rows[0];
        assert!(shown.told[0].contains(&line[2]), "{}", shown.told[0]);
    }

    #[test]
    fn lines_tower_over_the_smooth_part_and_never_enter_it() {
        let shown = shown(&usual());
        let [tube, bulb] = &shown.strips[..] else {
            panic!("two strips");
        };
        let most = |k: usize| tube.heights.iter().map(|h| h[k]).fold(0.0, f64::max);
        let (all, smooth) = (most(0), most(1));
        assert!((all - 1.0).abs() < 1e-12 && smooth < 0.8, "{smooth}");
        assert!(bulb.heights.is_empty(), "the light alone is plotted");
        assert_eq!(tube.heights.len(), COLUMNS);
    }

    #[test]
    fn what_rests_on_an_extrapolated_index_is_hatched() {
        assert!(shown(&usual()).strips[0].doubtful.is_empty());
        let diamond = PrismMemory {
            made_of: Substance::Shipped(BuiltinMaterial::Diamond),
            apex_deg: 30.0,
            ..usual()
        };
        let shown = shown(&diamond);
        // Published to 760 nm.
        let [[from, to]] = shown.strips[0].doubtful[..] else {
            panic!("{:?}", shown.strips[0].doubtful);
        };
        let place = |nm: f64| {
            let scale = shown.scale.iter().find(|at| at[0] == nm);
            scale.expect("every tenth nm")[1]
        };
        assert!((from - place(760.0)).abs() < 1e-9 && (to - place(780.0)).abs() < 1e-9);
        assert!(shown.notes.iter().any(|note| note.contains("Hatched")));
    }

    #[test]
    fn two_numbers_are_a_glass_too() {
        let shown = shown(&PrismMemory {
            made_of: Substance::NUMBERS,
            ..usual()
        });
        assert_says(&shown.sentence, "two numbers (n 1.5168");
        assert!(shown.drawing.is_some());
    }
}
