//! Light quality in words, as JSON and as CSV.
//!
//! ```text
//! measured  the light that figures are of, and what its unit measures
//! sheet     a light and its model with the figures of either
//! orders    the models of every order, for figures against order
//! row       the figures of one light, as tables show them
//! words     a sheet as the command `light` prints it
//! json      a light's figures with the keys of the command `light`
//! table     many lights as a table
//! ```

mod json;
mod measured;
mod orders;
mod row;
mod sheet;
mod table;
mod words;

pub use json::{full_json, json};
pub use measured::{light_of, measured_in};
pub use orders::ModelsByOrder;
pub use row::{Row, rows, rows_with};
pub use sheet::{Modeller, Sheet};
pub use table::{LightRow, light_row, lights_table};
pub use words::{table_of_two, text};
