//! Pieces that views are put together from.

mod choice;
mod chooser;
mod layout;
mod seen;
mod stops;
mod table;
mod words;

pub use choice::Choice;
pub use chooser::{Chooser, are_same, factors, found, lights, reflectances, transmittances};
pub use layout::{bounded, cell, column, down, figure_grid, line, rolled, scrolled, two_columns};
pub use seen::{adapt_box, seen_choice};
pub use stops::{Stops, hold_arrows};
pub use table::{Column, Look, Row, Table, bar, columns, rows, table};
pub use words::{
    HEADLINE, copy_button, drawing, framed, headline, named, named_choice, number, pressed,
    pressed_if, pressed_small, sign_button, small_warnings, text_field, tile_button, titled,
    warning,
};
