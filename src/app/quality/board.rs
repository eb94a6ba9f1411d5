//! Surfaces under a light beside the light's own reference.

use std::sync::LazyLock;

use crate::{
    app::{
        comparison::Side,
        document::Document,
        entry::Entry,
        library::Library,
        lit::{Eye, Lit, Surfaces},
        studies::Patches,
    },
    color::{Adaptation, Observer},
    languages::translated,
    spectrum::Band,
};

/// Surfaces under one light or two, each beside the light's reference of the same temperature.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Board {
    /// Of each light all surfaces in one order; nothing for a light that has no reference.
    pub sides: Vec<Option<Vec<Lit>>>,
}

/// The surfaces that a client asks for: how they are called here, and the table.
const CLIENTS: [[&str; 2]; 8] = [
    [later!("light skin"), "pmc_chart/Skin tone 1"],
    [later!("medium skin"), "pmc_chart/Skin tone 3"],
    [later!("dark skin"), "pmc_chart/Skin tone 4"],
    [later!("strong red"), "cri_tcs/TCS09"],
    [later!("banana"), "pmc_chart/Banana"],
    [later!("leaf"), "colorchecker_ohta/foliage"],
    [later!("blue sky"), "pmc_chart/Blue Sky"],
    [later!("white"), "colorchecker_ohta/white 9.5 (.05 D)"],
];

/// Where colours are compared with a reference: where the samples of TM-30 are known.
const BAND: Band = Band::VISIBLE;

static CLIENTS_SURFACES: LazyLock<Surfaces> = LazyLock::new(|| {
    let found = CLIENTS.iter().filter_map(|[name, key]| {
        let preset = Library::bundled().find(key).ok()?;
        let table = preset.spectrum()?;
        let values = table.samples.on_band(BAND, table.kind.outside());
        Some(((*name).to_owned(), values))
    });
    found.unzip()
});

/// The tables of the surfaces of `Board::for_clients`, in their order, for their sources.
pub const CLIENTS_TABLES: [&str; CLIENTS.len()] = {
    let mut keys = [""; CLIENTS.len()];
    let mut i = 0;
    while i < keys.len() {
        keys[i] = CLIENTS[i][1];
        i += 1;
    }
    keys
};

impl Board {
    /// The eight surfaces that a client asks for.
    pub(super) fn for_clients(lights: &[(&Entry, &Side)], adaptation: Adaptation) -> Self {
        let (names, tables) = &*CLIENTS_SURFACES;
        let names = names.iter().map(|name| translated(name).to_owned());
        Self::of(lights, &(names.collect(), tables.clone()), adaptation)
    }

    /// The surfaces of a document, by their hues under the reference, greys last.
    pub(super) fn by_hue(document: &Document, lights: &[(&Entry, &Side)]) -> Self {
        let surfaces = Patches::of(document).reflectances(BAND);
        let mut board = Self::of(lights, &surfaces, document.view.adaptation());
        let Some(first) = board.sides.iter().flatten().next() else {
            return board;
        };
        let mut order: Vec<usize> = (0..first.len()).collect();
        // Stable: within a hue as in the set.
        order.sort_by_key(|i| first[*i].hue.unwrap_or(usize::MAX));
        for side in board.sides.iter_mut().flatten() {
            *side = order.iter().map(|i| side[*i].clone()).collect();
        }
        board
    }

    fn of(lights: &[(&Entry, &Side)], surfaces: &Surfaces, adaptation: Adaptation) -> Self {
        let eye = Eye {
            band: BAND,
            observer: Observer::CIE_1931,
            adaptation,
        };
        let side = |(entry, side): &(&Entry, &Side)| {
            let reference = side.figures.fidelity.as_ref().ok()?.reference.on_nm();
            let first = (BAND.min_nm() - f64::from(REFERENCE_FROM_NM)) as usize;
            let reference = &reference[first..][..BAND.points()];
            eye.under(surfaces, [&entry.on_band(BAND), reference])
        };
        Self {
            sides: lights.iter().map(side).collect(),
        }
    }

    /// How many surfaces there are.
    pub fn len(&self) -> usize {
        self.sides.iter().flatten().next().map_or(0, Vec::len)
    }

    /// Whether no light has a reference.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A surface under each light that has a reference.
    pub fn surface(&self, index: usize) -> impl Iterator<Item = &Lit> {
        self.sides
            .iter()
            .flatten()
            .filter_map(move |side| side.get(index))
    }
}

/// First nm of a reference's values.
const REFERENCE_FROM_NM: u32 = 360;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{App, showing};

    fn board(app: &App) -> Board {
        let light = &app.document().light;
        let side = Side::of(light.name().to_owned(), &light.spectrum);
        Board::by_hue(app.document(), &[(light, &side)])
    }

    #[test]
    fn daylight_is_its_own_reference_and_a_tube_moves_surfaces_from_theirs() {
        let day = board(&showing("cie_illuminants/CIE D65"));
        let tube = board(&App::new());
        assert_eq!((day.len(), tube.len()), (24, 24));
        // The table of D65 is rounded to six digits, and its temperature is near 6504 K.
        let off = |board: &Board| {
            let side = board.sides[0].as_ref().expect("a white");
            side.iter().map(|lit| lit.delta_e_2000).fold(0.0, f64::max)
        };
        assert!(off(&day) < 0.1, "{}", off(&day));
        assert!(off(&tube) > 5.0, "{}", off(&tube));
    }

    #[test]
    fn surfaces_stand_by_their_hues_and_greys_last() {
        let board = board(&App::new());
        let side = board.sides[0].as_ref().expect("a white");
        let hues: Vec<_> = side.iter().map(|lit| lit.hue).collect();
        let first_grey = hues.iter().position(Option::is_none).expect("greys");
        assert!(hues[..first_grey].is_sorted());
        assert!(hues[first_grey..].iter().all(Option::is_none));
        // The chart has six greys.
        assert_eq!(hues.len() - first_grey, 6);
    }

    #[test]
    fn all_that_a_client_asks_for_is_shipped_and_a_light_without_a_white_has_no_reference() {
        assert_eq!(CLIENTS_SURFACES.0.len(), CLIENTS.len());
        let app = showing("paper/Sodium");
        let light = &app.document().light;
        let side = Side::of(light.name().to_owned(), &light.spectrum);
        let board = Board::for_clients(&[(light, &side)], Adaptation::ToLight);
        assert_eq!(board.sides.len(), 1);
        assert_eq!(board.is_empty(), side.figures.fidelity.is_err());
    }
}
