//! The picture that everybody has at hand: the made wall of paints, as if it had been opened.

use std::sync::{Arc, LazyLock};

use crate::{
    app::{
        opened::ImageEntry,
        origin::{FileReading, FromFile, SourceFile},
    },
    io::Choices,
    pictures::{InMemory, Pixels as _, Scene},
    spectrum::{
        Cube, SpectralImage,
        cube::{Interleave, Layout, Number},
    },
};

/// What finds it: no file, and no number of an image that was opened.
pub const WALL_KEY: &str = "made/wall of paints";

/// The wall, formed once; `None` only where there is no memory for it.
pub fn at_hand() -> Option<&'static Arc<ImageEntry>> {
    static WALL: LazyLock<Option<Arc<ImageEntry>>> = LazyLock::new(|| wall().map(Arc::new));
    WALL.as_ref()
}

fn wall() -> Option<ImageEntry> {
    let scene = Scene::at_hand(None).ok()?;
    let pixels = InMemory::of(&scene).ok()?;
    let bytes = pixels.values().iter().flat_map(|v| v.to_le_bytes());
    let nm = scene.bands().nm();
    let layout = Layout {
        first_byte: 0,
        number: Number::F32,
        big_endian: false,
        interleave: Interleave::Bands,
        stored_bands: nm.len(),
        missing: None,
    };
    let bands: Vec<(f64, usize)> = nm.iter().copied().zip(0..).collect();
    let (width, height) = scene.size();
    let cube = Cube::new(width, height, &bands, layout, Arc::new(bytes.collect())).ok()?;
    let name = later!("A wall of paints").to_owned();
    Some(ImageEntry {
        key: WALL_KEY.to_owned(),
        from: FromFile {
            reading: Arc::new(FileReading {
                file: Arc::new(SourceFile {
                    name: name.clone(),
                    ..SourceFile::default()
                }),
                choices: Choices::default(),
                spectra: 0,
            }),
            index: 0,
        },
        image: Arc::new(SpectralImage {
            name,
            kind: scene.bands().kind(),
            unit: String::new(),
            scale: 1.0,
            bandwidth_nm: None,
            cube,
            notes: vec![
                later!(
                    "Made: tiles of measured paints, half of them with a gloss, seen by a camera \
                     with noise."
                )
                .to_owned(),
            ],
            source: later!("made by this program").to_owned(),
        }),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{App, Command, MadeFor, Recipe};
    use crate::spectrum::Rect;

    #[test]
    fn a_pixel_of_the_wall_becomes_a_spectrum_although_no_image_is_open() {
        let wall = at_hand().expect("memory");
        let cube = &wall.image.cube;
        assert!(cube.width() > 100 && cube.nm().len() == 81);
        let mut app = App::new();
        assert!(app.document().images.is_empty());
        let rect = Rect {
            x: 10,
            y: 10,
            width: 4,
            height: 4,
        };
        let recipe = Recipe::Region {
            image: wall.key.clone(),
            rect,
        };
        let place = MadeFor::Shown;
        app.apply(Command::Make { recipe, place });
        let made = app.document().own.last().expect("a spectrum");
        let values = made.spectrum.samples.values();
        // Paints reflect between nothing and all.
        assert!(values.iter().all(|v| (0.0..=1.2).contains(v)), "{values:?}");
        assert!(made.spectrum.kind.is_factor());
    }
}
