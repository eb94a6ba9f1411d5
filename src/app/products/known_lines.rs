//! What the lines of a light behind factors are called: the light's own, and the factors' dips.

use crate::{
    app::{
        absorption_names::{Curve, name_dips},
        entry::Entry,
        line_names::LineName,
    },
    spectrum::{Band, Factor, Line},
};

/// Names by place: a spike keeps its place through a chain.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KnownLines(Vec<(f64, LineName)>);

impl KnownLines {
    /// Names of a light's spikes, which come with them, and of the dips that its factors keep.
    pub fn of<'a>(
        band: Band,
        spikes: &[Line],
        names: &[LineName],
        factors: impl IntoIterator<Item = (&'a Entry, &'a Factor)>,
    ) -> Self {
        let own = spikes.iter().zip(names);
        let mut all: Vec<(f64, LineName)> = own.map(|(s, name)| (s.at_nm, name.clone())).collect();
        for (entry, factor) in factors {
            let places: Vec<f64> = factor.dips().iter().map(|dip| dip.at_nm).collect();
            let curve = Curve::of(entry, band, factor.values());
            all.extend(places.iter().copied().zip(name_dips(&places, curve)));
        }
        Self(all)
    }

    /// What is known of the line that stands at a place, nm.
    pub fn at(&self, at_nm: f64) -> Option<&LineName> {
        let found = self.0.iter().find(|(nm, _)| *nm == at_nm);
        found.map(|(_, name)| name)
    }

    /// The name that is safe to print beside it.
    pub fn safe(&self, at_nm: f64) -> Option<&str> {
        self.at(at_nm)?.safe.as_deref()
    }
}
