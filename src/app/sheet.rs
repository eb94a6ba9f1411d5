//! One page about a light, to print or to hand to a client: what it is, how good it is, its colours
//! and the numbers of its model. A4 upright, as SVG or PDF.

use std::{fmt::Write as _, sync::Arc};

use svg2pdf::usvg;

use super::{
    Lit,
    about::About,
    chart::{Chart, Palette, Rgb, SVG_HEAD, Theme, elided, escaped, px, text_width, wrap},
    charts::{
        quality::{DiagramShows, diagram, vector_graphic},
        spectrum::spectrum_chart,
    },
    comparison::Compared,
    quality::QualityShown,
    quality_report::Row,
    share,
    state::App,
};
use crate::{
    color::{Srgb, Swatch},
    spectrum::NamedSpectrum,
};

/// A4 in px of 1/96 inch.
const PAGE: [f64; 2] = [794.0, 1123.0];
const MARGIN: f64 = 44.0;
/// The side of the QR code with its quiet zone.
const CODE: f64 = 132.0;
/// Of the rows, and of what is small.
const SIZES: [f64; 2] = [10.5, 8.5];
/// Where the columns of the table begin.
const COLUMNS: [f64; 4] = [0.0, 180.0, 285.0, 390.0];
/// How much smaller a chart is than in a file of its own.
const SHRUNK: f64 = 0.64;
/// Rows of the table that say little beside the others.
const LEFT_OUT: [&str; 18] = [
    "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r10", "r11", "r12", "r13", "r14", "r15",
    "s_cone", "m_cone", "l_cone", "tlci",
];
/// Rows that say little where two lights stand beside each other.
const OF_ONE: [&str; 9] = [
    "dominant_nm",
    "purity",
    "rhodopic",
    "ppfd_per_100lx",
    "eppfd_per_100lx",
    "peak_nm",
    "centroid_nm",
    "fwhm_nm",
    "lux",
];
/// The font of the window, so that the page looks the same everywhere.
pub static FONT: &[u8] = include_bytes!("../ui/fonts/DejaVuSans.ttf");

/// The page of the document's light as SVG.
pub fn to_svg(app: &App) -> String {
    let shown = QualityShown::of(app);
    let mut page = Page {
        body: String::new(),
        y: MARGIN,
        beside: 0.0,
    };
    page.head(app, &shown);
    let whole = PAGE[0] - 2.0 * MARGIN;
    let spectrum = Chart {
        title: String::new(),
        notes: Vec::new(),
        ..spectrum_chart(app)
    };
    page.chart(&spectrum, [MARGIN, page.y], [whole, 236.0]);
    page.y += 244.0;
    let half = (whole - 16.0) / 2.0;
    let places = diagram(&shown.placed(), DiagramShows::default());
    page.chart(&places, [MARGIN, page.y], [half, 280.0]);
    let fidelities = shown.fidelities();
    if !fidelities.is_empty() {
        let vectors = vector_graphic(&fidelities, None);
        let square = [half.min(290.0), 280.0];
        page.chart(&vectors, [MARGIN + half + 16.0, page.y], square);
    }
    page.y += 292.0;
    page.table(&shown, app.compared());
    page.patches(app, &shown);
    page.foot(app);
    page.finish()
}

/// The page as PDF.
///
/// # Errors
/// One line when the page cannot be written so.
pub fn to_pdf(app: &App) -> Result<Vec<u8>, String> {
    let options = svg_options();
    let tree = usvg::Tree::from_str(&to_svg(app), &options).map_err(|e| e.to_string())?;
    // 96 px are an inch, and an inch is 72 points.
    let page = svg2pdf::PageOptions { dpi: 96.0 };
    let pdf = svg2pdf::to_pdf(&tree, svg2pdf::ConversionOptions::default(), page);
    let mut pdf = pdf.map_err(|e| e.to_string())?;
    pdf.extend_from_slice(PDF_TAIL.as_bytes());
    Ok(pdf)
}

/// Options by which pages are drawn: the program's own font.
pub fn svg_options() -> usvg::Options<'static> {
    let mut options = usvg::Options {
        font_family: "DejaVu Sans".to_owned(),
        ..usvg::Options::default()
    };
    let fonts = Arc::make_mut(&mut options.fontdb);
    fonts.load_font_data(FONT.to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    options
}

/// How every PDF document of the program ends, a comment: the command line knows its own pages by
/// it, and replaces no others.
pub const PDF_TAIL: &str = concat!("\n%Drawn by ", env!("CARGO_PKG_NAME"), "\n");

/// A page that is written from its top down.
struct Page {
    body: String,
    /// Where the next thing begins.
    y: f64,
    /// The width at the right that words leave free.
    beside: f64,
}

impl Page {
    fn finish(self) -> String {
        let [width, height] = PAGE.map(px);
        let body = self.body;
        format!(
            r##"{SVG_HEAD} xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="DejaVu Sans, sans-serif" fill="none">
<rect width="{width}" height="{height}" fill="#ffffff"/>
{body}</svg>
"##
        )
    }

    fn text(&mut self, [x, y]: [f64; 2], size: f64, ink: Rgb, words: &str) {
        let [x, y, size] = [x, y, size].map(px);
        let (ink, words) = (Srgb(ink).hex(), escaped(words));
        // Writing to a String cannot fail.
        let _ = writeln!(
            self.body,
            r#"<text x="{x}" y="{y}" font-size="{size}" fill="{ink}">{words}</text>"#
        );
    }

    /// Lines of words over the width that is free, each below the one before.
    fn words(&mut self, size: f64, ink: Rgb, words: &str) {
        for line in wrap(words, PAGE[0] - 2.0 * MARGIN - self.beside, size) {
            self.y += 1.35 * size;
            self.text([MARGIN, self.y], size, ink, &line);
        }
    }

    /// A chart, its words as small as those of the page.
    fn chart(&mut self, chart: &Chart, [x, y]: [f64; 2], size: [f64; 2]) {
        let (body, _) = chart.to_svg_body(size.map(|side| side / SHRUNK), Theme::Light);
        let [x, y] = [x, y].map(px);
        let _ = writeln!(
            self.body,
            r#"<g transform="translate({x} {y}) scale({SHRUNK})">{body}</g>"#
        );
    }

    fn head(&mut self, app: &App, shown: &QualityShown) {
        let palette = Palette::of(Theme::Light);
        let document = app.document();
        let lights = [Some(&document.light), document.second.as_ref()];
        let abouts = lights.map(|light| light.map(|light| About::of(light)));
        if document.second.is_none() {
            self.code(app);
        }
        let titles = abouts.iter().flatten().map(About::title);
        let title = titles.collect::<Vec<_>>().join(" | ");
        self.words(
            if shown.sides.len() > 1 { 15.0 } else { 19.0 },
            palette.text,
            &title,
        );
        for about in abouts.into_iter().flatten() {
            let rest = [about.about, about.table].join(" ");
            self.words(SIZES[0], palette.faint, rest.trim());
        }
        if document.second.is_none() {
            let scale = tr!(
                "Scale of the curves: {scale}.",
                scale = document.scale.words()
            );
            let source = tr!("Source: {source}", source = document.light.spectrum.source);
            let words = format!("{scale} {source}");
            self.words(SIZES[1], palette.faint, &words);
        }
        self.y += 4.0;
        for sentence in [&shown.sentence, &shown.place, &shown.rendition] {
            self.words(SIZES[0], palette.text, sentence);
        }
        if self.beside > 0.0 {
            self.y = self.y.max(MARGIN + CODE);
            self.beside = 0.0;
        }
        self.y += 12.0;
    }

    /// The model as a QR code at the upper right.
    fn code(&mut self, app: &App) {
        let line = share::short_line(&app.derived().model, app.document().settings.observer);
        if let Some(rows) = share::qr(&line.text) {
            let at = [PAGE[0] - MARGIN - CODE, MARGIN];
            self.body += &share::qr_svg(&rows, at, CODE);
            self.beside = CODE + 12.0;
        }
    }

    /// The figures; of two lights which is better for what beside them.
    fn table(&mut self, shown: &QualityShown, compared: Option<&Compared>) {
        let palette = Palette::of(Theme::Light);
        let step = 1.32 * SIZES[0];
        let (titles, left_out): (_, &[&str]) = match &shown.sides[..] {
            [first, second, ..] => (
                [&first.name, &second.name, said!("which is better for what")],
                &OF_ONE,
            ),
            _ => (
                [
                    said!("measured"),
                    said!("model"),
                    said!("what it says of the light as measured"),
                ],
                &[],
            ),
        };
        for ((x, title), room) in COLUMNS[1..].iter().zip(titles).zip([17, 17, 60]) {
            let title = elided(title, room);
            self.text([MARGIN + x, self.y], SIZES[1], palette.faint, &title);
        }
        let top = self.y;
        let is_told = |row: &&[Row; 2]| {
            let key = row[0].figure.key;
            row[0].value.is_ok() && !LEFT_OUT.contains(&key) && !left_out.contains(&key)
        };
        for row in shown.rows.iter().filter(is_told) {
            self.y += step;
            let [first, other] = row;
            let reading = if left_out.is_empty() {
                &first.reading
            } else {
                ""
            };
            let told = [
                first.figure.title(),
                &first.shown(),
                &other.shown(),
                reading,
            ];
            for (x, words) in COLUMNS.iter().zip(told) {
                // Letters are about half as wide as the font is high.
                let room = (PAGE[0] - 2.0 * MARGIN - x) / (0.52 * SIZES[0]);
                let words = elided(words, room as usize);
                self.text([MARGIN + x, self.y], SIZES[0], palette.text, &words);
            }
        }
        if let Some(compared) = compared {
            let bottom = self.purposes(compared, top);
            self.y = self.y.max(bottom);
        }
        self.y += 16.0;
    }

    /// Which light is better for what, beside the figures; where it ends.
    fn purposes(&mut self, compared: &Compared, top: f64) -> f64 {
        let palette = Palette::of(Theme::Light);
        let (left, size) = (COLUMNS[3], SIZES[1] + 0.5);
        let mut y = top + 3.0;
        for better in &compared.better {
            for line in wrap(&better.words, PAGE[0] - 2.0 * MARGIN - left, size) {
                y += 1.28 * size;
                self.text([MARGIN + left, y], size, palette.text, &line);
            }
            y += 2.0;
        }
        y
    }

    /// Surfaces under the light, each split into measured and model, or into the two lights.
    fn patches(&mut self, app: &App, shown: &QualityShown) {
        let document = app.document();
        let second = document.second.as_ref();
        let of_model = app.derived().patches.as_ref().filter(|_| second.is_none());
        let of_model = of_model.iter().flat_map(|patches| &patches.items);
        let beside = second.and_then(|second| Lit::beside(document, second));
        let halves: Vec<[Swatch; 2]> = of_model
            .map(|patch| [patch.exact_swatch, patch.model_swatch])
            .chain(beside.iter().flatten().map(|lit| lit.swatches))
            .collect();
        let side = (PAGE[0] - 2.0 * MARGIN) / 24.0;
        for (i, halves) in halves.iter().take(24).enumerate() {
            let x = MARGIN + side * i as f64;
            for (part, swatch) in [0.0, 0.5].into_iter().zip(halves) {
                let _ = writeln!(
                    self.body,
                    r#"<rect x="{}" y="{}" width="{}" height="22" fill="{}"/>"#,
                    px(x + part * (side - 2.0)),
                    px(self.y),
                    px(0.5 * (side - 2.0)),
                    swatch.hex()
                );
            }
        }
        self.y += 34.0;
        let ink = Palette::of(Theme::Light).faint;
        let words = match &shown.sides[..] {
            [first, second, ..] => tr!(
                "Surfaces, left under {first}, right under {second}, as eyes used to each see \
                 them.",
                first = first.name,
                second = second.name
            ),
            _ => {
                said!("Surfaces under the light, left as measured, right by the model.").to_owned()
            }
        };
        self.text([MARGIN, self.y], SIZES[1], ink, &words);
        self.y += 6.0;
    }

    /// The numbers of the model, how the file was read, and by what.
    fn foot(&mut self, app: &App) {
        let palette = Palette::of(Theme::Light);
        let document = app.document();
        let light = &document.light.spectrum;
        let mut notes = light.notes.clone();
        match &document.second {
            Some(second) => {
                let sources = [light, &second.spectrum];
                let of = |s: &NamedSpectrum| {
                    tr!(
                        "Source of {name}: {source}",
                        name = s.name,
                        source = s.source
                    )
                };
                notes.splice(0..0, sources.map(of));
            }
            None => {
                let model = &app.derived().model;
                let line = share::short_line(model, document.settings.observer);
                let words = tr!(
                    "Model, {count} numbers, also in the QR code ({cost}): {text}",
                    count = model.numbers(),
                    cost = line.cost(),
                    text = line.text
                );
                self.words(SIZES[1], palette.text, &words);
            }
        }
        let lowest = PAGE[1] - MARGIN - 12.0;
        for note in notes {
            let lines = wrap(&note, PAGE[0] - 2.0 * MARGIN, SIZES[1]).len() as f64;
            if self.y + 1.35 * lines * SIZES[1] < lowest {
                self.words(SIZES[1], palette.faint, &note);
            }
        }
        let by = concat!("Spectral Explorer ", env!("CARGO_PKG_VERSION"));
        let width = text_width(by, SIZES[1]);
        let at = [PAGE[0] - MARGIN - width, PAGE[1] - MARGIN + 8.0];
        self.text(at, SIZES[1], palette.faint, by);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{Command, showing};

    #[test]
    fn the_page_tells_the_figures_of_the_light_and_its_model() {
        let app = App::new();
        let svg = to_svg(&app);
        let tree = roxmltree::Document::parse(&svg).expect("well-formed");
        let words: Vec<&str> = tree.descendants().filter_map(|node| node.text()).collect();
        let shown = QualityShown::of(&app);
        for key in ["cct", "ra", "r9", "rf", "melanopic_der"] {
            let row = shown
                .rows
                .iter()
                .find(|row| row[0].figure.key == key)
                .expect(key);
            for told in [&row[0], &row[1]] {
                assert!(words.contains(&told.shown().as_str()), "{key}");
            }
        }
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn a_page_of_two_lights_has_both_columns_and_says_which_is_better_for_what() {
        let mut app = App::new();
        let second = app.entry("cie_led_1nm/LED-B1").expect("shipped");
        app.apply(Command::Compare(Some(second)));
        let svg = to_svg(&app);
        let tree = roxmltree::Document::parse(&svg).expect("well-formed");
        let texts = tree.descendants().filter(|node| node.has_tag_name("text"));
        let words: Vec<&str> = texts.clone().filter_map(|node| node.text()).collect();
        let whole = words.join(" ");
        let compared = app.compared().expect("two lights");
        for words in compared.better.iter().map(|better| &better.words) {
            assert!(whole.contains(words.as_str()), "{words}");
        }
        assert!(whole.contains(&compared.summary));
        let shown = QualityShown::of(&app);
        for key in ["cct", "ra", "r9", "rf", "melanopic_der"] {
            let row = shown
                .rows
                .iter()
                .find(|row| row[0].figure.key == key)
                .expect(key);
            for told in row {
                assert!(words.contains(&told.shown().as_str()), "{key}");
            }
        }
        for text in texts {
            let y: Option<f64> = text.attribute("y").and_then(|y| y.parse().ok());
            assert!(y.is_none_or(|y| y < PAGE[1]), "{:?}", text.text());
        }
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn the_page_of_any_shipped_light_stays_on_the_paper_and_becomes_a_pdf() {
        for key in [
            "paper/Sodium",
            "cie_illuminants/CIE A",
            "lamps_nist_traditional/Metal Halide",
        ] {
            let app = showing(key);
            let svg = to_svg(&app);
            let tree = roxmltree::Document::parse(&svg).expect("well-formed");
            for text in tree.descendants().filter(|node| node.has_tag_name("text")) {
                let y = text.attribute("y").and_then(|y| y.parse().ok());
                let y: f64 = y.expect("a place");
                assert!(y < PAGE[1], "{key}: {:?}", text.text());
            }
            let pdf = to_pdf(&app).expect("a page");
            assert!(pdf.starts_with(b"%PDF-"));
        }
    }
}
