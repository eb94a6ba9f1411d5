//! From a document to what is shown of it, and what that needs.

use std::sync::Arc;

use crate::{
    app::{
        derived::{Derived, OrderPoint, Question},
        document::Document,
        entry::Entry,
        settings::Settings,
        studies::Patches,
        tables::{CURVE_ORDER, Tables, Viewing},
    },
    color::{Observer, Xyz, xyz::xyz_from_nm_values},
    spectrum::{Band, Basis},
};

/// What the shared tables were made for.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TablesFor {
    band: Band,
    basis: Basis,
    order: usize,
    observer: Observer,
    patches: Option<Patches>,
    /// The light's key when the subject is looked at under it.
    under: Option<Arc<Entry>>,
}

pub(super) fn tables_for(document: &Document) -> TablesFor {
    let settings = document.settings;
    let is_light = document.is_about_light();
    TablesFor {
        band: settings.band,
        basis: settings.basis,
        order: settings.effective_order().max(CURVE_ORDER),
        observer: settings.observer,
        patches: is_light.then(|| Patches::of(document)),
        under: (!is_light).then(|| document.light.clone()),
    }
}

/// What a change of the document leaves as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kept {
    Nothing,
    /// The errors of every order, and how spectra are laid over: the order alone is another one.
    AllOrders,
    /// Everything of [`Derived`].
    Model,
    /// Everything: pages alone keep something else.
    AllButPages,
}

impl Kept {
    pub(super) fn of(before: &Document, after: &Document) -> Self {
        let with_pages = Document {
            pages: after.pages.clone(),
            ..before.clone()
        };
        match same_model(before, after) {
            true if with_pages == *after => Self::AllButPages,
            true => Self::Model,
            false if other_order(before, after) => Self::AllOrders,
            false => Self::Nothing,
        }
    }
}

/// Whether two documents differ in the order alone, and in no other that the curve must reach.
fn other_order(before: &Document, after: &Document) -> bool {
    let with_order = Document {
        settings: Settings {
            order: after.settings.order,
            ..before.settings
        },
        ..before.clone()
    };
    let reach = |document: &Document| document.settings.effective_order() <= CURVE_ORDER;
    reach(before) && with_order == *after && reach(after)
}

/// Whether two documents have the same model, so that nothing of [`Derived`] can differ: only what
/// lies beside it did (overlays, layers of the plot, products, what pages keep).
fn same_model(a: &Document, b: &Document) -> bool {
    let Document {
        light,
        factor,
        subject,
        settings,
        given,
        edits,
        view,
        // The patches, which `tables_for` finds by them.
        patch_set: _,
        own_patches: _,
        own: _,
        // Their factor stands in the light already.
        weight_factor: _,
        second: _,
        overlays: _,
        images: _,
        next_own: _,
        patch: _,
        scale: _,
        products: _,
        pages: _,
    } = a;
    *light == b.light
        && *factor == b.factor
        && *subject == b.subject
        && *settings == b.settings
        && *given == b.given
        && *edits == b.edits
        && view.adaptation() == b.view.adaptation()
        && tables_for(a) == tables_for(b)
}

pub(super) fn make_tables(wanted: &TablesFor) -> Tables {
    let (band, observer) = (wanted.band, wanted.observer);
    let viewing = match &wanted.under {
        Some(light) => Viewing::under(&light.on_band(band), band, observer),
        None => Viewing::of_light(band, observer),
    };
    let patches = wanted.patches.as_ref();
    let patches = patches.map(|patches| patches.reflectances(band));
    Tables::new(band, wanted.basis, wanted.order, observer, viewing, patches)
}

/// What a document shows, with tables made for it.
pub(crate) fn derived_of(document: &Document) -> (Derived, Tables) {
    let tables = make_tables(&tables_for(document));
    (derive(document, &tables, None), tables)
}

/// The pure step from a document to what is shown of it. `curve`: the errors of every order, where
/// they are known already.
pub fn derive(document: &Document, tables: &Tables, curve: Option<&[OrderPoint]>) -> Derived {
    let settings = document.settings;
    let band = settings.band;
    let subject = document.subject_entry();
    let is_light = document.is_about_light();
    let measured = subject.on_band(band);
    let light = if is_light {
        measured.clone()
    } else {
        document.light.on_band(band)
    };
    let full_range = |entry: &Entry| {
        entry
            .spectrum
            .samples
            .on_whole_nm(360, 830, entry.kind().outside())
    };
    let light_values = full_range(&document.light);
    let subject_values = if is_light {
        light_values.clone()
    } else {
        full_range(subject)
            .iter()
            .zip(&light_values)
            .map(|(r, s)| r * s)
            .collect()
    };
    let white = xyz_from_nm_values(&light_values, settings.observer);
    let scaled = |observer: Observer| -> Xyz {
        let y = xyz_from_nm_values(&light_values, observer).y;
        xyz_from_nm_values(&subject_values, observer) * (100.0 / y)
    };
    let full = (white.y > 0.0).then(|| (scaled(settings.observer), scaled(Observer::CIE_1931)));
    let edits = document.subject_edits();
    let samples = &subject.spectrum.samples;
    let power_outside = if is_light {
        let all = samples.power_between(f64::NEG_INFINITY, f64::INFINITY);
        let inside = samples.power_between(band.min_nm(), band.max_nm());
        if all > 0.0 { 1.0 - inside / all } else { 0.0 }
    } else {
        0.0
    };
    Derived::of(
        Question {
            measured: &measured,
            is_light,
            is_divided: subject.spectrum.scale < 1.0,
            light: &light,
            full,
            full_luminance: white.y,
            table_nm: [samples.first_nm(), samples.last_nm()],
            power_outside,
            settings,
            edits: &edits,
            given: document.as_given().map(|given| &**given),
            adaptation: document.view.adaptation(),
            curve,
        },
        tables,
    )
}
