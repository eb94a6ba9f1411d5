//! Lessons: short walks through the program on live data, read from files that anybody can write.
//!
//! ```text
//! format    the file: what a lesson and its steps are made of, read with refusals of one line
//! stage     what a step sets: light, surfaces, settings, view, page
//! making    spectra that a stage makes: mixtures, recovered surfaces, metamers
//! figures   every figure that a lesson may name, by its key
//! of_document those of a document and its pages, a row each
//! languages the texts of a lesson in other languages
//! names     spectra and pages by their names
//! parsed    parts of a file, or what is wrong with them
//! words     sentences with figures in them
//! condition when a task is done
//! run       a lesson that is being taken: its step, predictions, tasks
//! point     what a step points at
//! advice    answers that give themselves away, controls that move the other way
//! proof     a lesson checked and played through without a window
//! trial     a lesson's claims tried on another light
//! handout   sheets for a class, and their A4 pages
//! sound     whether its words, names and figures can be understood at all
//! shelf     the shipped ones, and a person's own files
//! ```

mod advice;
mod condition;
pub mod figures;
mod format;
pub mod handout;
mod handout_parts;
mod handout_pdf;
mod languages;
mod making;
mod names;
mod of_document;
mod parsed;
mod point;
mod proof;
mod run;
pub mod shelf;
mod sound;
mod stage;
mod trial;
mod words;

pub use advice::Findings;
pub use condition::Wanted;
pub use figures::Scene;
pub use format::{Fault, Lesson, Step};
pub use point::Aim;
pub use proof::{Names, check, is_sound, play};
pub use run::{Run, Shown};
pub use trial::{Trial, TrialAsk};
