//! All rules together: who is asked first, and when nobody is believed.

use super::{
    ElementLine, LineName,
    gases::name_gases,
    halides::{HALIDES, name_sodium_and_halides},
    mercury::{self, HG, name_mercury},
    peaks::{Peak, Points},
    phosphors::{EUROPIUM, TERBIUM, has_terbium, host_of_europium, name_europium, name_terbium},
    scene::{BandTold, Scene, Told, is_line},
    sodium::NA,
    table::GASES,
};
use crate::spectrum::{Line, Outside, Sampled};

/// Names are believed when they explain at least this share of all lines' power.
const EXPLAINED: f64 = 0.6;
/// Mercury with all its lines on fine data is believed whatever else there is.
const ALL_OF_MERCURY: usize = 3;
/// No line without a name may be so many times as high as the highest of sodium and thallium.
const UNEXPLAINED: f64 = 0.5;
/// Where the tables of lines are full, nm: what stands beyond may well have no name.
const KNOWN_NM: [f64; 2] = [380.0, 780.0];
/// Coarser data shows no lines, nm.
const COARSEST_NM: f64 = 6.0;
/// Above this share of the power lines stand alone.
const LINES_ALONE: f64 = 0.5;
/// A spike stands for the highest peak at most so far away, since peaks that are closer together
/// are one spike, or else for the nearest within reach, nm.
const SAME_PEAK_NM: f64 = 2.0;

/// A line that noise may have made is the one that is asked for up to this distance, nm.
const SAME_NM: f64 = 1.0;

/// The peaks of a light with their names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Identified {
    peaks: Vec<Peak>,
    told: Vec<Option<Told>>,
    bands: Vec<BandTold>,
    reach_nm: f64,
    /// Share of the light's power in peaks that have names.
    share: f64,
    /// Where its noise may have made lines, nm.
    of_noise_nm: Vec<f64>,
}

impl Identified {
    /// What stands up in a table of a light, by the lines of elements.
    pub fn of(samples: &Sampled, outside: Outside, lines: &[ElementLine]) -> Self {
        let points = Points::of(samples, outside);
        if points.nm.is_empty() || points.step_nm > COARSEST_NM {
            return Self::default();
        }
        let mut scene = Scene::of(points, lines);
        name_all(&mut scene);
        let named = scene.peaks.iter().zip(&scene.told);
        let named = named.filter(|(_, told)| told.is_some());
        let power: f64 = named.map(|(peak, _)| peak.power()).sum();
        let all = scene.points.power();
        Self {
            share: if all > 0.0 { power / all } else { 0.0 },
            peaks: scene.peaks,
            told: scene.told,
            bands: scene.bands,
            reach_nm: scene.reach_nm,
            of_noise_nm: Vec::new(),
        }
    }

    /// Names of spikes at some places: of the peak that each stands for, or of the band of a
    /// phosphor that it stands in. Of several that stand for one peak only the nearest has its
    /// name.
    pub fn names_at(&self, places_nm: &[f64]) -> Vec<LineName> {
        let peaks: Vec<Option<usize>> = places_nm.iter().map(|nm| self.peak_of(*nm)).collect();
        let off = |place: usize, peak: usize| (self.peaks[peak].at_nm - places_nm[place]).abs();
        let is_nearest = |place: usize, peak: usize| {
            let others = (0..places_nm.len()).filter(|other| peaks[*other] == Some(peak));
            others.min_by(|a, b| off(*a, peak).total_cmp(&off(*b, peak))) == Some(place)
        };
        let is_noise = |nm: f64| self.of_noise_nm.iter().any(|at| (at - nm).abs() <= SAME_NM);
        let told = |place: usize| match peaks[place] {
            _ if is_noise(places_nm[place]) => None,
            Some(peak) if is_nearest(place, peak) => self.told[peak].as_ref(),
            _ => self.band_at(places_nm[place]),
        };
        (0..places_nm.len())
            .map(|place| name_of(told(place)))
            .collect()
    }

    /// Takes the names of what stands at places, nm, where its noise may have made lines.
    pub fn without(mut self, of_noise_nm: Vec<f64>) -> Self {
        let near = |peak: &Peak| {
            of_noise_nm
                .iter()
                .any(|at| (at - peak.at_nm).abs() <= SAME_NM)
        };
        let peaks = self.peaks.iter().zip(&mut self.told);
        peaks
            .filter(|(peak, _)| near(peak))
            .for_each(|(_, told)| *told = None);
        Self {
            of_noise_nm,
            ..self
        }
    }

    /// The peak that a spike at a place stands for.
    fn peak_of(&self, at_nm: f64) -> Option<usize> {
        let off = |peak: &usize| (self.peaks[*peak].at_nm - at_nm).abs();
        let all = 0..self.peaks.len();
        let near = all.clone().filter(|peak| off(peak) <= SAME_PEAK_NM);
        let highest = near.max_by(|a, b| self.peaks[*a].height.total_cmp(&self.peaks[*b].height));
        if highest.is_some() || self.band_at(at_nm).is_some() {
            return highest;
        }
        all.filter(|peak| off(peak) <= self.reach_nm)
            .min_by(|a, b| off(a).total_cmp(&off(b)))
    }

    fn band_at(&self, at_nm: f64) -> Option<&Told> {
        let off = |band: &&BandTold| (band.about_nm - at_nm).abs();
        let is_in = |band: &&BandTold| (band.within_nm[0]..=band.within_nm[1]).contains(&at_nm);
        let bands = self.bands.iter().filter(is_in);
        bands
            .min_by(|a, b| off(a).total_cmp(&off(b)))
            .map(|band| &band.told)
    }

    /// Symbols of the elements that were found, by rising wavelength of their first line.
    pub fn elements(&self) -> Vec<&'static str> {
        let mut elements = Vec::new();
        for told in self.told.iter().flatten() {
            if !elements.contains(&told.symbol) {
                elements.push(told.symbol);
            }
        }
        elements
    }

    /// The family of lamps that the lines alone tell of, by its key; `None` where they do not.
    pub fn family_key(&self) -> Option<&'static str> {
        let elements = self.elements();
        let has = |symbol: &str| elements.contains(&symbol);
        let is_reversed = || {
            let mut told = self.told.iter().flatten();
            told.any(|told| told.is_reversed)
        };
        if HALIDES.iter().any(|symbol| has(symbol)) {
            Some("metal-halide")
        } else if has(TERBIUM) && has(EUROPIUM) && has(HG) {
            Some("three-band")
        } else if has(NA) && !has(HG) {
            Some(if is_reversed() { "hps" } else { "lps" })
        } else if has(HG) && elements.len() == 1 {
            // Lines with a glow under them are a tube's, lines alone a mercury lamp's.
            Some(if self.share < LINES_ALONE {
                "tube"
            } else {
                "mercury"
            })
        } else if has("Xe") && elements.len() == 1 {
            Some("xenon")
        } else {
            let is_gas = GASES.iter().any(|gas| has(gas.symbol));
            (is_gas && !has(HG) && self.share > LINES_ALONE).then_some("line-tube")
        }
    }

    /// Every peak with its name, by rising wavelength.
    pub fn peaks(&self) -> impl Iterator<Item = (&Peak, Option<&str>)> {
        let told = self.told.iter().map(|told| told.as_ref());
        let words = told.map(|told| told.map(|told| told.words.as_str()));
        self.peaks.iter().zip(words)
    }
}

fn name_of(told: Option<&Told>) -> LineName {
    told.map_or_else(LineName::default, |told| LineName {
        safe: Some(told.words.clone()),
        label: Some(told.label.clone()),
    })
}

/// The spike that the pointer is on, with its name: the nearest within a distance.
pub fn spike_under<'a>(
    spikes: &'a [Line],
    names: &'a [LineName],
    at_nm: f64,
    within_nm: f64,
) -> Option<(&'a Line, &'a LineName)> {
    let off = |spike: &Line| (spike.at_nm - at_nm).abs();
    spikes
        .iter()
        .zip(names)
        .filter(|(spike, _)| off(spike) <= within_nm)
        .min_by(|a, b| off(a.0).total_cmp(&off(b.0)))
}

fn name_all(scene: &mut Scene<'_>) {
    name_gases(scene);
    let mercury = mercury::witnesses(scene);
    let terbium = has_terbium(scene);
    let europium = host_of_europium(scene);
    if mercury.is_some() {
        name_mercury(scene, terbium, terbium || europium.is_some());
    }
    if terbium {
        name_terbium(scene);
    }
    if let Some(host) = europium {
        name_europium(scene, host);
    }
    if !terbium && europium.is_none() {
        name_sodium_and_halides(scene);
    }
    forget_the_weak(scene);
    let is_sure = scene.is_fine && mercury == Some(ALL_OF_MERCURY);
    if !is_sure && explained(scene) < EXPLAINED {
        scene.forget_all();
    }
}

/// Takes names back where something stronger is left without one.
fn forget_the_weak(scene: &mut Scene<'_>) {
    let highest = |scene: &Scene<'_>, is_it: &dyn Fn(Option<&Told>) -> bool| {
        let peaks = scene.peaks.iter().zip(&scene.told);
        peaks
            .filter(|(peak, told)| is_it(told.as_ref()) && (told.is_some() || counts(peak)))
            .fold(0.0_f64, |highest, (peak, _)| highest.max(peak.height))
    };
    let left = highest(scene, &|told| told.is_none());
    let of = |scene: &Scene<'_>, symbols: &[&str]| {
        highest(scene, &|told| {
            told.is_some_and(|t| symbols.contains(&t.symbol))
        })
    };
    let mut lamp = HALIDES.to_vec();
    lamp.extend([NA, "K", HG]);
    if left > UNEXPLAINED * of(scene, &lamp) {
        for symbol in lamp.iter().filter(|symbol| **symbol != HG) {
            scene.forget(symbol);
        }
    }
    for symbol in [TERBIUM, EUROPIUM] {
        if left > of(scene, &[symbol, HG]) {
            scene.forget(symbol);
        }
    }
}

/// Whether a peak is one that ought to have a name.
fn counts(peak: &Peak) -> bool {
    is_line(peak) && (KNOWN_NM[0]..=KNOWN_NM[1]).contains(&peak.at_nm)
}

/// The share of the power of all lines that has a name.
fn explained(scene: &Scene<'_>) -> f64 {
    let (mut named, mut all) = (0.0, 0.0);
    for (peak, told) in scene.peaks.iter().zip(&scene.told) {
        if counts(peak) {
            all += peak.power();
            named += if told.is_some() { peak.power() } else { 0.0 };
        }
    }
    if all > 0.0 { named / all } else { 1.0 }
}
