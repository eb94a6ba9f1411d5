//! What the program is doing: document, commands, what is derived, files and jobs. No widgets.

pub mod absorption_names;
pub mod cells;
pub mod chart;
pub mod charts;
pub mod command;
pub mod derived;
pub mod document;
pub mod entry;
pub mod export;
pub mod history;
pub mod library;
pub mod licences;
pub mod line_names;
pub mod open;
pub mod pages;
pub mod plot_svg;
pub mod product_report;
pub mod product_view;
pub mod products;
pub mod report;
pub mod scale;
pub mod settings;
pub mod spike_hand;
pub mod state;
pub mod studies;
pub mod study_report;
pub mod tables;
pub mod ticks;
pub mod workspace;

pub use command::Command;
pub use derived::Derived;
pub use document::{Document, Subject, View};
pub use entry::Entry;
pub use scale::Scale;
pub use settings::Settings;
pub use state::App;
