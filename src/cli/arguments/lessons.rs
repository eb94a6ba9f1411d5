//! Options of `lessons`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::cli::words;

/// What is done with a lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum LessonAct {
    /// Reads it and plays it through.
    Check,
    /// Writes a sheet for a class.
    Handout,
}

/// Options of `lessons`.
#[derive(Args, Debug)]
pub(crate) struct Lessons {
    /// Nothing to list all; check: reads a lesson, plays it through without a window and says
    /// what is wrong, with the step; handout: writes a sheet for a class.
    #[arg(value_name = "ACT", requires = "lesson")]
    pub act: Option<LessonAct>,
    /// The lesson: a name of the list or a file.
    #[arg(value_name = "NAME|FILE")]
    pub lesson: Option<String>,
    /// Print JSON, a list with one object a lesson; its keys are stable.
    #[arg(long, conflicts_with = "act")]
    pub json: bool,
    /// Only the pupil's sheet: questions, boxes, axes to sketch on, no answers.
    #[arg(long, requires = "out", conflicts_with = "teacher")]
    pub pupil: bool,
    /// Only the teacher's sheet: pictures, answers with their reasons, notes, sources.
    #[arg(long, requires = "out")]
    pub teacher: bool,
    /// The language of the sheet, a code such as de: what has no texts in it stays in the lesson's
    /// own.
    #[arg(long, value_name = "CODE", requires = "out")]
    pub language: Option<String>,
    /// The sheet to write, .md (its pictures are put beside it), .html or .pdf; without --pupil and
    /// --teacher both, each from a page of its own.
    #[arg(long, value_name = "FILE", value_parser = words::path_in(&["md", "html", "pdf"]))]
    pub out: Option<PathBuf>,
    /// Let it replace files that exist.
    #[arg(long, requires = "out")]
    pub force: bool,
}
