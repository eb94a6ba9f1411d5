//! Files read and written. One file a subject.

#[path = "../common/root.rs"]
mod root;

mod readers;
mod strangers;
mod writers;
