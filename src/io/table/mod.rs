//! Tables in a text: where their numbers, titles, wavelengths and spectra are.

pub(super) mod alternating;
pub(super) mod block;
pub(super) mod columns;
pub(super) mod commas;
pub(super) mod folded;
pub(super) mod head;
pub(super) mod layout;
pub(super) mod marks;
pub(super) mod no_table;
pub(super) mod pick;
pub(super) mod read;
pub(super) mod roles;
pub(super) mod row_order;
pub(super) mod rows;
pub(super) mod samples;
pub(super) mod scan;
pub(super) mod titles;
