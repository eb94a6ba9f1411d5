//! The strip of colours in a photograph: which way it runs, where, turned by how much, and how its
//! lines lean and bend.

mod extract;
mod rows;
mod small;
mod straighten;

use super::{
    picture::{Picture, View},
    profile::Profile,
};
use rows::Rows;
use small::Light;

/// Position of a strip in a photograph.
///
/// A place `u` along and `v` across the strip is the pixel
/// `x = xm + u cos t - v sin t`, `y = centre_y + u sin t + v cos t`, x and y changed for each other
/// where the strip is vertical. Column k of the profile is `u = k + x0 - xm + shear v + smile v^2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Its colours run from top to bottom.
    pub is_vertical: bool,
    /// By how much it is turned, degrees.
    pub turn_deg: f64,
    /// Columns that lines lean by for one row.
    pub shear: f64,
    /// Columns that lines bend by for a row, squared.
    pub smile: f64,
    /// Middle of the photograph along the strip.
    pub xm: f64,
    /// Middle of the strip across it, at `xm`.
    pub centre_y: f64,
    /// Half of its rows.
    pub half: f64,
    /// The first column.
    pub x0: f64,
    /// Number of columns.
    pub columns: usize,
}

/// Position of the strip as far as it is set by hand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ByHand {
    /// From top to bottom.
    pub is_vertical: Option<bool>,
    /// Left, top, right and bottom in pixels.
    pub area: Option<[f64; 4]>,
    /// Degrees.
    pub turn_deg: Option<f64>,
    /// Columns for a row.
    pub shear: Option<f64>,
    /// Columns for a row, squared.
    pub smile: Option<f64>,
    /// The middle row alone is read.
    pub is_one_row: bool,
    /// Number of the strip among several, from 1.
    pub strip: Option<usize>,
}

/// A strip with the light along it.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Position of the strip.
    pub strip: Strip,
    /// Number of strips.
    pub strips: usize,
    /// Blue lies to the right, as far as colours tell.
    pub blue_is_right: Option<bool>,
    /// The light along it.
    pub profile: Profile,
}

/// Why there is no strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum StripError {
    /// Nothing coloured and long.
    #[error("{}", said!("no coloured strip was found: draw the band by hand"))]
    None,
    /// A strip with a number that is not there.
    #[error("{}", tr!("found {found} strips, expected one of their numbers", found = .0))]
    NoSuch(usize),
    /// A band outside the picture or without size.
    #[error(
        "{}",
        said!(
            "found a band with nothing in it, expected one of 3 rows and 24 columns or more \
             inside the picture"
        )
    )]
    Empty,
}

/// Longest side of the picture in which strips are looked for.
const SMALL: usize = 640;
/// Farthest that a strip may be turned: found, and by hand.
const MOST_TURN_DEG: f64 = 15.0;
/// Half of a strip's height as a share of that of the rows in which it was found.
const INNER: f64 = 0.86;

impl Strip {
    /// The column and row of a pixel of the photograph as it is shown.
    pub fn column_of(&self, x: f64, y: f64) -> (f64, f64) {
        let (x, y) = if self.is_vertical { (y, x) } else { (x, y) };
        let (sin, cos) = self.turn_deg.to_radians().sin_cos();
        let (dx, dy) = (x - self.xm, y - self.centre_y);
        let (u, v) = (dx * cos + dy * sin, dy * cos - dx * sin);
        (u - self.lean(v) - (self.x0 - self.xm), v)
    }

    /// The pixel of a column and row.
    pub fn pixel_of(&self, column: f64, v: f64) -> (f64, f64) {
        let (x, y) = self.seen(column, v);
        if self.is_vertical { (y, x) } else { (x, y) }
    }

    /// The same as the view has it.
    fn seen(&self, column: f64, v: f64) -> (f64, f64) {
        let (sin, cos) = self.turn_deg.to_radians().sin_cos();
        let u = column + self.x0 - self.xm + self.lean(v);
        (
            self.xm + u * cos - v * sin,
            self.centre_y + u * sin + v * cos,
        )
    }

    fn lean(&self, v: f64) -> f64 {
        v * (self.shear + self.smile * v)
    }
}

/// Finds the strip of a photograph and reads the light along it.
///
/// # Errors
/// [`StripError`] where there is none, or not the one that was meant.
pub fn find(picture: &Picture, by_hand: &ByHand) -> Result<Found, StripError> {
    let light = Light::of(&picture.small(SMALL));
    let ways = match by_hand.is_vertical {
        Some(is_vertical) => vec![is_vertical],
        None => light.ways(),
    };
    let tried = ways.into_iter().map(|is_vertical| {
        if is_vertical {
            one_way(picture, &light.transposed(), true, by_hand)
        } else {
            one_way(picture, &light, false, by_hand)
        }
    });
    let mut best: Result<(Found, f64), StripError> = Err(StripError::None);
    for one in tried {
        best = match (best, one) {
            (Ok(old), Ok(new)) => Ok(if new.1 > old.1 { new } else { old }),
            (Ok(old), Err(_)) => Ok(old),
            (Err(_), new) => new,
        };
    }
    best.map(|(found, _)| found)
}

/// Reads the light along a strip whose place is known.
pub fn read_at(picture: &Picture, strip: &Strip) -> Found {
    let mut light = Light::of(&picture.small(SMALL));
    if strip.is_vertical {
        light = light.transposed();
    }
    let view = View {
        picture,
        is_vertical: strip.is_vertical,
    };
    Found {
        strip: *strip,
        strips: 1,
        blue_is_right: light.blue_is_right(),
        profile: extract::profile(view, strip, light.is_grey, false),
    }
}

/// The light along a strip that was read before, of the same picture with other tones.
pub fn again(picture: &Picture, found: &Found) -> Profile {
    let view = View {
        picture,
        is_vertical: found.strip.is_vertical,
    };
    let is_one_row = found.profile.rows == 1;
    extract::profile(view, &found.strip, found.profile.is_grey, is_one_row)
}

/// The strip where colours run from left to right, and how good it is.
fn one_way(
    picture: &Picture,
    light: &Light,
    is_vertical: bool,
    by_hand: &ByHand,
) -> Result<(Found, f64), StripError> {
    let view = View {
        picture,
        is_vertical,
    };
    let number = by_hand.strip.unwrap_or(1);
    let (place, strips) = match by_hand.area {
        Some(area) => (drawn(view, area, by_hand)?, 1),
        None => {
            let runs = rows::strips(light, by_hand.turn_deg);
            let run = runs.get(number.wrapping_sub(1)).copied();
            let missing = if runs.is_empty() {
                StripError::None
            } else {
                StripError::NoSuch(runs.len())
            };
            (run.ok_or(missing)?, runs.len())
        }
    };
    let [width, height] = view.size();
    let mut strip = Strip {
        is_vertical,
        turn_deg: place.turn_deg,
        shear: 0.0,
        smile: 0.0,
        xm: 0.5 * (width as f64 - 1.0),
        centre_y: place.middle,
        half: (INNER * place.half).clamp(1.0, 0.5 * height as f64),
        x0: 0.0,
        columns: width,
    };
    if by_hand.area.is_some() {
        strip.half = place.half;
    }
    let sharpness = straighten::lean(view, &mut strip, light.is_grey, by_hand);
    let drawn = by_hand
        .area
        .map(|[x0, y0, x1, y1]| if is_vertical { [y0, y1] } else { [x0, x1] });
    straighten::columns(view, &mut strip, light.is_grey, drawn);
    if strip.columns < 24 {
        return Err(StripError::None);
    }
    let profile = extract::profile(view, &strip, light.is_grey, by_hand.is_one_row);
    let found = Found {
        strip,
        strips,
        blue_is_right: light.blue_is_right(),
        profile,
    };
    Ok((found, sharpness * place.strength))
}

/// A strip that a person has drawn.
fn drawn(view: View<'_>, area: [f64; 4], by_hand: &ByHand) -> Result<Rows, StripError> {
    let [x0, y0, x1, y1] = if view.is_vertical {
        [area[1], area[0], area[3], area[2]]
    } else {
        area
    };
    let [width, height] = view.size();
    let inside = x0 >= -0.5 && y0 >= -0.5 && x1 <= width as f64 - 0.5 && y1 <= height as f64 - 0.5;
    if !inside || x1 - x0 < 24.0 || y1 - y0 < 3.0 {
        return Err(StripError::Empty);
    }
    let turn_deg = by_hand.turn_deg.unwrap_or(0.0);
    // The middle of the area stays where it was drawn when it is turned about the picture's.
    let away = 0.5 * (x0 + x1) - 0.5 * (width as f64 - 1.0);
    let middle = 0.5 * (y0 + y1) - away * turn_deg.to_radians().tan();
    Ok(Rows {
        turn_deg,
        middle,
        half: 0.5 * (y1 - y0),
        strength: 1.0,
    })
}
