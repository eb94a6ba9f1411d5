//! Test colours under a light: what CRI and TM-30 compare with a reference.

use crate::{
    color::{Observer, Xyz},
    spectrum::dot,
};

use super::{
    light::{FIRST_NM, Light, positive},
    no_figure::NoFigure,
    weight::value_at,
};

/// Radiance factors on every nm from `first_nm`, nothing being known of them outside.
pub(super) struct TestColours {
    pub(super) first_nm: u32,
    pub(super) rows: Vec<Vec<f64>>,
    pub(super) observer: Observer,
    /// The sum that a light is scaled by, in words.
    pub(super) luminous_sum: &'static str,
}

impl TestColours {
    /// Every test colour and the light itself, Y = 100 for the light.
    pub(super) fn under(&self, light: &Light) -> Result<(Vec<Xyz>, Xyz), NoFigure> {
        let table = self.observer.table();
        let points = self.rows[0].len();
        let skip = (self.first_nm - FIRST_NM) as usize;
        let values = &light.values()[skip..][..points];
        let nm = (self.first_nm..).take(points);
        let (mut weighted, mut white) = ([(); 3].map(|()| Vec::with_capacity(points)), [0.0; 3]);
        for (value, nm) in values.iter().zip(nm) {
            let xyz = table.at(f64::from(nm)).map(|w| w * value);
            (0..3).for_each(|k| {
                weighted[k].push(xyz[k]);
                white[k] += xyz[k];
            });
        }
        let range = f64::from(self.first_nm)..=f64::from(self.first_nm) + (points - 1) as f64;
        let inside = light.lines().iter().filter(|l| range.contains(&l.at_nm));
        let lines: Vec<([f64; 3], f64)> = inside
            .map(|l| (table.at(l.at_nm).map(|w| w * l.weight), l.at_nm))
            .collect();
        for (xyz, _) in &lines {
            (0..3).for_each(|k| white[k] += xyz[k]);
        }
        let unit = 100.0 / positive(white[1], self.luminous_sum)?;
        let one = |row: &Vec<f64>| {
            let mut sum = weighted.each_ref().map(|weighted| dot(row, weighted));
            for (xyz, at_nm) in &lines {
                let factor = value_at(self.first_nm, row, *at_nm);
                (0..3).for_each(|k| sum[k] += factor * xyz[k]);
            }
            Xyz::from_array(sum) * unit
        };
        Ok((
            self.rows.iter().map(one).collect(),
            Xyz::from_array(white) * unit,
        ))
    }
}
