//! The program as figures, conditions and sentences see it.

use crate::app::{App, pages::Page};

/// What figures are taken of: the program's state and what its pages remember.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The program.
    pub app: &'a App,
    /// What the pages remember.
    pub page: Page,
}
