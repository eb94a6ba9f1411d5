//! What the program does, without a window: commands and the command line. One file a subject.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/docs.rs"]
mod docs;
#[path = "../common/full.rs"]
mod full;
#[path = "../common/open_exr.rs"]
mod open_exr;
#[path = "../common/plain.rs"]
mod plain;
#[path = "../common/root.rs"]
mod root;

mod cli;
mod cli_against;
mod cli_combine;
mod cli_design;
mod cli_files;
mod cli_lamps;
mod cli_lessons;
mod cli_light;
mod cli_names;
mod cli_optics;
mod cli_photo;
mod cli_pictures;
mod cli_studies;
mod cli_unused;
mod cli_wide_lines;
mod command_line;
mod commands;
mod design;
mod line_names;
mod no_window;
mod pages;
mod recipes;
mod tell;
mod workspace;
