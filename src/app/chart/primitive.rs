//! What a chart is drawn of, in plain numbers: px from the picture's top left corner.

use super::{Dash, Rgb};

/// A place in the picture.
pub type Place = [f64; 2];

/// An upright rectangle of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Field {
    /// Distance from the picture's left edge.
    pub left: f64,
    /// Distance from its upper edge.
    pub top: f64,
    /// Never negative.
    pub width: f64,
    /// Never negative.
    pub height: f64,
}

impl Field {
    /// The field between two opposite corners.
    pub fn between(a: Place, b: Place) -> Self {
        Self {
            left: a[0].min(b[0]),
            top: a[1].min(b[1]),
            width: (a[0] - b[0]).abs(),
            height: (a[1] - b[1]).abs(),
        }
    }

    /// Distance of the right edge from the picture's left.
    pub fn right(self) -> f64 {
        self.left + self.width
    }

    /// Distance of the lower edge from the picture's top.
    pub fn bottom(self) -> f64 {
        self.top + self.height
    }

    /// Upper left and lower right corner.
    pub fn corners(self) -> [Place; 2] {
        [[self.left, self.top], [self.right(), self.bottom()]]
    }

    /// Whether a place is inside or at most `reach` px beside.
    pub fn holds(self, place: Place, reach: f64) -> bool {
        let [low, high] = self.corners();
        (0..2).all(|k| (low[k] - reach..=high[k] + reach).contains(&place[k]))
    }

    /// The part inside another field; `None` when nothing is left.
    pub(super) fn cut_to(self, other: Self) -> Option<Self> {
        let [low, high] = other.corners();
        let [a, b] = self
            .corners()
            .map(|corner| [0, 1].map(|k| corner[k].clamp(low[k], high[k])));
        let cut = Self::between(a, b);
        // NaN fails both comparisons.
        (cut.width > 0.0 && cut.height > 0.0).then_some(cut)
    }
}

/// Which part of a text stands at its place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Anchor {
    /// Its beginning.
    #[default]
    Start,
    Middle,
    End,
}

/// A line of text, half above and half below its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Text {
    /// Where it stands.
    pub at: Place,
    /// Which part of it stands there.
    pub anchor: Anchor,
    /// Font size, px.
    pub size: f64,
    /// Colour of its letters.
    pub colour: Rgb,
    /// How far it rises to the right, degrees.
    pub rise: f64,
    /// A colour behind the letters that keeps them legible over lines.
    pub ground: Option<Rgb>,
    /// What is written.
    pub words: String,
}

/// A thing to draw. All of it is cut to its panel already.
#[derive(Clone, Debug, PartialEq)]
pub enum Primitive {
    /// Lines of one kind.
    Lines {
        /// Each a line through places.
        runs: Vec<Vec<Place>>,
        /// Thickness.
        width: f64,
        /// Drawn through, dashed or dotted.
        dash: Dash,
        colour: Rgb,
    },
    /// The area between two borders over the same places: `[x, one, other]`.
    Band {
        /// Corners of both borders, in order.
        corners: Vec<[f64; 3]>,
        /// A colour for each corner, running into one another, in place of the one below; may be
        /// empty.
        shades: Vec<Rgb>,
        colour: Rgb,
        /// 0 is invisible, 1 hides what is below.
        opacity: f64,
    },
    /// Fields of colour with sharp edges.
    Fields(Vec<(Field, Rgb)>),
    /// Four-sided convex pieces, a colour at each corner, running into one another.
    Pieces(Vec<([Place; 4], [Rgb; 4])>),
    /// A convex polygon.
    Polygon {
        /// Its corners, in order.
        corners: Vec<Place>,
        colour: Rgb,
    },
    Circle {
        /// Its middle.
        at: Place,
        radius: f64,
        colour: Rgb,
        /// Thickness of the line where it is empty inside.
        hollow: Option<f64>,
    },
    /// Words.
    Text(Text),
    /// Things that belong together, with words for who points at them or has them read out.
    Group {
        /// What they are.
        title: String,
        /// The things.
        inner: Vec<Primitive>,
    },
}

impl Primitive {
    /// Solid lines.
    pub(super) fn lines(runs: Vec<Vec<Place>>, width: f64, colour: Rgb) -> Self {
        Self::Lines {
            runs,
            width,
            dash: Dash::Solid,
            colour,
        }
    }
}
