//! Pieces that views are put together from.

mod choice;
mod chooser;
mod layout;
mod seen;
mod stops;
mod table;
mod words;

pub use choice::Choice;
pub use chooser::{Chooser, factors, lights};
pub use layout::{line, scrolled, two_columns};
pub use seen::seen_choice;
pub use stops::Stops;
pub use table::{Column, Look, Row, Table, bar, table};
pub use words::{HEADLINE, copy_button, framed, headline, named, titled, warning};
