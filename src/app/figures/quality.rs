//! Figures of light quality, of measured lights and of models, and where JSON has them.

use std::sync::LazyLock;

use super::{Figure, NUMBER, Unit, Words, reading, unit};
use crate::{
    app::{tint, verdicts},
    color::quality::{Figures, NoFigure, Radiometric, SINGLES, Single},
    io::Quantity,
};

/// The reason for no TLCI.
pub const TLCI: Words = later!(
    "TLCI is left out: the camera and sample tables of EBU Tech 3355 are not openly licensed"
);

const CRI: Words = later!("CIE 13.3-1995, 1 nm, samples by Sprague, CCT not rounded");
const R15: Words =
    later!("JIS Z 8726: the skin complexion of the CIE's data set of 2024, as CIE 13.3");
const TM_30: Words = later!("ANSI/IES TM-30-20 (CIE 224:2017), 99 samples of 1 nm, 380-780 nm");
const S_026: Words = later!("CIE S 026:2018, over that of D65, 380-780 nm");
const OF_SSI: Words = "SMPTE ST 2122, 375-675 nm";
const OF_SHAPE: Words = later!("on whole nm, 360-830");
const OHNO: Words = "Ohno 2013, CIE 1960 uv, c2 = 1.4388e-2 m K";
const HUE: Words = later!("from E, CIE 1931 locus of 1 nm; complementary negative");
const PPFD: Words = later!("photons of 400-700 nm (ePPFD 400-750), both ends in");
const MEASURED: Words = later!("683.002 sum(P V) of the values in their own unit");
const XYZ: Words = "CIE 1931, Y = 100";
const XY: Words = later!("CIE 1931 chromaticity x, y");
const UV: Words = later!("CIE 1976 chromaticity u', v'");

/// A figure of light quality, or why there is none.
type OfLight = fn(&Figures) -> Result<f64, NoFigure>;

/// The source of a value.
#[derive(Clone, Copy, Debug)]
enum Of {
    Figures(OfLight),
    Single(&'static Single),
}

/// A figure of light quality and how it is computed.
#[derive(Clone, Copy, Debug)]
pub struct QualityFigure {
    /// Without a title it stands in files alone, without a key in JSON alone.
    pub figure: Figure,
    /// Its places in JSON; a place that several figures have is a list of them.
    pub json: &'static [Words],
    /// In JSON only where everything is asked for.
    pub is_detail: bool,
    /// Ours times this is an instrument's own value of a quantity; `None` for other quantities.
    pub measured_as: fn(&Quantity) -> Option<f64>,
    /// Lights that the figure is of.
    pub applies: fn(&Figures) -> bool,
    of: Of,
    reading: fn(&Figures, f64) -> String,
}

/// A row: key, title and unit; decimals, method, value.
const fn row(
    [key, title]: [Words; 2],
    unit: Unit,
    digits: usize,
    method: Words,
    of: OfLight,
) -> QualityFigure {
    QualityFigure {
        figure: Figure {
            key,
            title,
            short: title,
            unit,
            digits,
            meaning: method,
            ..NUMBER
        },
        json: &[],
        is_detail: false,
        measured_as: |_| None,
        applies: |_| true,
        of: Of::Figures(of),
        reading: |_, _| String::new(),
    }
}

impl QualityFigure {
    /// The value, or why there is none.
    pub fn value(&self, figures: &Figures) -> Result<f64, NoFigure> {
        match self.of {
            Of::Figures(of) => of(figures),
            Of::Single(single) => figures.single(single),
        }
    }

    /// Meaning of a value in plain words, empty where there is nothing to add.
    pub fn reading(&self, figures: &Figures, value: f64) -> String {
        match self.of {
            Of::Figures(_) => (self.reading)(figures, value),
            Of::Single(single) => reading::of_single(single)(value),
        }
    }

    const fn json(self, json: &'static [Words]) -> Self {
        Self { json, ..self }
    }

    const fn detail(self, json: &'static [Words]) -> Self {
        Self {
            json,
            is_detail: true,
            ..self
        }
    }

    const fn read(self, reading: fn(&Figures, f64) -> String) -> Self {
        Self { reading, ..self }
    }

    const fn measured_as(self, measured_as: fn(&Quantity) -> Option<f64>) -> Self {
        Self {
            measured_as,
            ..self
        }
    }

    const fn of_lights(self, applies: fn(&Figures) -> bool) -> Self {
        Self { applies, ..self }
    }
}

/// The factor 1 for one quantity of instruments.
fn same(quantity: &Quantity, own: &Quantity) -> Option<f64> {
    (quantity == own).then_some(1.0)
}

/// One of R1 to R15.
const fn sample<const N: usize>(names: [Words; 2]) -> QualityFigure {
    let method = if N == 15 { R15 } else { CRI };
    row(names, Unit::NONE, 1, method, |f| {
        Ok(f.rendering.as_ref().map_err(Clone::clone)?.samples[N - 1].index)
    })
    .json(&["r"])
    .measured_as(|q| same(q, &Quantity::R(N as u8)))
    .read(|f, index| reading::of_sample(f, N, index))
}

/// An alpha-opic ratio to D65.
const fn ratio<const I: usize>(names: [Words; 2]) -> QualityFigure {
    row(names, Unit::NONE, 3, S_026, |f| {
        Ok(f.alpha_opic.clone()?.der[I])
    })
}

/// A coordinate of the colour, which has no row of its own on screen.
const fn place(key: Words, digits: usize, method: Words, of: OfLight) -> QualityFigure {
    row([key, ""], Unit::NONE, digits, method, of)
}

/// What values in their own unit measure: the figure of one quantity.
const fn absolute<const WHAT: usize>(names: [Words; 2], unit: Unit) -> QualityFigure {
    row(names, unit, 1, MEASURED, |f| {
        Ok(f.absolute.clone()?.photometric)
    })
    .detail(&["absolute.value"])
    .of_lights(|f| what_is_measured(f) == WHAT)
}

/// Place of what the values measure; an irradiance, as most instruments do, where that is unknown.
fn what_is_measured(figures: &Figures) -> usize {
    let what = figures.absolute.as_ref().map(|found| found.what);
    match what.unwrap_or(Radiometric::Irradiance) {
        Radiometric::Irradiance => 0,
        Radiometric::Radiance => 1,
        Radiometric::Power => 2,
        Radiometric::Intensity => 3,
    }
}

/// Photons and melanopic light on a square metre are only of what falls on one.
fn is_on_a_surface(figures: &Figures) -> bool {
    what_is_measured(figures) == 0
}

const fn of_unit(words: Words, tail: Words) -> Unit {
    unit(words, tail, 1.0)
}

const PHOTONS: Unit = of_unit("µmol/(m² s)", " µmol/(m² s)");
const LUX: Unit = of_unit("lx", " lx");

/// Every figure of light quality, in the order of a report.
pub static OF_QUALITY: LazyLock<Vec<QualityFigure>> = LazyLock::new(|| {
    let before = BEFORE_SINGLES.iter().copied();
    let all: &'static [Single] = &SINGLES;
    let singles = all.iter().map(single);
    let behind = BEHIND_SINGLES.iter().copied();
    before.chain(singles).chain(behind).collect()
});

/// The row of a figure of one number.
fn single(single: &'static Single) -> QualityFigure {
    let unit = match single.unit {
        "" => Unit::NONE,
        // Once a program and figure.
        sign => of_unit(sign, Box::leak(format!(" {sign}").into_boxed_str())),
    };
    let names = [single.key, single.title];
    let row = row(names, unit, single.digits, single.method, |_| {
        Err(NoFigure::LeftOut(""))
    });
    QualityFigure {
        of: Of::Single(single),
        json: std::slice::from_ref(&single.key),
        ..row
    }
}

/// The figures before those of one number.
static BEFORE_SINGLES: &[QualityFigure] = &[
    place("", 3, XYZ, |f| Ok(f.xyz.clone()?.x)).json(&["xyz"]),
    place("", 3, XYZ, |f| Ok(f.xyz.clone()?.y)).json(&["xyz"]),
    place("", 3, XYZ, |f| Ok(f.xyz.clone()?.z)).json(&["xyz"]),
    place("x", 4, XY, |f| Ok(f.xy[0].clone()?[0]))
        .json(&["xy"])
        .measured_as(|q| same(q, &Quantity::ChromaticityX)),
    place("y", 4, XY, |f| Ok(f.xy[0].clone()?[1]))
        .json(&["xy"])
        .measured_as(|q| same(q, &Quantity::ChromaticityY)),
    place("u_prime", 4, UV, |f| Ok(f.uv.clone()?[0]))
        .json(&["uv"])
        .measured_as(|q| same(q, &Quantity::UPrime)),
    place("v_prime", 4, UV, |f| Ok(f.uv.clone()?[1]))
        .json(&["uv"])
        .measured_as(|q| same(q, &Quantity::VPrime)),
    row(["cct", "CCT"], Unit::KELVIN, 0, OHNO, |f| {
        Ok(f.cct.clone()?.kelvin)
    })
    .json(&["cct"])
    .measured_as(|q| same(q, &Quantity::Cct))
    .read(|f, _| match &f.cct {
        Ok(cct) => reading::of_cct(f, *cct),
        Err(_) => String::new(),
    }),
    row(["duv", "Duv"], Unit::NONE, 4, OHNO, |f| {
        Ok(f.cct.clone()?.duv)
    })
    .json(&["duv"])
    .measured_as(|q| same(q, &Quantity::Duv))
    .read(|f, _| match &f.cct {
        Ok(cct) => tint::duv_words(*cct),
        Err(_) => String::new(),
    }),
    row(
        ["dominant_nm", later!("Dominant wavelength")],
        Unit::NANOMETRE,
        1,
        HUE,
        |f| f.dominant.clone()?.nm,
    )
    .json(&["dominant_nm"])
    .measured_as(|q| same(q, &Quantity::DominantNm))
    .read(|_, nm| reading::of_dominant(nm)),
    row(["purity", later!("Purity")], Unit::NONE, 3, HUE, |f| {
        Ok(f.dominant.clone()?.purity)
    })
    .json(&["purity"])
    .measured_as(|q| (*q == Quantity::Purity).then_some(100.0))
    .read(|_, purity| reading::of_purity(purity)),
    row(["ra", "Ra"], Unit::NONE, 1, CRI, |f| {
        Ok(f.rendering.as_ref().map_err(Clone::clone)?.ra)
    })
    .json(&["ra"])
    .measured_as(|q| same(q, &Quantity::Ra))
    .read(|f, _| match &f.rendering {
        Ok(found) => reading::of_ra(found),
        Err(_) => String::new(),
    }),
    sample::<1>(["r1", "R1"]),
    sample::<2>(["r2", "R2"]),
    sample::<3>(["r3", "R3"]),
    sample::<4>(["r4", "R4"]),
    sample::<5>(["r5", "R5"]),
    sample::<6>(["r6", "R6"]),
    sample::<7>(["r7", "R7"]),
    sample::<8>(["r8", "R8"]),
    sample::<9>(["r9", "R9"]),
    sample::<10>(["r10", "R10"]),
    sample::<11>(["r11", "R11"]),
    sample::<12>(["r12", "R12"]),
    sample::<13>(["r13", "R13"]),
    sample::<14>(["r14", "R14"]),
    sample::<15>(["r15", "R15"]),
    row(["rf", "Rf"], Unit::NONE, 1, TM_30, |f| {
        Ok(f.fidelity.as_ref().map_err(Clone::clone)?.rf)
    })
    .json(&["rf"])
    .measured_as(|q| same(q, &Quantity::Rf))
    .read(|f, rf| match &f.fidelity {
        Ok(found) => reading::of_rf(rf, &found.samples),
        Err(_) => String::new(),
    }),
    row(["rg", "Rg"], Unit::NONE, 1, TM_30, |f| {
        Ok(f.fidelity.as_ref().map_err(Clone::clone)?.rg)
    })
    .json(&["rg"])
    .measured_as(|q| same(q, &Quantity::Rg))
    .read(|_, rg| verdicts::of_rg(rg)),
    row(["ssi", "SSI"], Unit::NONE, 0, OF_SSI, |f| {
        Ok(f.similarity.clone()?.of_cct?.1)
    })
    .json(&["ssi.value"])
    .read(|f, value| {
        let own = f
            .similarity
            .as_ref()
            .ok()
            .and_then(|s| s.of_cct.as_ref().ok());
        let reference = own.map_or_else(String::new, |(reference, _)| reference.to_string());
        verdicts::of_ssi(value, &reference)
    }),
    place("", 0, OF_SSI, |f| Ok(f.similarity.clone()?.p3200)).json(&["ssi.p3200"]),
    place("", 0, OF_SSI, |f| Ok(f.similarity.clone()?.d55)).json(&["ssi.d55"]),
    place("", 0, OF_SSI, |f| Ok(f.similarity.clone()?.d65)).json(&["ssi.d65"]),
    row(["tlci", "TLCI"], Unit::NONE, 0, "EBU R 137", |_| {
        Err(NoFigure::LeftOut(TLCI))
    }),
];

/// The figures behind those of one number.
static BEHIND_SINGLES: &[QualityFigure] = &[
    ratio::<0>(["s_cone", later!("S-cone-opic DER")]).json(&["alphaopic.s_cone"]),
    ratio::<1>(["m_cone", later!("M-cone-opic DER")]).json(&["alphaopic.m_cone"]),
    ratio::<2>(["l_cone", later!("L-cone-opic DER")]).json(&["alphaopic.l_cone"]),
    ratio::<3>(["rhodopic", later!("Rhodopic DER")]).json(&["alphaopic.rhodopic"]),
    ratio::<4>(["melanopic_der", later!("Melanopic DER")])
        .json(&["melanopic_der", "alphaopic.melanopic"])
        .read(|_, der| reading::of_melanopic(der)),
    row(
        ["ppfd_per_100lx", later!("PPFD of 100 lx")],
        PHOTONS,
        3,
        PPFD,
        |f| Ok(f.photons.clone()?.ppfd),
    )
    .json(&["ppfd_per_100lx"]),
    row(
        ["eppfd_per_100lx", later!("ePPFD of 100 lx")],
        PHOTONS,
        3,
        PPFD,
        |f| Ok(f.photons.clone()?.eppfd),
    )
    .detail(&["eppfd_per_100lx"]),
    absolute::<0>(["lux", later!("Illuminance")], LUX),
    absolute::<1>(
        ["luminance", later!("Luminance")],
        of_unit("cd/m²", " cd/m²"),
    ),
    absolute::<2>(["lumens", later!("Luminous flux")], of_unit("lm", " lm")),
    absolute::<3>(
        ["candela", later!("Luminous intensity")],
        of_unit("cd", " cd"),
    ),
    place("", 3, later!("sum(P) of 360-830 nm"), |f| {
        Ok(f.absolute.clone()?.radiometric)
    })
    .detail(&["absolute.radiometric"]),
    row(
        ["melanopic_edi", later!("Melanopic EDI")],
        LUX,
        1,
        "CIE S 026:2018: DER x lx",
        |f| {
            let lux = f.absolute.clone()?.photometric;
            Ok(f.alpha_opic.clone()?.melanopic_edi(lux))
        },
    )
    .detail(&["absolute.melanopic_edi"])
    .of_lights(is_on_a_surface)
    .read(|_, lux| reading::of_edi(lux)),
    row(
        ["ppfd", "PPFD"],
        PHOTONS,
        2,
        later!("photons of 400-700 nm, both ends in"),
        |f| Ok(f.absolute.clone()?.ppfd),
    )
    .detail(&["absolute.ppfd"])
    .of_lights(is_on_a_surface),
    place("", 2, later!("photons of 400-750 nm, both ends in"), |f| {
        Ok(f.absolute.clone()?.eppfd)
    })
    .detail(&["absolute.eppfd"])
    .of_lights(is_on_a_surface),
    row(
        ["peak_nm", later!("Peak")],
        Unit::NANOMETRE,
        0,
        OF_SHAPE,
        |f| Ok(f64::from(f.shape.clone()?.peak?.nm)),
    )
    .detail(&[])
    .read(|f, _| reading::of_peak(f)),
    row(
        ["centroid_nm", later!("Centroid")],
        Unit::NANOMETRE,
        1,
        OF_SHAPE,
        |f| f.shape.clone()?.centroid_nm,
    )
    .detail(&["centroid_nm"]),
    row(
        ["fwhm_nm", later!("Width at half height")],
        Unit::NANOMETRE,
        1,
        OF_SHAPE,
        |f| Ok(f.shape.clone()?.width?.fwhm_nm),
    )
    .detail(&["fwhm_nm"]),
];

/// The figure that an instrument has computed too, and the factor from ours to its value.
pub fn of_quantity(quantity: &Quantity) -> Option<(&'static QualityFigure, f64)> {
    let mut all = OF_QUALITY.iter();
    all.find_map(|row| Some((row, (row.measured_as)(quantity)?)))
}
