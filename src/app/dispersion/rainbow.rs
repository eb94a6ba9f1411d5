//! The rainbow of a light: two bows, in which every line is a stripe of its own.

use super::{
    drop::DropDrawing,
    lights::document_light,
    prism::StripShown,
    strip::Colours,
    words::{Line, lines_of, nm, touching},
};
use crate::{
    app::{
        cells::{Columns, Table, cell, rounded},
        pages::RainbowMemory,
        state::App,
    },
    languages::fixed,
    optics::{Bows, BuiltinMaterial, Light, SKY_DEG, SUN_DEG, Sky},
};

/// Columns of the strip of sky.
const COLUMNS: usize = 1000;

/// Yellow light, in the middle of the bow, nm.
const YELLOW_NM: f64 = 580.0;

/// The sky over drops of water: made once, then every light is a sum.
pub fn sky() -> Sky {
    Sky::new(BuiltinMaterial::Water.material(), COLUMNS)
}

/// What the page shows.
#[derive(Clone, Debug, Default)]
pub struct RainbowShown {
    /// The result, or why there is none.
    pub sentence: String,
    /// What must be said beside it, sentences.
    pub notes: Vec<String>,
    /// Ends of the strips, degrees from the point opposite the sun.
    pub ends_deg: [f64; 2],
    /// Where the first bow of yellow light stands, degrees.
    pub first_deg: Option<f64>,
    /// A drop in section, with rays of the light.
    pub drop: Option<DropDrawing>,
    /// The sky under the light and under another one.
    pub strips: Vec<StripShown>,
    /// The lines: name, wavelength, n, both bows, polarisation of the first.
    pub table: Table,
}

impl RainbowShown {
    /// Of the state, with what drops send to the sky.
    pub fn of(app: &App, memory: &RainbowMemory, sky: &Sky) -> Self {
        let mut shown = Self {
            ends_deg: SKY_DEG,
            ..Self::default()
        };
        let light = match document_light(app, memory.sent) {
            Ok(light) => light,
            Err(sentence) => return Self { sentence, ..shown },
        };
        let observer = app.document().settings.observer;
        let lines = lines_of(app, &light);
        let bows: Vec<(Line, Bows)> = lines
            .into_iter()
            .filter_map(|line| {
                let bows = Bows::new(sky.material(), line.at_nm).ok()?;
                Some((line, bows))
            })
            .collect();
        let strip = |light: &Light, marks: Vec<(f64, String)>| {
            let strip = sky.strip(light, observer, memory.disc);
            StripShown {
                name: light.name.clone(),
                colours: Colours::of(&strip.xyz, memory.stops),
                marks,
                heights: Vec::new(),
                doubtful: Vec::new(),
            }
        };
        let mut marks = Vec::new();
        for (line, bows) in &bows {
            let angles = [bows.primary, bows.secondary].into_iter().flatten();
            marks.extend(angles.map(|bow| (bow.from_antisolar_deg, line.name.clone())));
        }
        let lines: Vec<Line> = bows.iter().map(|(line, _)| line.clone()).collect();
        shown.drop = Some(DropDrawing::of(sky.material(), &light, &lines, memory));
        let yellow = Bows::new(sky.material(), YELLOW_NM).ok();
        shown.first_deg = yellow.and_then(|bows| angle(&bows, false));
        shown.sentence = sentence(&light, &bows, sky, memory.disc);
        shown.strips.push(strip(&light, marks));
        match memory.beside.light(app, memory.sent) {
            None => {}
            Some(Err(why)) => shown.notes.push(why),
            Some(Ok(other)) => shown.strips.push(strip(&other, Vec::new())),
        }
        shown.table = table(&bows);
        shown
    }
}

/// The lines of the light as a table.
fn table(bows: &[(Line, Bows)]) -> Table {
    let angle_of =
        |secondary: bool| move |(_, bows): &&(Line, Bows)| rounded(angle(bows, secondary), 3, "-");
    let columns = Columns::<&(Line, Bows)>::default()
        .with("line", |(line, _)| cell(line.name.as_str()))
        .titled(said!("line"), said!("The element, by all lines together."))
        .with("wavelength", |(line, _)| {
            cell(format!("{:.1} nm", line.at_nm)).shown(nm(line.at_nm))
        })
        .figures(said!("wavelength"), said!("In air."))
        .with("n", |(_, bows)| rounded(bows.n, 5, "-"))
        .figures("n", said!("Index of refraction of water there."))
        .with("first_bow_deg", angle_of(false))
        .figures(
            said!("first bow \u{b0}"),
            said!("After one reflection in the drop."),
        )
        .with("second_bow_deg", angle_of(true))
        .figures(
            said!("second bow \u{b0}"),
            said!("After two reflections in the drop."),
        )
        .with("polarised_percent", |(_, bows)| {
            rounded(bows.primary.map(|bow| 100.0 * bow.polarisation()), 1, "-")
        })
        .figures(said!("polarised %"), said!("Of the first bow's light."));
    Table::new("", columns, bows)
}

/// The angle of one of the two bows, degrees.
fn angle(bows: &Bows, secondary: bool) -> Option<f64> {
    let bow = [bows.primary, bows.secondary][usize::from(secondary)];
    bow.map(|bow| bow.from_antisolar_deg)
}

fn sentence(light: &Light, bows: &[(Line, Bows)], sky: &Sky, disc: bool) -> String {
    let name = &light.name;
    let at = |nm: f64, secondary: bool| {
        let bows = Bows::new(sky.material(), nm).ok();
        bows.and_then(|bows| angle(&bows, secondary))
            .unwrap_or(f64::NAN)
    };
    if bows.is_empty() {
        // Violet and red where the eye still sees them well.
        return tr!(
            "{light} makes a smooth rainbow from violet at {violet}\u{b0} to red at {red}\u{b0}, \
             and the second bow the other way round.",
            light = name,
            violet = fixed(at(420.0, false), 1),
            red = fixed(at(680.0, false), 1)
        );
    }
    let width = if disc { SUN_DEG } else { 0.0 };
    let stripes = |secondary: bool| {
        let places: Vec<[f64; 2]> = bows
            .iter()
            .filter_map(|(_, bows)| Some([angle(bows, secondary)?, width]))
            .collect();
        places.len() - touching(&places).len()
    };
    tr!(
        "If {light} were the sun, its {lines} would show as {stripes} in the first rainbow and \
         {second} in the second.",
        light = name,
        lines = tr!("{n} line" | "{n} lines" % bows.len()),
        stripes = tr!("{n} stripe" | "{n} stripes" % stripes(false)),
        second = stripes(true)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{assert_says, showing},
        io::many::many,
    };

    #[test]
    fn every_line_has_a_stripe_in_both_bows() {
        let app = App::new();
        let sky = sky();
        let shown = RainbowShown::of(&app, &RainbowMemory::default(), &sky);
        let count = app.derived().model.lines().len();
        assert_eq!(shown.table.shown().count(), count);
        assert_eq!(shown.strips[0].marks.len(), 2 * count);
        assert!(shown.sentence.contains(&many(count, "line", "lines")));
        assert_eq!(shown.strips.len(), 2);
        // Where a line's bow stands, a point of a sun leaves its brightest column.
        let point = RainbowMemory {
            disc: false,
            ..RainbowMemory::default()
        };
        let sharp = RainbowShown::of(&app, &point, &sky);
        assert!(sharp.strips[0].colours != shown.strips[0].colours);
    }

    #[test]
    fn a_smooth_light_has_a_smooth_rainbow() {
        let app = showing("cie_illuminants/CIE D65");
        let shown = RainbowShown::of(&app, &RainbowMemory::default(), &sky());
        assert_says(&shown.sentence, "smooth rainbow");
        assert!(!shown.sentence.contains("NaN"), "{}", shown.sentence);
    }
}
