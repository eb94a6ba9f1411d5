//! Pieces that views are put together from.

mod choice;
mod chooser;
mod form;
mod kept;
pub mod knob;
mod layout;
mod seen;
mod segments;
mod stops;
mod table;
mod words;

pub use choice::Choice;
pub use chooser::{Chooser, are_same, factors, found, lights, reflectances, transmittances};
pub use form::{Form, GROUP, form};
pub use kept::kept;
pub use knob::{drag_value, slide};
pub use layout::{
    bounded, cell, column, down, figure_grid, line, rolled, scrolled, two_columns, with_panel,
};
pub use seen::{adapt_box, seen_choice};
pub use segments::segments;
pub use stops::{Stops, hold_arrows};
pub use table::{Column, Look, Row, Table, bar, columns, rows, table};
pub use words::{
    HEADLINE, copy_button, cut_words, drawing, fold, framed, headline, hidden_headline,
    main_button, named, named_choice, number, pressed, pressed_if, pressed_small, sign_button,
    small_warnings, text_field, tile_button, titled, warning,
};
