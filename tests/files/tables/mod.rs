//! How tables of text are read, whatever program wrote them.

mod agree;
mod alternating;
mod choices;
mod decisions;
mod folded;
mod layouts;
mod marks;
mod no_table;
mod plausible;
mod roles;
mod row_order;
mod rows;
mod samples;
mod texts;
mod titles;
mod told_kinds;
mod units;
