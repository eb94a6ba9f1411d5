//! Spectral OpenEXR: an image with one channel a wavelength.

use crate::open_exr;
use crate::root::root;
use crate::told::{has, read, refusal};
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, WritableImage,
    f16,
};
use spectral_explorer::spectrum::Kind;

fn exr(size: (usize, usize), names: &[&str]) -> Vec<u8> {
    open_exr::exr(size, names, Encoding::FAST_LOSSLESS)
}

#[test]
fn patches_become_spectra_and_a_picture_an_image() {
    let names = ["B", "T.500,0nm", "T.400,0nm", "T.400,0nm.500,0nm"];
    let reading = read("p.exr", exr((3, 2), &names));
    assert_eq!(reading.spectra.len(), 6);
    assert_eq!(reading.spectra[4].name, "p, row 1 column 1");
    assert_eq!(reading.spectra[4].samples.values(), [42.0, 41.0]);
    assert_eq!(reading.spectra[0].kind, Kind::Reflectance);
    assert!(has(&reading.notes, "1 channels of fluorescence"));
    let picture = read("q.exr", exr((30, 20), &["S0.400,0nm", "S0.500,0nm"]));
    assert_eq!((picture.spectra.len(), picture.images.len()), (0, 1));
    assert_eq!(picture.images[0].kind, Kind::Light);
    assert_eq!(picture.images[0].cube.value(29, 19, 1), 5991.0);
}

#[test]
fn a_picture_without_spectra_is_refused_by_its_channels() {
    assert_eq!(
        refusal("a.exr", exr((4, 4), &["B", "G", "R"])),
        "a.exr: found an OpenEXR image of the channels \"B G R\", expected two or more \
         spectral channels such as \"S0.380,0nm\" or \"T.380,0nm\""
    );
}

/// A chart of flat patches, 100 x 100 pixels each: patch `p` of band `b` holds `p + b / 32`, which
/// half floats hold exactly too.
fn chart((width, height): (usize, usize), bands: usize, half: bool, encoding: Encoding) -> Vec<u8> {
    let value = |band: usize, at: usize| {
        let patch = at / width / 100 * width.div_ceil(100) + at % width / 100;
        patch as f32 + band as f32 / 32.0
    };
    let list = (0..bands).map(|band| {
        let values = (0..width * height).map(|at| value(band, at));
        let values = match half {
            true => FlatSamples::F16(values.map(f16::from_f32).collect()),
            false => FlatSamples::F32(values.collect()),
        };
        AnyChannel::new(format!("T.{},0nm", 380 + 10 * band).as_str(), values)
    });
    let channels = AnyChannels::sort(list.collect());
    let layer = Layer::new(
        (width, height),
        LayerAttributes::default(),
        encoding,
        channels,
    );
    let mut bytes = std::io::Cursor::new(Vec::new());
    let image = Image::from_layer(layer);
    let written = image.write().non_parallel().to_buffered(&mut bytes);
    written.expect("an image");
    bytes.into_inner()
}

#[test]
fn flat_charts_that_pack_a_hundredfold_are_read_pixel_for_pixel() {
    // The sizes of the pictures in circulation: 600 x 400 x 36 is the chart of the layout's authors.
    for (size, bands, half, encoding) in [
        ((600, 400), 36, false, Encoding::SMALL_LOSSLESS),
        ((640, 480), 31, false, Encoding::SMALL_FAST_LOSSLESS),
        ((640, 480), 31, true, Encoding::SMALL_LOSSLESS),
    ] {
        let file = chart(size, bands, half, encoding);
        let unpacked = size.0 * size.1 * bands * 4;
        assert!(
            unpacked > 30 * file.len(),
            "{} bytes are no test",
            file.len()
        );
        let reading = read("chart.exr", file);
        let cube = &reading.images[0].cube;
        assert_eq!(
            (cube.width(), cube.height(), cube.nm().len()),
            (size.0, size.1, bands)
        );
        for (x, y) in [
            (0, 0),
            (99, 99),
            (100, 99),
            (size.0 - 1, size.1 - 1),
            (250, 301),
        ] {
            let patch = (y / 100 * size.0.div_ceil(100) + x / 100) as f64;
            let expected: Vec<f64> = (0..bands).map(|b| patch + b as f64 / 32.0).collect();
            assert_eq!(cube.values_at(x, y), expected, "{size:?} {x} {y}");
        }
    }
}

/// The same file of tiles of 64 x 64 with another width and height in its header.
fn claiming(mut file: Vec<u8>, was: (i32, i32), size: (i32, i32)) -> Vec<u8> {
    let window = |(width, height): (i32, i32)| -> Vec<u8> {
        let ends = [0, 0, width - 1, height - 1];
        ends.iter().flat_map(|n| n.to_le_bytes()).collect()
    };
    while let Some(at) = file.windows(16).position(|w| w == window(was)) {
        file[at..at + 16].copy_from_slice(&window(size));
    }
    let count = b"chunkCount\0int\0\x04\0\0\0";
    if let Some(at) = file.windows(count.len()).position(|w| w == count) {
        let tiles = (size.0 + 63) / 64;
        let place = at + count.len();
        file[place..place + 4].copy_from_slice(&(tiles * tiles).to_le_bytes());
    }
    file
}

#[test]
fn an_image_of_more_than_512_mib_is_refused_with_the_limit() {
    let small = exr((30, 20), &["S0.400,0nm", "S0.500,0nm"]);
    // 10^8 pixels of two bands, 4 bytes each, and two copies of a tile of 64 x 64.
    let vast = claiming(small.clone(), (30, 20), (10_000, 10_000));
    assert_eq!(
        refusal("a.exr", vast),
        "a.exr: found an image that takes 763 MiB to decode, expected at most 512 MiB of memory, \
         or 20 times the file's size"
    );
    // Within the limit, but the file is not as it says.
    let short = claiming(small, (30, 20), (7_000, 7_000));
    assert!(refusal("a.exr", short).contains("a broken OpenEXR image"));
}

#[test]
fn the_picture_of_the_authors_of_the_layout_is_read_where_it_is_at_hand() {
    let path = root().join("../shared/data/real_files/Macbeth.exr");
    let Ok(file) = std::fs::read(path) else {
        return;
    };
    let reading = read("Macbeth.exr", file);
    let cube = &reading.images[0].cube;
    assert_eq!(
        (cube.width(), cube.height(), cube.nm().len()),
        (600, 400, 36)
    );
}
