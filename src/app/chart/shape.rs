//! What points and lines can look like beside their colour: colour alone is never enough.

/// The form of a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shape {
    /// A filled circle.
    #[default]
    Dot,
    /// A circle that is empty inside.
    Ring,
    /// A filled square.
    Square,
    /// A filled triangle that stands on its base.
    Triangle,
    /// A filled square that stands on a corner.
    Diamond,
    /// Two strokes across one another.
    Cross,
}

impl Shape {
    /// All forms, those first that are told apart most easily.
    pub const ALL: [Self; 6] = [
        Self::Dot,
        Self::Square,
        Self::Triangle,
        Self::Ring,
        Self::Diamond,
        Self::Cross,
    ];

    /// The form of the `index`-th series; they come round again.
    pub fn nth(index: usize) -> Self {
        Self::ALL[index % Self::ALL.len()]
    }

    /// Corners of the form around its middle, for a dot of radius 1; y points down.
    ///
    /// Empty for those that are round. A cross has the ends of its two strokes.
    pub fn corners(self) -> &'static [[f64; 2]] {
        // Of about the area that the dot has.
        match self {
            Self::Dot | Self::Ring => &[],
            Self::Square => &[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
            Self::Triangle => &[[0.0, -1.25], [1.15, 0.8], [-1.15, 0.8]],
            Self::Diamond => &[[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]],
            Self::Cross => &[[-0.9, -0.9], [0.9, 0.9], [-0.9, 0.9], [0.9, -0.9]],
        }
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dash {
    /// Through.
    #[default]
    Solid,
    Dashed,
    /// In dots.
    Dotted,
}

impl Dash {
    /// Length of a dash and of a gap, px; `None` for a line that is drawn through.
    pub fn pattern(self) -> Option<[f64; 2]> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some([6.0, 4.0]),
            Self::Dotted => Some([1.8, 3.2]),
        }
    }
}
