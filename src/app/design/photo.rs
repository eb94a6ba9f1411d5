//! A picture of colours whose pixels are taken as colours, read on a thread of its own.

use std::path::PathBuf;

use crate::{
    app::studies::Question,
    io::{ColourPng, name_of},
    study::Progress,
};

/// Most pixels of a picture: more than cameras have.
const MOST_PIXELS: usize = 1 << 27;

/// A picture of colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Photo {
    /// Its file's name.
    pub name: String,
    /// The picture.
    pub png: ColourPng,
}

/// The picture of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct PhotoAsk(pub PathBuf);

impl Question for PhotoAsk {
    type Answer = Result<Photo, String>;

    /// Reads the file; never `None`, as nobody cancels it.
    fn answer(&self, _: &Progress) -> Option<Self::Answer> {
        let name = name_of(&self.0);
        Some(match ColourPng::read(&self.0, MOST_PIXELS) {
            Ok(png) => Ok(Photo { name, png }),
            Err(why) => Err(format!("{name}: {why}.")),
        })
    }
}

impl Photo {
    /// The picture with no side longer than `most`: its size, its pixels, and of how many pixels
    /// across and down each is one.
    pub fn drawn(&self, most: usize) -> ([usize; 2], Vec<[u8; 3]>, usize) {
        let [width, height] = self.png.size;
        let step = width.max(height).div_ceil(most.max(1)).max(1);
        let (rows, columns) = ((0..height).step_by(step), (0..width).step_by(step));
        let size = [columns.len(), rows.len()];
        let pixels = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
        let pixels = pixels.filter_map(|(x, y)| self.png.pixel(x, y));
        (size, pixels.collect(), step)
    }

    /// The pixel at a place within the picture, each 0 to 1 from the left and from the top.
    pub fn at(&self, [across, down]: [f32; 2]) -> Option<([usize; 2], [u8; 3])> {
        let [width, height] = self.png.size;
        // `as usize` takes what is negative to 0.
        let pixel = |share: f32, count: usize| {
            ((share * count as f32) as usize).min(count.saturating_sub(1))
        };
        let [x, y] = [pixel(across, width), pixel(down, height)];
        Some(([x, y], self.png.pixel(x, y)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::ColourPixels;

    #[test]
    fn a_pixel_is_found_by_its_place_however_small_the_picture_is_drawn() {
        let (width, height) = (50, 30);
        let pixels = (0..width * height).flat_map(|i| [(i % width) as u8, (i / width) as u8, 7]);
        let photo = Photo {
            name: "a.png".to_owned(),
            png: ColourPng {
                size: [width, height],
                pixels: ColourPixels::Eight(pixels.collect()),
            },
        };
        assert_eq!(photo.at([0.5, 0.5]), Some(([25, 15], [25, 15, 7])));
        assert_eq!(photo.at([-1.0, 2.0]), Some(([0, 29], [0, 29, 7])));
        let (size, drawn, step) = photo.drawn(20);
        assert_eq!((size, step), ([17, 10], 3));
        assert_eq!(drawn.len(), 170);
        assert_eq!(drawn[18], [3, 3, 7]);
    }
}
