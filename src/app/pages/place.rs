//! The places of the window: what a person asks, and which pages answer.

use super::{Page, ROWS, Row};

/// A place of the window: what a person asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Show me.
    Learn,
    /// What is in this light?
    Look,
    /// What does it do behind glass and off surfaces?
    Through,
    /// Is it a good light?
    Quality,
    /// Can I make one?
    Design,
    /// How few numbers will do?
    Numbers,
    Picture,
}

impl Place {
    /// Every place that has a page, from the top of the rail down.
    pub const ALL: [Self; 7] = [
        Self::Learn,
        Self::Look,
        Self::Through,
        Self::Quality,
        Self::Design,
        Self::Numbers,
        Self::Picture,
    ];

    pub fn title(self) -> &'static str {
        match self {
            Self::Learn => said!("Learn"),
            Self::Look => said!("Look"),
            Self::Through => said!("Through"),
            Self::Quality => said!("Quality"),
            Self::Design => said!("Design"),
            Self::Numbers => said!("Numbers"),
            Self::Picture => said!("Picture"),
        }
    }

    pub fn asks(self) -> &'static str {
        match self {
            Self::Learn => said!("Show me"),
            Self::Look => said!("What is in this light?"),
            Self::Through => said!("What does it do behind glass and off surfaces?"),
            Self::Quality => said!("Is it a good light?"),
            Self::Design => said!("Can I make one?"),
            Self::Numbers => said!("How few numbers will do?"),
            Self::Picture => said!("And in a picture?"),
        }
    }

    /// The page that it opens with.
    pub fn first(self) -> Page {
        let mut pages = ROWS.iter().filter(|row| row.place == self);
        pages.next().map_or(Page::Spectrum, |row| row.page)
    }

    /// The tabs of the place.
    pub fn tabs(self) -> impl Iterator<Item = Page> {
        let is_tab = move |row: &&Row| row.place == self && row.tab == row.page;
        ROWS.iter().filter(is_tab).map(|row| row.page)
    }
}
