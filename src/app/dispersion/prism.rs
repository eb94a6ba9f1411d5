//! The bench as a person sees it: what it does in a sentence, its drawing, the screen, the lines.

use super::{
    lights::document_light,
    memory::{PrismMemory, stuff_title},
    strip::Colours,
    words::{Line, lines_of, listed, nm, touching},
};
use crate::{
    app::{chart::Rgb, state::App},
    color::{Observer, Srgb, Swatch, srgb_from_wavelength},
    io::many::{capitalised, many},
    optics::{Bench, BenchSettings, Incidence, Landing, Light, RayPath, Screen, prism_csv},
};

/// Columns of the screen.
const COLUMNS: usize = 1000;

/// In the drawing the screen stands this often the chief ray's distance from the apex away, so
/// that the prism is not lost; angles stay exact.
const DRAWN_SCREEN: f64 = 4.6;

/// Step of the smooth part's rays in the drawing, nm.
const DRAWN_STEP_NM: f64 = 4.0;

/// What the page shows.
#[derive(Clone, Debug)]
pub struct PrismShown {
    /// The result, or why there is none.
    pub sentence: String,
    /// What must be said beside it, sentences.
    pub notes: Vec<String>,
    /// The drawing, from above; nothing where no light leaves.
    pub drawing: Option<BenchDrawing>,
    /// How the light meets the prism, degrees.
    pub incidence_deg: Option<f64>,
    /// Ends of the screen, mm.
    pub ends_mm: [f64; 2],
    /// What the light and another one leave there.
    pub strips: Vec<StripShown>,
    /// The lines: name, nm, n, turned by, place, width, through, tells apart.
    pub rows: Vec<Vec<String>>,
    /// The same figures with more digits.
    pub csv: String,
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
}

/// A ray of the drawing: where it enters, leaves and ends, mm, y upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnRay {
    /// Its colour.
    pub rgb: Rgb,
    /// How strong it is, 0-1.
    pub strength: f64,
    /// The places.
    pub at: [[f64; 2]; 3],
}

/// The bench from above; mm, y upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchDrawing {
    /// Corners of the prism, the apex first.
    pub prism: [[f64; 2]; 3],
    /// The light on its way in: from, to.
    pub incoming: [[f64; 2]; 2],
    /// Its colour.
    pub rgb: Rgb,
    /// Rays of the smooth part, neighbours by wavelength.
    pub smooth: Vec<DrawnRay>,
    /// One exact ray for each line.
    pub lines: Vec<DrawnRay>,
    /// Ends of the screen.
    pub screen: [[f64; 2]; 2],
}

fn settings(memory: &PrismMemory) -> BenchSettings {
    let usual = BenchSettings::default();
    BenchSettings {
        apex_deg: memory.apex_deg,
        incidence: if memory.at_minimum {
            Incidence::MinimumFor(usual.reference_nm)
        } else {
            Incidence::Degrees(memory.incidence_deg)
        },
        slit_mm: memory.slit_mm,
        ..usual
    }
}

impl PrismShown {
    /// Of the state.
    pub fn of(app: &App, memory: &PrismMemory) -> Self {
        let material = memory.stuff.material();
        let made = document_light(app).and_then(|light| {
            let bench = Bench::new(settings(memory), material)
                .map_err(|why| capitalised(&format!("{why}.")))?;
            let screen = bench.whole_screen(&light, COLUMNS);
            let screen = screen.ok_or_else(|| "No light reaches the screen.".to_owned())?;
            Ok((light, bench, screen))
        });
        match made {
            Ok((light, bench, screen)) => Self::found(app, memory, &light, &bench, screen),
            Err(sentence) => Self {
                sentence,
                notes: Vec::new(),
                drawing: None,
                incidence_deg: None,
                ends_mm: [0.0, 1.0],
                strips: Vec::new(),
                rows: Vec::new(),
                csv: String::new(),
            },
        }
    }

    fn found(
        app: &App,
        memory: &PrismMemory,
        light: &Light,
        bench: &Bench,
        screen: Screen,
    ) -> Self {
        let observer = app.document().settings.observer;
        let lines = lines_of(app, light);
        let landings: Vec<(&Line, Option<Landing>)> = lines
            .iter()
            .map(|line| (line, bench.landing(line.at_nm).ok().flatten()))
            .collect();
        let strip = bench.strip(light, screen, observer);
        let mark = |(line, landing): &(&Line, Option<Landing>)| {
            Some((landing.as_ref()?.x_mm, line.name.clone()))
        };
        let mut notes: Vec<String> = Vec::new();
        if let Some(words) = bench.reflected_words() {
            notes.push(format!("{words}."));
        }
        if strip.extrapolated {
            notes.push(format!(
                "Part of it rests on the index of {} outside the range it was published for.",
                bench.material().name
            ));
        }
        let mut strips = vec![StripShown {
            name: light.name.clone(),
            colours: Colours::of(&strip.xyz, memory.stops),
            marks: landings.iter().filter_map(mark).collect(),
        }];
        match memory.beside.light(app) {
            None => {}
            Some(Err(why)) => notes.push(why),
            Some(Ok(other)) => {
                let strip = bench.strip(&other, screen, observer);
                strips.push(StripShown {
                    name: other.name.clone(),
                    colours: Colours::of(&strip.xyz, memory.stops),
                    marks: Vec::new(),
                });
            }
        }
        Self {
            sentence: sentence(memory, light, bench, screen, &landings),
            notes,
            drawing: BenchDrawing::of(memory, light, &lines, observer),
            incidence_deg: Some(bench.prism().incidence_deg()),
            ends_mm: screen.ends_mm,
            strips,
            rows: landings
                .iter()
                .map(|(line, at)| row(line, at.as_ref()))
                .collect(),
            csv: prism_csv(bench, light, &[]),
        }
    }
}

/// What the prism does to the light.
fn sentence(
    memory: &PrismMemory,
    light: &Light,
    bench: &Bench,
    screen: Screen,
    landings: &[(&Line, Option<Landing>)],
) -> String {
    let glass = stuff_title(memory.stuff);
    let glass = glass.split(',').next().unwrap_or(glass);
    let through = format!(
        "{} through {:.0}\u{b0} of {glass}",
        light.name,
        bench.prism().apex_deg()
    );
    let seen: Vec<Landing> = landings
        .iter()
        .filter_map(|(_, landing)| *landing)
        .collect();
    let wide = screen.ends_mm[1] - screen.ends_mm[0];
    let (Some(first), Some(last)) = (seen.first(), seen.last()) else {
        return format!("{through}: no line, one smooth band {wide:.0} mm wide.");
    };
    if seen.len() == 1 {
        return format!(
            "{through}: its line of {} is turned by {:.2}\u{b0} and {:.2} mm wide.",
            nm(first.at_nm),
            first.deviation_deg,
            first.width_mm
        );
    }
    let widths = || seen.iter().map(|landing| landing.width_mm);
    let least = widths().fold(f64::INFINITY, f64::min);
    let most = widths().fold(0.0, f64::max);
    let images: Vec<[f64; 2]> = seen.iter().map(|l| [l.x_mm, l.width_mm]).collect();
    let pair = |i: usize| format!("{:.1} with {}", seen[i].at_nm, nm(seen[i + 1].at_nm));
    let together: Vec<String> = touching(&images).into_iter().map(pair).collect();
    let apart = match together.len() {
        0 => "all stand apart".to_owned(),
        n if n + 1 == seen.len() => "all run together".to_owned(),
        _ => format!(
            "{} runs together, the others stand apart",
            listed(&together)
        ),
    };
    format!(
        "{through}: {} turned by {:.2}\u{b0} ({}) to {:.2}\u{b0} ({}), {:.2} to {:.2} mm wide; \
         {apart}.",
        many(seen.len(), "line", "lines"),
        last.deviation_deg,
        nm(last.at_nm),
        first.deviation_deg,
        nm(first.at_nm),
        least,
        most,
    )
}

/// A line's figures in the order of the table.
fn row(line: &Line, landing: Option<&Landing>) -> Vec<String> {
    let mut cells = vec![line.name.clone(), format!("{:.2}", line.at_nm)];
    match landing {
        Some(at) => {
            let power = at.resolving.power();
            cells.extend([
                format!("{:.5}", at.n),
                format!("{:.3}", at.deviation_deg),
                format!("{:.3}", at.x_mm),
                format!("{:.3}", at.width_mm),
                format!("{:.1}", 100.0 * at.transmittance),
                format!("{:.2} ({})", at.at_nm / power, at.resolving.limit()),
            ]);
        }
        None => cells.extend(std::iter::repeat_n("-".to_owned(), 6)),
    }
    cells
}

impl BenchDrawing {
    /// Of the bench with its screen moved near; `None` where no light leaves.
    fn of(memory: &PrismMemory, light: &Light, lines: &[Line], observer: Observer) -> Option<Self> {
        let mut near = settings(memory);
        near.screen_mm = DRAWN_SCREEN * near.entry_mm;
        let entry_mm = near.entry_mm;
        let bench = Bench::new(near, memory.stuff.material()).ok()?;
        let at = |path: RayPath| [path.entry, path.exit, path.screen];
        let count = (400.0 / DRAWN_STEP_NM) as usize;
        let places: Vec<f64> = (0..=count)
            .map(|i| 380.0 + DRAWN_STEP_NM * i as f64)
            .collect();
        let most = places
            .iter()
            .map(|nm| light.smooth_at(*nm))
            .fold(0.0, f64::max);
        let drawn = |at_nm: f64, strength: f64| {
            let Srgb(rgb) = srgb_from_wavelength(at_nm);
            Some(DrawnRay {
                rgb,
                strength: strength.clamp(0.0, 1.0),
                at: at(bench.ray(at_nm, 0.0)?),
            })
        };
        let relative = |nm: f64| {
            let value = light.smooth_at(nm) / most;
            if value.is_finite() {
                value.max(0.0).sqrt()
            } else {
                0.0
            }
        };
        let smooth: Vec<DrawnRay> = places
            .iter()
            .filter_map(|nm| drawn(*nm, relative(*nm)))
            .collect();
        let heaviest = lines
            .iter()
            .map(|line| line.weight.abs())
            .fold(0.0, f64::max);
        let strength = |line: &Line| 0.35 + 0.65 * (line.weight.abs() / heaviest).sqrt();
        let lines: Vec<DrawnRay> = lines
            .iter()
            .filter_map(|line| drawn(line.at_nm, strength(line)))
            .collect();
        let path = bench.ray(bench.reference_nm(), 0.0)?;
        let [sin, cos] = {
            let half = (0.5 * bench.prism().apex_deg()).to_radians();
            [half.sin(), half.cos()]
        };
        let reach = |ray: &DrawnRay| ray.at[1][0].hypot(ray.at[1][1]);
        let farthest = smooth
            .iter()
            .chain(&lines)
            .map(reach)
            .fold(entry_mm, f64::max);
        // A grazing ray may leave far out: the prism is drawn no longer than the page bears.
        let side = (1.2 * farthest).clamp(2.0 * entry_mm, 4.0 * entry_mm);
        let back = |from: [f64; 2], way: f64| {
            [
                from[0] - way * path.incoming[0],
                from[1] - way * path.incoming[1],
            ]
        };
        let ends = smooth.iter().chain(&lines).map(|ray| ray.at[2]);
        let ahead = [path.screen[0] - path.exit[0], path.screen[1] - path.exit[1]];
        let length = ahead[0].hypot(ahead[1]);
        let across = [ahead[1] / length, -ahead[0] / length];
        let along =
            |p: [f64; 2]| (p[0] - path.screen[0]) * across[0] + (p[1] - path.screen[1]) * across[1];
        let (low, high) = ends
            .map(along)
            .fold((-4.0, 4.0), |(a, b), v| (f64::min(a, v), f64::max(b, v)));
        let most = 3.0 * entry_mm;
        let end = |way: f64| {
            let way = way.clamp(-most, most);
            [
                path.screen[0] + way * across[0],
                path.screen[1] + way * across[1],
            ]
        };
        Some(Self {
            prism: [
                [0.0, 0.0],
                [-side * sin, -side * cos],
                [side * sin, -side * cos],
            ],
            incoming: [back(path.entry, 3.2 * entry_mm), path.entry],
            rgb: Swatch::of_light(light.white(observer)).rgb8.0,
            smooth,
            lines,
            screen: [end(low - 3.0), end(high + 3.0)],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{Command, Settings};

    fn usual() -> PrismMemory {
        PrismMemory::default()
    }

    #[test]
    fn every_line_of_the_model_is_one_ray_one_mark_and_one_row() {
        let app = App::new();
        let count = app.derived().model.spikes.len();
        let shown = PrismShown::of(&app, &usual());
        let drawing = shown.drawing.expect("light leaves");
        assert_eq!(drawing.lines.len(), count);
        assert_eq!(shown.strips[0].marks.len(), count);
        assert_eq!(shown.rows.len(), count);
        assert!(
            shown.sentence.contains(&many(count, "line", "lines")),
            "{}",
            shown.sentence
        );
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
        assert!(none.sentence.contains("no line"), "{}", none.sentence);
        assert!(none.drawing.is_some_and(|drawing| drawing.lines.is_empty()));
    }

    #[test]
    fn a_wide_slit_runs_lines_together() {
        let app = App::new();
        let narrow = PrismShown::of(&app, &usual()).sentence;
        let wide = PrismMemory {
            slit_mm: 30.0,
            ..usual()
        };
        let wide = PrismShown::of(&app, &wide).sentence;
        assert!(
            narrow.contains("apart") && !narrow.contains("all run together"),
            "{narrow}"
        );
        assert!(wide.contains("together"), "{wide}");
    }

    #[test]
    fn a_bench_without_light_says_why() {
        let app = App::new();
        for memory in [
            PrismMemory {
                stuff: crate::optics::Stuff::Diamond,
                ..usual()
            },
            PrismMemory {
                at_minimum: false,
                incidence_deg: 5.0,
                ..usual()
            },
        ] {
            let shown = PrismShown::of(&app, &memory);
            assert!(shown.drawing.is_none() && shown.strips.is_empty());
            assert!(shown.sentence.ends_with('.'), "{}", shown.sentence);
            assert!(shown.sentence.len() > 20, "{}", shown.sentence);
        }
        let grazing = PrismMemory {
            at_minimum: false,
            incidence_deg: 51.5,
            ..usual()
        };
        let shown = PrismShown::of(&app, &grazing);
        assert!(
            shown
                .notes
                .iter()
                .any(|note| note.contains("totally reflected"))
        );
        assert!(shown.rows.iter().any(|row| row[2] == "-"));
    }
}
