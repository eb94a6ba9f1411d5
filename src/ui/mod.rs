//! What the program looks like: egui, egui_plot and rfd only here, one view a file.
//!
//! A view reads [`App`](crate::app::App) and pushes [`Command`](crate::app::Command)s; the window
//! applies them before it draws what depends on them, so every frame shows its own input.

mod batch_view;
mod brief_view;
pub mod chart_view;
mod colour_view;
mod curve_view;
mod dialogs;
mod entry_row;
mod eyes;
pub mod files;
mod foot_view;
mod greeting_view;
mod import_view;
mod keys;
pub mod kit;
mod lesson_view;
mod library_view;
mod lights_quality_view;
mod linked;
mod lit_field;
pub mod look_view;
mod makers_view;
pub mod model_view;
pub mod pages;
pub mod painter;
mod palette_view;
mod patches_view;
pub mod picture;
mod pointing;
mod rail_view;
#[cfg_attr(target_arch = "wasm32", path = "web/saver.rs")]
pub mod saver;
mod second_chip;
#[cfg(not(target_arch = "wasm32"))]
pub mod shell;
mod spectrum_view;
mod spikes_view;
mod steps_view;
mod swatch;
pub mod theme;
mod top_menus;
mod top_view;
mod trial_view;
pub mod verdict_view;
#[cfg(target_arch = "wasm32")]
pub mod web;
mod window;

pub use window::Window;

#[cfg(not(target_arch = "wasm32"))]
use files::{dropped, system_picker, system_printer};
#[cfg(target_arch = "wasm32")]
use web::{dropped, system_printer};
