//! By which lines and bands the makers of light are known, nm in air.
//!
//! Places are those of the shipped table of atomic lines (NIST Atomic Spectra Database), written
//! here to a tenth of a nanometre: the table has the rest. Which of an element's lines a lamp
//! shows is not in the table, whose strengths are qualitative (its mercury at 708 and 709 nm, as
//! strong there as 577 nm, is a trace in lamps, and its neon at 454 to 540 nm is too). Lines of
//! line tubes: NIST Handbook of Basic Atomic Spectroscopic Data, persistent lines. Lamps with
//! sodium and metal halides: J. F. Waymouth, Electric Discharge Lamps, 1971; J. R. Coaton and
//! A. M. Marsden, Lamps and Lighting, 4th ed., 1997. Bands of phosphors: W. M. Yen, S. Shionoya
//! and H. Yamamoto, Phosphor Handbook, 2nd ed., 2007 (Tb3+: 5D4 to 7F6..7F3; Eu3+: 5D0 to
//! 7F1..7F4, in Y2O3 strongest at 611 nm, in YVO4 and its relatives at 615 to 619 nm).

/// A gas or vapour that a line tube is filled with.
pub(super) struct Gas {
    /// Chemical symbol.
    pub symbol: &'static str,
    /// Lines without which it is not there.
    pub strongest: &'static [f64],
    /// Further ones.
    pub others: &'static [f64],
    /// How many peaks it must explain.
    pub least: usize,
}

/// The line tubes but mercury and sodium, which have rules of their own.
pub(super) const GASES: [Gas; 7] = [
    Gas {
        symbol: "H",
        strongest: &[656.3, 486.1],
        others: &[434.0, 410.2],
        least: 3,
    },
    Gas {
        symbol: "He",
        strongest: &[587.6, 501.6],
        others: &[388.9, 447.1, 471.3, 492.2, 667.8, 706.5, 728.1],
        least: 5,
    },
    Gas {
        symbol: "Ne",
        strongest: &[585.2, 640.2],
        others: &[
            594.5, 607.4, 609.6, 614.3, 616.4, 621.7, 626.6, 630.5, 633.4, 638.3, 650.7, 659.9,
            667.8, 692.9, 703.2, 717.4, 724.5, 743.9,
        ],
        least: 7,
    },
    Gas {
        symbol: "Ar",
        strongest: &[763.5, 696.5],
        others: &[415.9, 420.1, 706.7, 727.3, 738.4, 750.4, 772.4],
        least: 4,
    },
    Gas {
        symbol: "Kr",
        strongest: &[557.0, 587.1],
        others: &[427.4, 432.0, 445.4, 446.4, 450.2, 760.2, 769.5],
        least: 4,
    },
    Gas {
        symbol: "Xe",
        strongest: &[467.1, 462.4],
        others: &[450.1, 473.4, 480.7, 484.3, 491.7, 492.3, 712.0, 764.2],
        least: 4,
    },
    Gas {
        symbol: "Cd",
        strongest: &[508.6, 643.8],
        others: &[467.8, 480.0],
        least: 3,
    },
];

/// Mercury's violet, blue, green and yellow; the yellow ones are two.
pub(super) const HG_VIOLET: f64 = 404.7;
pub(super) const HG_BLUE: f64 = 435.8;
pub(super) const HG_GREEN: f64 = 546.1;
pub(super) const HG_YELLOW: [f64; 2] = [577.0, 579.1];
/// Mercury's lines that are a hundredth of its blue one.
pub(super) const HG_FAINT: [f64; 3] = [407.8, 491.6, 690.7];

/// Sodium's yellow pair.
pub(super) const NA_D: [f64; 2] = [589.0, 589.6];
/// Sodium's pairs by which it is known beside the yellow one, the strongest first.
pub(super) const NA_OTHERS: [[f64; 2]; 5] = [
    [568.3, 568.8],
    [497.9, 498.3],
    [615.4, 616.1],
    [514.9, 515.3],
    [466.5, 466.9],
];
/// Those that only lamps of high pressure show.
pub(super) const NA_FAINT: [[f64; 2]; 2] = [[449.4, 449.8], [474.8, 475.2]];
/// The infrared pair, which every lamp with sodium shows.
pub(super) const NA_INFRARED: [f64; 2] = [818.3, 819.5];
/// Potassium, which sodium brings with it.
pub(super) const K_RED: [f64; 2] = [766.5, 769.9];

/// Thallium's green, lithium's red, indium's blue and violet.
pub(super) const TL_GREEN: f64 = 535.0;
pub(super) const LI_RED: f64 = 670.8;
pub(super) const IN_BLUE: f64 = 451.1;
pub(super) const IN_VIOLET: f64 = 410.2;
/// Scandium's groups of lines, each with half its extent.
pub(super) const SC_GROUPS: [(f64, f64); 7] = [
    (391.0, 0.3),
    (402.2, 0.2),
    (474.2, 1.0),
    (508.4, 0.5),
    (569.5, 2.0),
    (624.5, 3.5),
    (630.6, 0.1),
];
/// Those of them without which it is not there, and the one that sodium's 568.5 nm is in.
pub(super) const SC_STRONGEST: [usize; 2] = [2, 3];
pub(super) const SC_YELLOW: usize = 4;
/// Dysprosium: lines without which it is not there, and others.
pub(super) const DY_STRONGEST: [f64; 3] = [421.2, 418.7, 458.9];
pub(super) const DY_OTHERS: [f64; 6] = [416.8, 461.2, 598.9, 625.9, 657.9, 683.5];

/// A phosphor's band.
pub(super) struct BandOf {
    /// Its name's number, nm.
    pub about_nm: f64,
    /// Where its peaks stand, nm.
    pub within_nm: [f64; 2],
}

const fn band(about_nm: f64, from_nm: f64, to_nm: f64) -> BandOf {
    BandOf {
        about_nm,
        within_nm: [from_nm, to_nm],
    }
}

/// Terbium: the green band is the strongest, the first and the others follow.
pub(super) const TB: [BandOf; 4] = [
    band(490.0, 484.0, 497.0),
    band(545.0, 541.0, 551.0),
    band(585.0, 581.0, 589.0),
    band(620.0, 617.5, 624.0),
];
/// Europium in yttrium oxide, the red of tubes; the third is the strongest.
pub(super) const EU_OXIDE: [BandOf; 6] = [
    band(593.0, 589.0, 600.0),
    band(630.0, 624.0, 634.0),
    band(611.0, 608.5, 617.0),
    band(650.0, 648.0, 655.0),
    band(690.0, 685.0, 697.0),
    band(709.0, 704.0, 713.0),
];
/// Europium in yttrium vanadate, the red of coated mercury lamps; the second is the strongest.
pub(super) const EU_VANADATE: [BandOf; 4] = [
    band(593.0, 590.0, 600.0),
    band(619.0, 609.0, 623.0),
    band(650.0, 648.0, 655.0),
    band(700.0, 696.0, 705.0),
];
/// Where europium has no band, and other red phosphors, neon and lithium stand, nm.
pub(super) const NO_EU: [f64; 2] = [635.0, 646.0];
