//! The pages of the place "Learn": none keeps anything.

use super::{Page, Place, Row, row};

pub(super) const LESSONS: Row = row(
    Page::Lessons,
    Place::Learn,
    (later!("Lessons"), "lessons"),
    "",
    later!("Short walks through the program: predict, do, see why."),
);

pub(super) const GLOSSARY: Row = row(
    Page::Glossary,
    Place::Learn,
    (later!("Glossary"), "glossary"),
    "",
    later!("The words of this window in plain sentences."),
);

pub(super) const TRUTH: Row = row(
    Page::Truth,
    Place::Numbers,
    (later!("The paper checked"), "truth"),
    "colour",
    later!("The paper's claims, measured on this spectrum and range."),
)
.under(Page::Coefficients);

pub(super) const TEACHERS: Row = row(
    Page::Teachers,
    Place::Learn,
    (later!("For teachers"), "teachers"),
    "",
    later!("Aims, preparation and handouts of each lesson, and how to write one."),
);
