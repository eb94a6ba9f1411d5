//! Pieces that views are put together from.

mod choice;
mod chooser;
mod layout;
mod table;
mod words;

pub use choice::Choice;
pub use chooser::{Chooser, factors, lights};
pub use layout::{line, scrolled, two_columns};
pub use table::{Column, Look, Row, Table, bar, table};
pub use words::{copy_button, framed, named, titled, warning};
