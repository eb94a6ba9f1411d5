//! Files read and written. One file a subject.

#[path = "../common/containers.rs"]
mod containers;
#[path = "../common/open_exr.rs"]
mod open_exr;
#[path = "../common/own_time.rs"]
mod own_time;
#[path = "../common/root.rs"]
mod root;

mod formats;
mod readers;
mod readings;
mod refusals;
mod strangers;
mod tables;
mod told;
mod writers;
mod writing;
