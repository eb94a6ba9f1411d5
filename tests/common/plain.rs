//! The program about a lamp of many lines with the paper's plain series: what most tests of figures
//! are about.

#![allow(dead_code, reason = "no program of tests needs all of it")]

use std::sync::Arc;

use spectral_explorer::app::{
    App, Document, Entry, Height, Settings, View, bundled_entries, first_light,
};

/// The lamp.
pub(crate) const FL11: &str = "cie_fluorescent_1nm/FL11";

/// FL11 modelled by a plain Fourier series, every layer drawn, patches as they are.
pub(crate) fn plain() -> App {
    let bundled = bundled_entries();
    let lamp = bundled.iter().find(|entry| entry.key == FL11);
    plain_about(lamp.cloned().unwrap_or_else(|| first_light(bundled)))
}

/// The same about another light.
pub(crate) fn plain_about(light: Arc<Entry>) -> App {
    App::with_document(Document {
        settings: Settings::plain(),
        view: View {
            model: false,
            smooth: true,
            residual: true,
            height: Height::Even,
            adapt_patches: false,
            ..View::default()
        },
        ..Document::about(light)
    })
}
