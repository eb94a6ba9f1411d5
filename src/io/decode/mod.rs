//! Packed and nested files taken apart: archives, images, XML and JSON; nothing about spectra.

pub(super) mod archive;
pub(super) mod exr;
pub(super) mod guarded;
pub(super) mod json;
pub(super) mod json_tree;
pub(super) mod png;
pub(super) mod xml;
