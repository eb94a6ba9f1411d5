//! The pages of the place "Learn": none keeps anything.

use super::{Page, Place, Row, row};

pub(super) const LESSONS: Row = row(
    Page::Lessons,
    Place::Learn,
    ("Lessons", "lessons"),
    "",
    "Short walks through the program: predict, do, see why.",
);

pub(super) const GLOSSARY: Row = row(
    Page::Glossary,
    Place::Learn,
    ("Glossary", "glossary"),
    "",
    "What the words of this window mean.",
);

pub(super) const TRUTH: Row = row(
    Page::Truth,
    Place::Numbers,
    ("The paper checked", "truth"),
    "colour",
    "The paper's claims, measured on this spectrum and range.",
)
.under(Page::Coefficients);

pub(super) const TEACHERS: Row = row(
    Page::Teachers,
    Place::Learn,
    ("For teachers", "teachers"),
    "",
    "What each lesson teaches, what to prepare, handouts, and how to write one.",
);
