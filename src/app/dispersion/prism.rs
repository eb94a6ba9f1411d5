//! The bench as a person sees it: what it does in a sentence, its drawing, the screen, the lines.

use super::{
    drawing::BenchDrawing,
    lights::document_light,
    memory::{PrismMemory, stuff_title},
    strip::Colours,
    words::{Line, lines_of, listed, nm, touching},
};
use crate::{
    app::state::App,
    io::many::{capitalised, many},
    optics::{Bench, BenchSettings, Incidence, Landing, Light, Screen, prism_csv},
};

/// Columns of the screen.
const COLUMNS: usize = 1000;

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
    /// Wavelengths with their places on it, nm and mm, by rising wavelength.
    pub scale: Vec<[f64; 2]>,
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

/// The bench that the page asks for.
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
                scale: Vec::new(),
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
            drawing: BenchDrawing::of(bench, light, &lines, observer),
            incidence_deg: Some(bench.prism().incidence_deg()),
            ends_mm: screen.ends_mm,
            scale: scale(bench),
            strips,
            rows: landings
                .iter()
                .map(|(line, at)| row(line, at.as_ref()))
                .collect(),
            csv: prism_csv(bench, light, &[]),
        }
    }
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
