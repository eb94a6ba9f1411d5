pub use eframe as _;
pub use egui_plot as _;
