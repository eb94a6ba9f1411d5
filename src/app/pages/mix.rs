//! What the page "Mix" keeps: the desk, the desks that were put aside, and the surfaces under it.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};
use crate::app::{
    design::{
        DeskSurfaces,
        mix::{Mix, Snapshot},
    },
    recipe::NameOf,
};

pub(super) const ROW: Row = row(
    Page::Mix,
    Place::Design,
    (later!("Mix"), "mix"),
    "white",
    later!("Mix lines, LEDs and lamps with faders and rate the mix."),
);

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MixState {
    pub desk: Mix,
    /// Desks that were kept, A, B and C.
    pub kept: [Option<Snapshot>; 3],
    /// The surfaces that stand under the mixture.
    pub surfaces: DeskSurfaces,
}

impl Default for MixState {
    fn default() -> Self {
        Self {
            desk: Mix::first(),
            kept: [None, None, None],
            surfaces: DeskSurfaces::default(),
        }
    }
}

impl PageState for MixState {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("desk", later!("the desk")),
        ("kept", later!("a desk put aside")),
        ("surfaces", later!("the surfaces under it")),
    ];

    fn settle(&mut self) {
        self.desk.settle();
        self.kept
            .iter_mut()
            .flatten()
            .for_each(|kept| kept.mix.settle());
    }

    fn forget(&mut self, key: &str) {
        self.desk.forget(key);
    }

    fn changed_since(&self, before: &Self, name_of: NameOf<'_>) -> Option<String> {
        self.desk.changed_since(&before.desk, name_of)
    }
}
