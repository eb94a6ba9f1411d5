//! What the program looks like: egui, egui_plot and rfd only here, one view a file.
//!
//! A view reads [`App`](crate::app::App) and pushes [`Command`](crate::app::Command)s; the window
//! applies them before it draws what depends on them, so every frame shows its own input.

pub mod batch_view;
pub mod chart_view;
pub mod colour_view;
pub mod curve_view;
pub mod dialogs;
pub mod entry_row;
pub mod files;
pub mod foot_view;
pub mod greeting_view;
pub mod import_view;
pub mod keys;
pub mod kit;
pub mod lesson_view;
pub mod library_view;
pub mod look_view;
pub mod makers_view;
pub mod model_view;
pub mod pages;
pub mod painter;
pub mod palette_view;
pub mod patches_view;
pub mod picture;
pub mod pointing;
pub mod rail_view;
pub mod saver;
pub mod shell;
pub mod spectrum_view;
pub mod spikes_view;
pub mod swatch;
pub mod theme;
pub mod top_view;
pub mod trial_view;
pub mod verdict_view;
pub mod window;

pub use window::Window;
