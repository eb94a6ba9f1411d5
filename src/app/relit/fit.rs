//! A picture in few numbers a pixel, and that picture under a light.

use super::{
    Outcome,
    look::{Looked, light_of},
    told,
};
use std::time::Duration;

use web_time::Instant;

use crate::{
    app::{
        entry::Entry,
        memo::ByAddress,
        picture::{Exposed, Raster, exposed},
        studies::Question,
    },
    color::{Xyz, adapted, delta_e_2000, lab_from_xyz, srgb::WHITE},
    languages::fixed,
    pictures::{
        Between, Illuminant, Kernel, Operator, PictureError, Plan, ReferenceKind, Relit, Spread,
        Tally, Trust, Verdict, plan_of, relit_into,
    },
    spectrum::quantile,
    study::Progress,
};

/// A picture and how many numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct FitAsk {
    /// The picture.
    pub looked: ByAddress<Looked>,
    /// Numbers a pixel; `None` for the fewest that are enough.
    pub numbers: Option<usize>,
}

/// A picture in few numbers.
#[derive(Debug)]
pub struct Fit {
    /// The picture.
    pub looked: ByAddress<Looked>,
    /// From pixels to numbers and back.
    pub operator: Operator,
    /// The drawn pixels' numbers: `[number * pixels + pixel]`.
    pub planes: Vec<f32>,
    /// How long it took to make them.
    pub encoded_in: Duration,
}

impl FitAsk {
    fn fit(&self) -> Result<Fit, PictureError> {
        let looked = &self.looked.0;
        let choice = &looked.choice;
        let [least, most] = looked.numbers();
        let tried = self.numbers.map(|n| n.clamp(least, most));
        let tried = tried.and_then(|n| choice.with_numbers(n));
        let bands = looked.bands();
        let known = looked.known.as_ref();
        let plan = match tried {
            Some(tried) => {
                let with = (&looked.base, &looked.wish);
                plan_of(bands, &looked.survey, known, with, tried)?
            }
            None => choice.plan.clone(),
        };
        let operator = Operator::steady(bands, &plan)?;
        let pixels = looked.size().iter().product();
        let mut planes = vec![0.0; operator.numbers() * pixels];
        let encoder = operator.encoder();
        let started = Instant::now();
        encoder.apply(looked.drawn.values(), pixels, &mut planes);
        Ok(Fit {
            looked: self.looked.clone(),
            operator,
            planes,
            encoded_in: started.elapsed(),
        })
    }
}

impl Question for FitAsk {
    type Answer = Outcome<Fit>;

    fn answer(&self, _: &Progress) -> Option<Self::Answer> {
        told(self.fit())
    }
}

/// A picture in few numbers, and what shines on it.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnAsk {
    /// The picture.
    pub fit: ByAddress<Fit>,
    pub light: ByAddress<Entry>,
    /// A second light and its share of the brightness, percent.
    pub second: Option<(ByAddress<Entry>, u32)>,
    /// Whether the light's colour becomes the screen's white.
    pub to_light: bool,
    /// What stands between bands in the picture of few numbers.
    pub between: Between,
}

/// The drawn pixels under a light.
#[derive(Clone, Debug)]
pub struct Turned {
    /// Name of the light.
    pub light: String,
    /// By every band, and by few numbers.
    pub sides: [Exposed; 2],
    /// CIEDE2000 between both, of each drawn pixel; NaN where it was not measured.
    pub off: Vec<f32>,
    /// All of them.
    pub spread: Spread,
    /// The drawn pixel that is most off.
    pub worst: usize,
    /// How far to believe it; `None` for the picture's own colour.
    pub trust: Option<Trust>,
    /// Why it is in its own colour, not under the light; empty where it is.
    pub refused: String,
    /// How long it took to turn the numbers of the drawn pixels into colours (XYZ).
    pub turned_in: Duration,
}

/// From bands and from numbers to the same colours.
struct Ends {
    exact: [Vec<f64>; 3],
    few: Relit,
    trust: Option<Trust>,
    refused: String,
}

impl Ends {
    /// The picture's own colours, and why they are shown.
    fn as_taken(operator: &Operator, refused: String) -> Self {
        Self {
            exact: operator.own_weights().clone(),
            few: operator.own_colour(),
            trust: None,
            refused,
        }
    }
}

/// Highest order of the division that stands for every band of a lit picture.
const FINEST: usize = 40;

impl TurnAsk {
    /// The light, or the mixture of both.
    fn light(&self) -> Illuminant {
        let light = light_of(&self.light.0);
        let second = self.second.as_ref();
        let mixed = second.and_then(|(second, percent)| {
            let share = 1.0 - f64::from(*percent) / 100.0;
            let observer = self.fit.0.operator.plan().observer;
            light.mixed_with(&light_of(&second.0), share, observer)
        });
        mixed.unwrap_or(light)
    }

    fn ends(&self) -> Result<Ends, PictureError> {
        let Fit {
            looked, operator, ..
        } = &*self.fit.0;
        let (bands, plan) = (operator.bands(), operator.plan());
        let light = self.light();
        let known = looked.0.known.as_ref().filter(|_| !bands.is_factor());
        let few = match operator.relit(&light, known, self.between) {
            Ok(few) => few,
            Err(PictureError::NoRelighting(_)) => {
                return Ok(Ends::as_taken(
                    operator,
                    said!(
                        "Nobody knows what lit this picture, so it is shown as it was taken. \
                         Choose the light that it was taken under to see it under others, or take \
                         a white place of it as spectrum on the page Spectral image and choose \
                         that."
                    )
                    .to_owned(),
                ));
            }
            Err(why) => return Err(why),
        };
        let old = known.map(|known| known.on_bands(bands)).transpose()?;
        let survey = &looked.0.survey;
        let noise = match &old {
            Some(old) => survey.noise_under(old),
            None => survey.noise.clone(),
        };
        let trust = operator.trust(&few, &light, old.as_deref(), &noise);
        if trust.verdict == Verdict::Refused {
            let blind = trust.blind.iter().copied().fold(0.0, f64::max);
            let words = tr!(
                "{share} % of the colour of {light} falls where this picture was in the dark, so \
                 it is shown as it was taken.",
                share = fixed(100.0 * blind, 0),
                light = light.name()
            );
            return Ok(Ends::as_taken(operator, words));
        }
        let exact = match known {
            None => light.weights(bands, plan.observer)?,
            Some(known) => {
                // As many numbers as the same division allows.
                let series = (bands.len() - 1).min(FINEST);
                let finest = Plan {
                    observer: plan.observer,
                    ..Plan::lit(bands, series, known, plan.noise)?
                };
                let finest = Operator::new(bands, &finest)?;
                finest.of_bands(&finest.relit(&light, None, Between::Bands)?)
            }
        };
        Ok(Ends {
            exact,
            trust: Some(trust),
            few,
            refused: String::new(),
        })
    }

    fn turned(&self) -> Result<Turned, PictureError> {
        let fit = &*self.fit.0;
        let looked = &fit.looked.0;
        let Ends {
            exact,
            few,
            trust,
            refused,
        } = self.ends()?;
        let [width, height] = looked.size();
        let pixels = width * height;
        let (mut all, mut some) = (vec![0.0; 3 * pixels], vec![0.0; 3 * pixels]);
        let rows = exact.each_ref().map(Vec::as_slice);
        Kernel::of_rows(&rows).apply(looked.drawn.values(), pixels, &mut all);
        let started = Instant::now();
        relit_into(&fit.planes, pixels, &few, &mut some);
        let turned_in = started.elapsed();
        let at = |from: &[f32], i: usize| {
            Xyz::from_array(std::array::from_fn(|k| f64::from(from[k * pixels + i])))
        };
        // Of light nobody knows how much of it is white: its 99th percentile.
        let is_factor = fit.operator.bands().is_factor();
        let white_y = if is_factor {
            1.0
        } else {
            bright(&all[pixels..2 * pixels])
        };
        let white = few.white.with_y(white_y).unwrap_or(few.white);
        let mut tally = Tally::default();
        let (mut worst, mut most) = (0, 0.0);
        let off: Vec<f32> = (0..pixels)
            .map(|i| {
                let [a, b] = [&all, &some].map(|side| lab_from_xyz(at(side, i), white));
                let off = delta_e_2000(a, b);
                if off.is_finite() {
                    tally.add(off);
                    if off > most {
                        (worst, most) = (i, off);
                    }
                }
                off as f32
            })
            .collect();
        let to_screen = to_screen(white, self.to_light || trust.is_none());
        let side = |from: &[f32]| {
            let values = (0..pixels).map(|i| to_screen(at(from, i)));
            let raster = Raster {
                width,
                height,
                step: looked.step,
                values: values.collect(),
                is_xyz: true,
                full: [1.0; 3],
            };
            exposed(&raster, 0.0)
        };
        Ok(Turned {
            light: few.light.clone(),
            sides: [side(&all), side(&some)],
            off,
            spread: tally.spread(),
            worst,
            trust,
            refused,
            turned_in,
        })
    }
}

impl Question for TurnAsk {
    type Answer = Outcome<Turned>;

    fn answer(&self, _: &Progress) -> Option<Self::Answer> {
        told(self.turned())
    }
}

/// What 99 % of the numbers do not exceed; 1 where nothing shines.
fn bright(values: &[f32]) -> f64 {
    let mut values: Vec<f32> = values.iter().copied().filter(|v| v.is_finite()).collect();
    let found = quantile(&mut values, 0.99);
    found.filter(|found| *found > 0.0).unwrap_or(1.0)
}

/// XYZ as a screen shows it, Y = 1 for the white; adapted to it where that is asked for and can be
/// done.
fn to_screen(white: Xyz, adapt: bool) -> impl Fn(Xyz) -> [f32; 3] {
    let gain = 1.0 / white.y;
    let unit = |k: usize| {
        let mut unit = [0.0; 3];
        unit[k] = gain;
        let unit = Xyz::from_array(unit);
        let seen = adapted(unit, white, WHITE).filter(|_| adapt);
        seen.unwrap_or(unit).to_array()
    };
    let columns = [unit(0), unit(1), unit(2)];
    move |xyz| {
        let xyz = xyz.to_array();
        let sum = |k: usize| (0..3).map(|c| columns[c][k] * xyz[c]).sum::<f64>();
        std::array::from_fn(|k| sum(k) as f32)
    }
}

impl Fit {
    /// A drawn pixel: its bands, and what its numbers decode to.
    pub fn pixel(&self, x: usize, y: usize) -> [Vec<f64>; 2] {
        let looked = &self.looked.0;
        let exact = looked.drawn.pixel(x, y);
        let few = self.operator.pixel_of(&self.operator.numbers_of(&exact));
        [exact, few]
    }

    /// What multiplies the series, and the lines, in words.
    pub fn how(&self) -> String {
        let plan = self.operator.plan();
        let series = match plan.reference.kind {
            ReferenceKind::One => said!("cosine series").to_owned(),
            ReferenceKind::Light => tr!("cosine series × {light}", light = plan.reference.name),
            ReferenceKind::Mean => said!("cosine series × the mean").to_owned(),
        };
        match plan.lines.len() {
            0 => series,
            lines => format!("{series}, {}", tr!("{n} line" | "{n} lines" % lines)),
        }
    }
}
