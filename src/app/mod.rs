//! What the program is doing: document, commands, what is derived, files and jobs. No widgets.

pub mod about;
mod absorption_names;
mod already_open;
pub mod answers;
pub mod behind_slit;
mod beside;
pub mod cells;
pub mod chart;
pub mod charts;
pub mod combining;
mod command;
mod command_line_words;
pub mod comparison;
pub mod derived;
pub mod design;
pub mod dispersion;
mod document;
mod entry;
pub mod export;
mod families;
pub mod figures;
pub mod following;
pub mod glossary;
#[cfg(target_arch = "wasm32")]
pub mod hands;
pub mod headlines;
mod history;
pub mod import;
pub mod instruments;
mod known_lamps;
mod laid;
pub mod lessons;
mod library;
pub mod licences;
mod line_names;
pub mod link;
mod lit;
pub mod live_figures;
mod made;
mod make;
pub mod makers;
pub mod measured;
mod measured_surfaces;
mod memo;
mod natural;
mod noise_begins;
pub mod numbers;
pub mod open;
mod opened;
mod origin;
pub mod own_observers;
pub mod pages;
mod pair;
pub mod photograph;
mod photons;
pub mod picture;
pub mod product_report;
mod product_view;
pub mod products;
mod quality;
pub mod quality_report;
pub mod race_report;
pub mod read_report;
pub mod readings;
mod recipe;
pub mod relit;
pub mod report;
mod scale;
pub mod search;
mod settings;
pub mod share;
pub mod sheet;
pub mod spectral_unit;
mod spike_hand;
mod spike_names;
mod state;
mod stored_doubt;
mod stored_path;
pub mod studies;
pub mod study_report;
mod surfaces;
mod tables;
pub mod ticks;
pub mod tint;
mod today;
mod undo_words;
pub mod verdicts;
pub mod worker;
pub mod workspace;

pub use already_open::{Known, known};
pub use command::{Command, MadeFor};
pub use command_line_words::command_lines;
pub use derived::Derived;
pub use document::{
    Document, FIRST_LIGHT, FIRST_PATCH_SET, Height, MOST_OVERLAYS, Subject, View, WEIGHT_FACTORS,
    first_light,
};
pub use entry::{Entry, bundled_entries, composite_from_preset};
pub use families::Families;
pub use known_lamps::{WordsShown, lamps_asked, lamps_better};
pub use laid::Laid;
pub use library::{FindError, Library};
pub use line_names::{LineName, spike_under};
pub use lit::Lit;
pub use made::is_made;
pub use memo::{ByAddress, Memo};
pub use noise_begins::{NoiseBegins, half_widths_of_numbers, last_order_in, last_order_of};
pub use opened::{ImageEntry, Opened};
pub use pair::{Pair, under_favourites};
pub use quality::{
    Board, ByOrder, CLIENTS_TABLES, GROUPS, IN_GROUP, QualityShown, Tile, Told, coarse_words,
    settled_words,
};
pub use recipe::{Gel, Given, Recipe, Times};
pub use scale::Scale;
pub use settings::{Detector, Settings, range_words};
pub use spike_hand::SpikeAct;
pub use state::{App, Message, Tone, derive};
pub use surfaces::Surfaces;
pub use tables::{CURVE_ORDER, Tables};
pub use today::today;

/// The program as it shows a shipped spectrum.
#[cfg(test)]
pub(crate) fn showing(key: &str) -> App {
    let mut app = App::new();
    app.apply(Command::Show(app.entry(key).expect(key)));
    app
}

/// Fails with the whole text where a part is not in it.
#[cfg(test)]
#[track_caller]
pub(crate) fn assert_says(text: &str, part: &str) {
    assert!(text.contains(part), "{part}: {text}");
}
