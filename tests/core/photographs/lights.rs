//! Lamps as they are drawn: lines, bands and glow, no two of a kind alike.

use super::dice::Dice;

/// A kind of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    Cfl,
    Tube,
    Hg,
    Hps,
    Ne,
    Ar,
    Kr,
    Xe,
    H,
    He,
    Sky,
    Led,
    RgbLed,
    Plant,
    Halogen,
    Lps,
    MetalHalide,
}

use Kind::{
    Ar, Cfl, H, Halogen, He, Hg, Hps, Kr, Led, Lps, MetalHalide, Ne, Plant, RgbLed, Sky, Tube, Xe,
};

impl Kind {
    /// With a table of their own, by their share in the sets, and without.
    pub(crate) const LAMPS: [Self; 14] = [
        Cfl, Cfl, Cfl, Cfl, Tube, Hg, Hps, Ne, Ar, Kr, Xe, H, He, Sky,
    ];
    pub(crate) const OTHERS: [Self; 6] = [Led, RgbLed, Plant, Halogen, Lps, MetalHalide];

    /// The lamp that it is to be found as.
    pub(crate) fn lamp(self) -> Option<&'static str> {
        Some(match self {
            Cfl => "fluorescent",
            Tube | Hg => "mercury",
            Hps => "sodium",
            Ne => "neon",
            Ar => "argon",
            Kr => "krypton",
            Xe => "xenon",
            H => "hydrogen",
            He => "helium",
            Sky => "daylight",
            _ => return None,
        })
    }
}

/// Its first wavelength, its step and its count: a grid finer than any slit.
pub(crate) const GRID: (f64, f64, usize) = (370.0, 0.2, 2101);

/// Light as lines `[nm, power, own fwhm]`, bands of the same form by height, and dark lines.
#[derive(Clone, Debug, Default)]
pub(crate) struct Light {
    lines: Vec<[f64; 3]>,
    bands: Vec<[f64; 3]>,
    dark: Vec<[f64; 3]>,
    kelvin: Option<f64>,
}

const MERCURY: [[f64; 2]; 12] = [
    [404.66, 0.22],
    [407.78, 0.03],
    [435.83, 1.0],
    [491.61, 0.02],
    [546.07, 0.95],
    [576.96, 0.2],
    [579.07, 0.21],
    [623.44, 0.006],
    [671.64, 0.006],
    [690.75, 0.015],
    [365.02, 0.3],
    [433.92, 0.03],
];
/// Terbium and europium in their phosphors: nm, power, fwhm.
const PHOSPHORS: [[f64; 3]; 32] = [
    [485.2, 0.12, 2.5],
    [487.8, 0.42, 2.0],
    [491.2, 0.25, 2.4],
    [493.9, 0.12, 2.4],
    [541.4, 0.55, 1.4],
    [542.6, 0.85, 1.4],
    [544.4, 0.55, 1.6],
    [548.9, 0.35, 2.2],
    [551.0, 0.1, 2.6],
    [581.7, 0.2, 2.2],
    [584.2, 0.28, 1.8],
    [587.3, 0.33, 1.8],
    [589.2, 0.14, 2.0],
    [592.9, 0.2, 1.6],
    [599.6, 0.18, 1.4],
    [611.3, 2.2, 1.3],
    [613.2, 0.2, 1.6],
    [617.0, 0.1, 2.2],
    [619.5, 0.13, 1.8],
    [622.0, 0.16, 2.2],
    [624.8, 0.08, 2.4],
    [627.2, 0.12, 1.8],
    [630.9, 0.25, 2.0],
    [647.0, 0.05, 2.2],
    [650.5, 0.12, 1.8],
    [662.6, 0.09, 1.8],
    [667.4, 0.03, 1.8],
    [687.4, 0.11, 2.0],
    [693.4, 0.08, 2.0],
    [706.9, 0.1, 1.8],
    [709.2, 0.15, 1.8],
    [712.4, 0.05, 2.4],
];

fn lines(of: &[[f64; 2]], scale: f64, sigma: f64, dice: &mut Dice) -> Vec<[f64; 3]> {
    (of.iter())
        .map(|[nm, power]| [*nm, scale * power * dice.factor(sigma), 0.05])
        .collect()
}

/// The lines of an element: places of the shipped list, strengths of a glow lamp as landmarks have
/// them, which are not those of tables.
fn of_tube(lamp: &str, element: &str, dice: &mut Dice) -> Vec<[f64; 3]> {
    let landmarks: serde_json::Value =
        serde_json::from_str(include_str!("../../../presets/photograph_landmarks.json"))
            .expect("landmarks");
    let atoms: serde_json::Value =
        serde_json::from_str(include_str!("../../../presets/atomic_lines.json")).expect("lines");
    let items = atoms["items"].as_array().expect("items");
    let item = items.iter().find(|i| i["element"] == element);
    let known: Vec<f64> = (item.into_iter())
        .flat_map(|item| item["wavelengths"].as_array().into_iter().flatten())
        .filter_map(serde_json::Value::as_f64)
        .collect();
    let table = landmarks["lamps"][lamp]["1.0"].as_array().expect("a table");
    (table.iter())
        .map(|row| [0, 2, 3, 4].map(|k| row[k].as_f64().expect("a figure")))
        .filter(|row| row[3] == 0.0)
        .map(|[nm, chance, strength, _]| {
            let away = |l: &f64| (l - nm).abs();
            let nearest = known
                .iter()
                .copied()
                .min_by(|a, b| away(a).total_cmp(&away(b)));
            let nm = nearest.filter(|l| away(l) < 0.4).unwrap_or(nm);
            [nm, strength * chance * dice.factor(0.45), 0.05]
        })
        .collect()
}

impl Light {
    /// One of a kind.
    pub(crate) fn of(kind: Kind, dice: &mut Dice) -> Self {
        match kind {
            Cfl => Self::fluorescent(dice),
            Tube => Self {
                lines: lines(&MERCURY, dice.between(0.6, 1.6), 0.15, dice),
                bands: vec![
                    [dice.between(475.0, 490.0), dice.between(0.04, 0.12), 130.0],
                    [dice.between(572.0, 590.0), dice.between(0.1, 0.22), 78.0],
                ],
                ..Self::default()
            },
            Hg => Self::mercury(dice),
            Hps => Self::sodium(dice),
            Ne => Self::glow("neon", "Ne", dice),
            Ar => Self::glow("argon", "Ar", dice),
            Kr => Self::glow("krypton", "Kr", dice),
            Xe => Self::glow("xenon", "Xe", dice),
            He => Self::glow("helium", "He", dice),
            H => {
                let mut light = Self::glow("hydrogen", "H", dice);
                // The many faint lines of the molecule.
                for _ in 0..40 {
                    let nm = dice.between(420.0, 680.0);
                    light.lines.push([nm, 0.02 * dice.roll(), 0.1]);
                }
                light
            }
            Sky => Self::sky(dice),
            Led => Self {
                bands: vec![
                    [
                        dice.between(440.0, 460.0),
                        dice.between(0.5, 1.2),
                        dice.between(18.0, 26.0),
                    ],
                    [
                        dice.between(540.0, 580.0),
                        dice.between(0.4, 1.0),
                        dice.between(95.0, 130.0),
                    ],
                    [
                        dice.between(600.0, 630.0),
                        dice.between(0.0, 0.7),
                        dice.between(70.0, 95.0),
                    ],
                ],
                ..Self::default()
            },
            RgbLed => Self {
                bands: [(455.0, 20.0), (525.0, 32.0), (632.0, 17.0)]
                    .map(|(nm, wide)| {
                        let nm = nm + dice.between(-8.0, 8.0);
                        [nm, dice.between(0.3, 1.0), wide * dice.factor(0.1)]
                    })
                    .to_vec(),
                ..Self::default()
            },
            Plant => Self {
                bands: vec![
                    [dice.between(445.0, 458.0), dice.between(0.3, 1.0), 20.0],
                    [dice.between(640.0, 662.0), dice.between(0.5, 1.0), 18.0],
                    [560.0, dice.between(0.0, 0.3), 120.0],
                    [dice.between(725.0, 740.0), dice.between(0.0, 0.5), 25.0],
                ],
                ..Self::default()
            },
            Halogen => Self {
                kelvin: Some(dice.between(2500.0, 3300.0)),
                ..Self::default()
            },
            Lps => Self {
                lines: vec![[588.995, 1.0, 0.05], [589.592, 0.9, 0.05]],
                bands: vec![[589.3, dice.between(0.0, 0.002), 30.0]],
                ..Self::default()
            },
            MetalHalide => Self::metal_halide(dice),
        }
    }

    /// Lines and bands as they are given.
    pub(crate) fn made(lines: Vec<[f64; 3]>, bands: Vec<[f64; 3]>) -> Self {
        Self {
            lines,
            bands,
            ..Self::default()
        }
    }

    /// A bulb of so many K.
    pub(crate) fn bulb(kelvin: f64) -> Self {
        Self {
            kelvin: Some(kelvin),
            ..Self::default()
        }
    }

    fn fluorescent(dice: &mut Dice) -> Self {
        let (green, red) = (dice.factor(0.3), dice.factor(0.3));
        let mut all = lines(&MERCURY, dice.between(0.4, 1.3), 0.2, dice);
        for [nm, power, fwhm] in PHOSPHORS {
            let of = if nm < 591.0 || (617.0..627.0).contains(&nm) {
                green
            } else {
                red
            };
            let nm = nm + 0.15 * dice.normal();
            all.push([nm, of * power * dice.factor(0.2), fwhm * dice.factor(0.1)]);
        }
        Self {
            lines: all,
            bands: vec![
                [dice.between(445.0, 455.0), dice.between(0.01, 0.12), 50.0],
                [dice.between(550.0, 600.0), dice.between(0.0, 0.03), 150.0],
            ],
            ..Self::default()
        }
    }

    fn mercury(dice: &mut Dice) -> Self {
        let mut all = lines(&MERCURY, 1.0, 0.25, dice);
        if dice.chance(0.4) {
            // Coated with yttrium vanadate.
            for (nm, power) in [
                (595.0, 0.15),
                (615.5, 0.2),
                (619.3, 0.8),
                (698.4, 0.2),
                (704.5, 0.25),
            ] {
                all.push([nm, power * dice.factor(0.3), 2.5]);
            }
        }
        Self {
            lines: all,
            bands: vec![[550.0, dice.between(0.0, 0.01), 300.0]],
            ..Self::default()
        }
    }

    fn sodium(dice: &mut Dice) -> Self {
        const LINES: [[f64; 3]; 10] = [
            [449.7, 0.25, 1.0],
            [466.8, 0.5, 1.1],
            [475.1, 0.25, 1.6],
            [498.2, 1.4, 1.3],
            [515.2, 0.5, 1.4],
            [568.6, 3.2, 2.2],
            [584.0, 5.0, 6.5],
            [595.0, 6.5, 9.0],
            [615.8, 2.2, 2.6],
            [588.0, 2.0, 30.0],
        ];
        let mut all: Vec<[f64; 3]> = LINES
            .map(|[nm, power, fwhm]| [nm + 0.1 * dice.normal(), power * dice.factor(0.2), fwhm])
            .to_vec();
        all.extend(lines(&MERCURY, dice.between(0.0, 0.4), 0.2, dice));
        Self {
            lines: all,
            bands: vec![[600.0, dice.between(0.01, 0.04), 160.0]],
            dark: vec![[589.0, dice.between(1.5, 3.0), 2.5], [589.6, 1.0, 1.5]],
            kelvin: None,
        }
    }

    fn glow(lamp: &str, element: &str, dice: &mut Dice) -> Self {
        Self {
            lines: of_tube(lamp, element, dice),
            bands: vec![[560.0, dice.between(0.0, 0.004), 300.0]],
            ..Self::default()
        }
    }

    fn sky(dice: &mut Dice) -> Self {
        let landmarks: serde_json::Value =
            serde_json::from_str(include_str!("../../../presets/photograph_landmarks.json"))
                .expect("landmarks");
        let table = landmarks["lamps"]["daylight"]["1.0"]
            .as_array()
            .expect("a table");
        let dark = (table.iter())
            .map(|row| [0, 2, 3].map(|k| row[k].as_f64().expect("a figure")))
            .map(|[nm, chance, depth]| {
                let wide: f64 = if nm > 680.0 { 2.0 } else { 0.4 };
                // What a slit of 1 nm leaves of it is the landmark's depth.
                [
                    nm,
                    depth * chance.sqrt() * wide.hypot(1.0) * dice.factor(0.2),
                    wide,
                ]
            })
            .collect();
        Self {
            kelvin: Some(dice.between(5000.0, 9000.0)),
            dark,
            ..Self::default()
        }
    }

    fn metal_halide(dice: &mut Dice) -> Self {
        const SOME: [[f64; 2]; 16] = [
            [568.3, 0.6],
            [588.9, 0.7],
            [589.6, 0.7],
            [535.05, 0.9],
            [410.18, 0.3],
            [451.13, 0.4],
            [473.8, 0.2],
            [402.4, 0.2],
            [508.1, 0.2],
            [567.2, 0.2],
            [570.0, 0.25],
            [616.0, 0.25],
            [625.9, 0.25],
            [670.8, 0.35],
            [597.4, 0.2],
            [653.0, 0.15],
        ];
        let mut all = lines(&MERCURY, dice.between(0.2, 0.8), 0.3, dice);
        all.extend(lines(&SOME, 1.0, 0.6, dice));
        for _ in 0..25 {
            let nm = dice.between(400.0, 690.0);
            all.push([nm, 0.12 * dice.roll(), dice.between(0.2, 1.5)]);
        }
        Self {
            lines: all,
            bands: vec![[560.0, dice.between(0.02, 0.1), 200.0]],
            ..Self::default()
        }
    }

    /// Its power on [`GRID`] behind a slit that widens a line to so many nm.
    pub(crate) fn on_grid(&self, slit_nm: f64) -> Vec<f64> {
        let (first, step, count) = GRID;
        let nm = |i: usize| first + step * i as f64;
        let mut power = vec![0.0; count];
        let mut add = |[at, power_of, fwhm]: [f64; 3]| {
            let wide = fwhm.hypot(slit_nm);
            let (low, high) = (at - 2.5 * wide, at + 2.5 * wide);
            let from = (((low - first) / step).max(0.0) as usize).min(count);
            let to = (((high - first) / step).max(0.0) as usize).min(count);
            let top = power_of * 0.939_437 / wide;
            for (i, p) in power.iter_mut().enumerate().take(to).skip(from) {
                let z = (first + step * i as f64 - at) / wide;
                *p += top * (-2.772_589 * z * z).exp();
            }
        };
        self.lines.iter().for_each(|line| add(*line));
        for [at, height, fwhm] in &self.bands {
            add([*at, height * fwhm / 0.939_437, *fwhm]);
        }
        if let Some(kelvin) = self.kelvin {
            for (i, p) in power.iter_mut().enumerate() {
                let x = 1.438_776_9e7 / (nm(i) * kelvin);
                *p += (560.0 / nm(i)).powi(5) / (x.exp() - 1.0)
                    * (1.438_776_9e7_f64 / (560.0 * kelvin)).exp();
            }
        }
        for [at, width, fwhm] in &self.dark {
            let wide = fwhm.hypot(slit_nm);
            for (i, p) in power.iter_mut().enumerate() {
                let z = (nm(i) - at) / wide;
                *p *= (1.0 - width * 0.939_437 / wide * (-2.772_589 * z * z).exp()).max(0.05);
            }
        }
        power
    }
}
