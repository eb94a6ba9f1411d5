//! Which of the window's parts stand side by side: a large zoom on a small screen leaves room for
//! fewer of them.

/// Width of the model's panel: its tables fit, so that it does not jump with its content. Points,
/// as all of these; larger type takes more.
pub const MODEL_WIDTH: f32 = 392.0;

/// Largest width of the model's panel.
pub const MOST_MODEL_WIDTH: f32 = 760.0;

/// Least and largest width of the library.
pub const LIBRARY_WIDTHS: [f32; 2] = [150.0, 460.0];

/// Least width of a page.
pub const PAGE_WIDTH: f32 = 320.0;

/// How many parts have room side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fit {
    /// Library, page and model.
    All,
    /// A page and one of the others.
    Two,
    /// One of them.
    One,
}

/// What is in front where there is no room for everything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Front {
    /// The page, with the model beside it where it has room.
    #[default]
    Page,
    /// The library.
    Library,
    /// The model, where it has no room beside the page.
    Model,
}

impl Front {
    /// In front when it was not, and the page when it was.
    #[must_use]
    pub fn toggled(self, other: Self) -> Self {
        if self == other { Self::Page } else { other }
    }
}

impl Fit {
    /// What has room in a width, type being `scale` times as large as usual.
    pub fn of(width: f32, scale: f32) -> Self {
        let two = (PAGE_WIDTH + MODEL_WIDTH) * scale;
        if width >= two + LIBRARY_WIDTHS[0] {
            Self::All
        } else if width >= two {
            Self::Two
        } else {
            Self::One
        }
    }

    /// Whether the model is shown.
    pub fn shows_model(self, front: Front) -> bool {
        match self {
            Self::All => true,
            Self::Two => front != Front::Library,
            Self::One => front == Front::Model,
        }
    }

    /// Whether the page is shown.
    pub fn shows_page(self, front: Front) -> bool {
        self != Self::One || front == Front::Page
    }
}
