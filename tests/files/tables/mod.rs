//! How tables of text are read, whatever program wrote them.

mod agree;
mod alternating;
mod choices;
mod decisions;
mod no_table;
mod row_order;
mod rows;
mod samples;
