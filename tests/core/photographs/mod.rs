//! Photographs of spectra that the tests draw themselves: every wavelength in them is known.

mod cameras;
mod dice;
mod jpeg;
mod lights;
mod nothing;
mod scenes;

pub(crate) use dice::Dice;
pub(crate) use jpeg::through as jpeg_of;
pub(crate) use lights::{Kind, Light};
pub(crate) use nothing::{NOTHINGS, no_spectrum};
pub(crate) use scenes::{Setup, drawn_profile, picture};
