//! All figures of a light as rows.

use std::sync::LazyLock;

use crate::{
    app::{document::first_light, entry::bundled_entries, tint, verdicts},
    color::quality::{ALPHA_OPIC_WORDS, Figures, NoFigure, RENDERING_SAMPLES},
};

use super::{measured::light_of, reading, row::Row};

/// Why there is no TLCI.
pub const TLCI: &str =
    "TLCI is left out: the camera and patch tables of EBU Tech 3355 are not openly licensed";

const SAMPLE_KEYS: [(&str, &str); RENDERING_SAMPLES] = [
    ("r1", "R1"),
    ("r2", "R2"),
    ("r3", "R3"),
    ("r4", "R4"),
    ("r5", "R5"),
    ("r6", "R6"),
    ("r7", "R7"),
    ("r8", "R8"),
    ("r9", "R9"),
    ("r10", "R10"),
    ("r11", "R11"),
    ("r12", "R12"),
    ("r13", "R13"),
    ("r14", "R14"),
    ("r15", "R15"),
];

const CRI: &str = "CIE 13.3-1995, 1 nm, samples by Sprague, CCT not rounded";
const R15: &str = "JIS Z 8726: the skin complexion of the CIE's data set of 2024, as CIE 13.3";
const TM_30: &str = "ANSI/IES TM-30-20 (CIE 224:2017), 99 samples of 1 nm, 380-780 nm";
const S_026: &str = "CIE S 026:2018, over that of D65, 380-780 nm";
const OF_SSI: &str = "SMPTE ST 2122, 375-675 nm";
const OF_SHAPE: &str = "on whole nm, 360-830";

/// Every figure, in the order of a report.
pub fn rows(figures: &Figures) -> Vec<Row> {
    let mut rows = colour_rows(figures);
    rows.extend(rendering_rows(figures));
    rows.extend(effect_rows(figures));
    rows.extend(spectrum_rows(figures));
    rows
}

/// Every figure by its key: rows of a shipped light.
pub fn known() -> &'static [Row] {
    static KNOWN: LazyLock<Vec<Row>> = LazyLock::new(|| {
        let (light, measured) = light_of(&first_light(bundled_entries()).spectrum);
        rows(&Figures::of(&light, measured))
    });
    &KNOWN
}

/// A row whose reading is formed of its number.
fn row(
    [key, title, unit]: [&'static str; 3],
    digits: usize,
    method: &'static str,
    value: Result<f64, NoFigure>,
    reading: impl Fn(f64) -> String,
) -> Row {
    let reading = value
        .as_ref()
        .map_or_else(|_| String::new(), |v| reading(*v));
    Row {
        key,
        title,
        unit,
        digits,
        method,
        value: value.map_err(|why| why.to_string()),
        reading,
    }
}

fn nothing(_: f64) -> String {
    String::new()
}

fn colour_rows(figures: &Figures) -> Vec<Row> {
    const OHNO: &str = "Ohno 2013, CIE 1960 uv, c2 = 1.4388e-2 m K";
    const HUE: &str = "from E, CIE 1931 locus of 1 nm; complementary negative";
    let kelvin = figures.cct.clone().map(|cct| cct.kelvin);
    let duv = figures.cct.clone().map(|cct| cct.duv);
    let dominant = figures.dominant.clone();
    vec![
        row(["cct", "CCT", "K"], 0, OHNO, kelvin, |_| {
            let cct = figures.cct.as_ref();
            cct.map_or_else(|_| String::new(), |cct| reading::of_cct(figures, *cct))
        }),
        row(["duv", "Duv", ""], 4, OHNO, duv, |_| {
            let cct = figures.cct.as_ref();
            cct.map_or_else(|_| String::new(), |cct| tint::duv_words(*cct))
        }),
        row(
            ["dominant_nm", "Dominant wavelength", "nm"],
            1,
            HUE,
            dominant.clone().and_then(|found| found.nm),
            reading::of_dominant,
        ),
        row(
            ["purity", "Purity", ""],
            3,
            HUE,
            dominant.map(|found| found.purity),
            reading::of_purity,
        ),
    ]
}

fn rendering_rows(figures: &Figures) -> Vec<Row> {
    let ra = figures.rendering.clone().map(|found| found.ra);
    let mut rows = vec![row(["ra", "Ra", ""], 1, CRI, ra, |_| {
        let found = figures.rendering.as_ref();
        found.map_or_else(|_| String::new(), reading::of_ra)
    })];
    for (index, (key, title)) in SAMPLE_KEYS.into_iter().enumerate() {
        let value = figures.rendering.clone().map(|f| f.samples[index].index);
        let method = if index == 14 { R15 } else { CRI };
        rows.push(row([key, title, ""], 1, method, value, |value| {
            reading::of_sample(figures, index + 1, value)
        }));
    }
    let rf = figures.fidelity.as_ref().map(|found| found.rf);
    let rg = figures.fidelity.as_ref().map(|found| found.rg);
    let rf = rf.map_err(Clone::clone);
    let samples = figures.fidelity.as_ref().map(|found| &found.samples[..]);
    rows.push(row(["rf", "Rf", ""], 1, TM_30, rf, |rf| {
        reading::of_rf(rf, samples.unwrap_or_default())
    }));
    let rg = rg.map_err(Clone::clone);
    rows.push(row(["rg", "Rg", ""], 1, TM_30, rg, |rg| {
        verdicts::of_rg(rg)
    }));
    let own = figures.similarity.clone().and_then(|found| found.of_cct);
    let reference = own.clone().map(|(reference, _)| reference.to_string());
    let reference = reference.unwrap_or_default();
    let value = own.map(|(_, value)| value);
    rows.push(row(["ssi", "SSI", ""], 0, OF_SSI, value, |value| {
        verdicts::of_ssi(value, &reference)
    }));
    rows.push(Row {
        key: "tlci",
        title: "TLCI",
        unit: "",
        digits: 0,
        method: "EBU R 137",
        value: Err(TLCI.to_owned()),
        reading: String::new(),
    });
    rows
}

fn effect_rows(figures: &Figures) -> Vec<Row> {
    const PPFD: &str = "photons of 400-700 nm (ePPFD 400-750), both ends in";
    const ALPHA: [[&str; 3]; 5] = [
        ["s_cone", "S-cone-opic DER", ""],
        ["m_cone", "M-cone-opic DER", ""],
        ["l_cone", "L-cone-opic DER", ""],
        ["rhodopic", "Rhodopic DER", ""],
        ["melanopic_der", "Melanopic DER", ""],
    ];
    let singles = figures.singles().map(|(single, value)| {
        let words = [single.key, single.title, single.unit];
        let reading = reading::of_single(single);
        row(words, single.digits, single.method, value.clone(), reading)
    });
    let mut rows: Vec<Row> = singles.collect();
    debug_assert_eq!(ALPHA.len(), ALPHA_OPIC_WORDS.len());
    for (index, words) in ALPHA.into_iter().enumerate() {
        let value = figures.alpha_opic.clone().map(|found| found.der[index]);
        let melanopic = index + 1 == ALPHA.len();
        rows.push(row(words, 3, S_026, value, |der| {
            if melanopic {
                reading::of_melanopic(der)
            } else {
                String::new()
            }
        }));
    }
    let ppfd = figures.photons.clone().map(|found| found.ppfd);
    let eppfd = figures.photons.clone().map(|found| found.eppfd);
    let unit = "µmol/(m² s)";
    rows.push(row(
        ["ppfd_per_100lx", "PPFD of 100 lx", unit],
        3,
        PPFD,
        ppfd,
        nothing,
    ));
    rows.push(row(
        ["eppfd_per_100lx", "ePPFD of 100 lx", unit],
        3,
        PPFD,
        eppfd,
        nothing,
    ));
    rows.extend(absolute_rows(figures));
    rows
}

/// Rows that need the values to be in a unit of power.
fn absolute_rows(figures: &Figures) -> Vec<Row> {
    const MEASURED: &str = "683.002 sum(P V) of the values in their own unit";
    let (key, title, unit) = match &figures.absolute {
        Ok(found) => match found.what.photometric_unit() {
            "lx" => ("lux", "Illuminance", "lx"),
            "cd/m²" => ("luminance", "Luminance", "cd/m²"),
            "lm" => ("lumens", "Luminous flux", "lm"),
            _ => ("candela", "Luminous intensity", "cd"),
        },
        Err(_) => ("lux", "Illuminance", "lx"),
    };
    let value = figures.absolute.clone().map(|found| found.photometric);
    let mut rows = vec![row([key, title, unit], 1, MEASURED, value.clone(), nothing)];
    if key == "lux" {
        let edi = value.and_then(|lux| Ok(figures.alpha_opic.clone()?.melanopic_edi(lux)));
        let ppfd = figures.absolute.clone().map(|found| found.ppfd);
        rows.push(row(
            ["melanopic_edi", "Melanopic EDI", "lx"],
            1,
            "CIE S 026:2018: DER x lx",
            edi,
            |lux| {
                let reaches = if lux >= 250.0 { "reaches" } else { "below" };
                format!("{reaches} the 250 lx at the eye advised by day (Brown et al. 2022)")
            },
        ));
        rows.push(row(
            ["ppfd", "PPFD", "µmol/(m² s)"],
            2,
            "photons of 400-700 nm, both ends in",
            ppfd,
            nothing,
        ));
    }
    rows
}

fn spectrum_rows(figures: &Figures) -> Vec<Row> {
    let shape = figures.shape.clone();
    let peak = shape.clone().and_then(|s| s.peak);
    let at_end = peak.as_ref().is_ok_and(|peak| peak.is_at_end);
    let peak = peak.map(|peak| f64::from(peak.nm));
    let centroid = shape.clone().and_then(|s| s.centroid_nm);
    let width = shape.and_then(|s| s.width).map(|width| width.fwhm_nm);
    vec![
        row(["peak_nm", "Peak", "nm"], 0, OF_SHAPE, peak, |_| {
            if at_end {
                "where the table or the visible ends: it may be higher beyond".to_owned()
            } else {
                String::new()
            }
        }),
        row(
            ["centroid_nm", "Centroid", "nm"],
            1,
            OF_SHAPE,
            centroid,
            nothing,
        ),
        row(
            ["fwhm_nm", "Width at half height", "nm"],
            1,
            OF_SHAPE,
            width,
            nothing,
        ),
    ]
}
