//! Light quality in words, as JSON and as CSV.
//!
//! ```text
//! measured  the light that figures are of, and what its unit measures
//! sheet     a light and its model with the figures of either
//! orders    the models of every order, for figures against order
//! row       one figure: title, unit, digits, method, value and what it means in plain words
//! rows      all of them, of a light
//! reading   the plain words
//! words     a sheet as the command `light` prints it
//! json      a light's figures with the keys of the command `light`
//! table     many lights as CSV
//! ```

mod json;
mod measured;
mod orders;
mod reading;
mod row;
mod rows;
mod sheet;
mod table;
mod words;

pub use json::{full_json, json};
pub use measured::{light_of, measured_in};
pub use orders::ModelsByOrder;
pub use row::{Row, figure_words};
pub use rows::{TLCI, known, rows};
pub use sheet::{Modeller, Sheet};
pub use table::{csv_head, csv_line, csv_line_of_none};
pub use words::{table_of_two, text};
