//! The charts of the pages: each made once from what it shows, for window and files.

pub mod race;
