//! Spectral images: from a cube to pixels, from pixels to spectra, and the page "Image" in the
//! real window, driven without a display.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::Arc,
};

use crate::driver::{Shown, Ui, app, assert_written, harness, no_files, settle, words};
use crate::own_time::own_seconds;
use crate::plain::plain;
use crate::root::root;
use eframe::egui;
use egui::{Key, Pos2, Role, vec2};
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{
        ByAddress, Command, Library, Tone,
        open::{self, Loaded},
        pages::{ImageMemory, Page, Place, Show},
        picture::{self, BandWeights, MOST_SIDE, RasterAsk, Source, exposed, step_of},
        studies::Question,
        workspace::{self, Preferences, StoredImage},
    },
    color::{Observer, xyz_from_light, xyz_from_reflectance},
    spectrum::{
        Cube, Kind, NamedSpectrum, Outside, Rect, SpectralImage,
        cube::{Interleave, Layout, Number},
    },
    study::Progress,
    ui::{
        Window,
        files::{Ask, Picked},
        pages::image_view::names,
        saver::Saver,
        theme::waker,
    },
};

const NM: [f64; 7] = [400.0, 450.0, 500.0, 550.0, 600.0, 650.0, 700.0];

/// An image in memory, `value(x, y, band)`; NaN is not measured.
fn image(
    kind: Kind,
    [width, height]: [usize; 2],
    value: impl Fn(usize, usize, usize) -> f32,
) -> Arc<SpectralImage> {
    let mut bytes = Vec::new();
    for band in 0..NM.len() {
        for y in 0..height {
            (0..width).for_each(|x| bytes.extend(value(x, y, band).to_le_bytes()));
        }
    }
    let layout = Layout {
        first_byte: 0,
        number: Number::F32,
        big_endian: false,
        interleave: Interleave::Bands,
        stored_bands: NM.len(),
        missing: None,
    };
    let bands: Vec<(f64, usize)> = NM.iter().copied().zip(0..).collect();
    let cube = Cube::new(width, height, &bands, layout, Arc::new(bytes)).expect("a sound cube");
    Arc::new(SpectralImage {
        name: "scene".to_owned(),
        kind,
        unit: String::new(),
        scale: 0.5,
        bandwidth_nm: None,
        cube,
        notes: vec!["made by a test".to_owned()],
        source: "scene.img".to_owned(),
    })
}

/// Something different in every pixel and band.
fn uneven(x: usize, y: usize, band: usize) -> f32 {
    0.2 + 0.01 * ((7 * x + 13 * y + 5 * band) % 23) as f32
}

fn d65() -> &'static NamedSpectrum {
    let preset = Library::bundled().find("CIE D65").expect("shipped");
    preset.spectrum().expect("a spectrum")
}

fn raster(image: &Arc<SpectralImage>, source: Source) -> picture::Raster {
    let ask = RasterAsk {
        image: ByAddress(image.clone()),
        source,
        most_side: MOST_SIDE,
    };
    ask.answer(&Progress::default()).expect("not cancelled")
}

fn true_colour(image: &Arc<SpectralImage>) -> picture::Raster {
    let under = image.kind.is_factor().then(d65);
    let weights = BandWeights::of(image, Observer::CIE_1931, under, false).expect("D65 shines");
    raster(image, Source::TrueColour(Box::new(weights)))
}

// ---------------------------------------------------------------------------------------- colours

#[test]
fn a_pixel_of_the_picture_has_the_colour_of_its_spectrum() {
    for kind in [Kind::Light, Kind::Reflectance] {
        let image = image(kind, [5, 3], uneven);
        let raster = true_colour(&image);
        for (x, y) in [(0, 0), (4, 2), (2, 1)] {
            let spectrum = image.pixel(x, y).expect("measured").samples;
            // The program's own way to the colour of a whole spectrum, Y = 100.
            let expected = if kind == Kind::Light {
                xyz_from_light(&spectrum, Outside::Zero, Observer::CIE_1931)
            } else {
                xyz_from_reflectance(&spectrum, &d65().samples, Observer::CIE_1931)
            };
            let expected = expected.expect("bright").to_array();
            let drawn = raster.values[y * 5 + x].map(f64::from);
            let scale = if kind == Kind::Light {
                100.0 / drawn[1]
            } else {
                100.0
            };
            for k in 0..3 {
                // Single precision.
                assert!(
                    (drawn[k] * scale - expected[k]).abs() < 1e-5 * expected[1],
                    "{kind} {x},{y}: {drawn:?} {expected:?}"
                );
            }
        }
    }
}

#[test]
fn pixels_that_were_not_measured_are_chequered_and_gaps_are_bridged() {
    let image = image(Kind::Reflectance, [4, 1], |x, _, band| match (x, band) {
        // One band of one pixel is missing: a straight line over it, which it lies on.
        (1, 3) => f32::NAN,
        // Nothing of another.
        (2, _) => f32::INFINITY,
        (_, band) => 0.1 * (1 + band) as f32,
    });
    let shown = exposed(&true_colour(&image), 0.0);
    assert_eq!(shown.not_measured, 1);
    assert_eq!(shown.pixels[2], picture::NOT_MEASURED[0]);
    assert_eq!(shown.pixels[1], shown.pixels[0]);
    assert!(
        shown.words().contains("1 pixel is not measured")
            || shown.words().contains("25 % of the pixels are not")
    );
}

#[test]
fn at_exposure_0_hardly_a_pixel_is_cut_and_a_stop_doubles_the_light() {
    let image = image(Kind::Reflectance, [200, 10], |x, _, band| {
        (x + 1) as f32 * if band > 4 { 0.005 } else { 0.0005 }
    });
    let raster = true_colour(&image);
    let shown = exposed(&raster, 0.0);
    assert!(shown.too_bright + shown.outside_gamut >= 10);
    assert!(
        shown.too_bright <= 200 * 10 / 80,
        "{} pixels brighter than white",
        shown.too_bright
    );
    let darker = exposed(&raster, -1.0);
    assert_eq!(darker.too_bright, 0);
    // Half the light of the pixel with twice as much.
    assert_eq!(
        darker.pixels[99].map(|v| v / 2),
        shown.pixels[49].map(|v| v / 2)
    );
}

#[test]
fn a_large_image_is_drawn_as_means_of_blocks_and_long_ones_fit_a_texture() {
    assert_eq!(step_of(512, 512, MOST_SIDE), 1);
    assert_eq!(step_of(1024, 1024, MOST_SIDE), 1);
    assert_eq!(step_of(1025, 1024, MOST_SIDE), 2);
    assert_eq!(step_of(10_000, 3, MOST_SIDE), 5);
    // A driver that takes less gets less, and none more than that.
    assert_eq!(step_of(10_000, 3, 1024), 10);
    assert_eq!(step_of(10_000, 3, 16_384), 5);
    let image = image(Kind::Other, [2051, 2], uneven);
    let drawn = raster(&image, Source::Bands(vec![3]));
    assert_eq!((drawn.step, drawn.width, drawn.height), (2, 1026, 1));
    let mean: f32 = [(0, 0), (1, 0), (0, 1), (1, 1)]
        .map(|(x, y)| uneven(x, y, 3))
        .iter()
        .sum::<f32>()
        / 4.0;
    assert!((drawn.values[0][0] - mean).abs() < 1e-6);
    // The last block has one column only.
    let edge = (uneven(2050, 0, 3) + uneven(2050, 1, 3)) / 2.0;
    assert!((drawn.values[1025][0] - edge).abs() < 1e-6);
}

#[test]
fn a_dark_light_and_an_image_beyond_the_visible_have_no_eye_to_see_them() {
    let image = image(Kind::Reflectance, [2, 2], uneven);
    let dark = NamedSpectrum {
        samples: d65().samples.scaled(0.0),
        ..d65().clone()
    };
    assert_eq!(
        BandWeights::of(&image, Observer::CIE_1931, Some(&dark), false),
        None
    );
    let black = self::image(Kind::Light, [2, 2], |_, _, _| 0.0);
    let shown = exposed(&true_colour(&black), 3.0);
    assert_eq!(shown.pixels, [[0; 3]; 4]);
}

#[test]
fn a_picture_of_512_x_512_x_31_numbers_takes_far_less_than_half_a_second() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = write_cube(folder.path(), "large", [512, 512], 31, "bip");
    let image = first_image(&path);
    let (shown, took) = own_seconds(|| exposed(&true_colour(&image), 0.5));
    assert_eq!(shown.pixels.len(), 512 * 512);
    // Four times the half second, for slow machines and a program that is not optimised.
    assert!(took < 2.0, "{took} s");
}

// ------------------------------------------------------------------------------------------ files

/// A cube of reflectances on disk: 16 bits, 10000 is 1, every number different.
fn write_cube(
    folder: &Path,
    name: &str,
    [width, height]: [usize; 2],
    bands: usize,
    interleave: &str,
) -> PathBuf {
    let step = 300 / (bands - 1);
    let nm: Vec<String> = (0..bands).map(|b| (400 + step * b).to_string()).collect();
    let header = format!(
        "ENVI\nsamples = {width}\nlines = {height}\nbands = {bands}\nheader offset = 0\n\
         data type = 12\ninterleave = {interleave}\nbyte order = 0\n\
         reflectance scale factor = 10000\nwavelength units = Nanometers\n\
         wavelength = {{{}}}\n",
        nm.join(", ")
    );
    let value = |i: usize| 500 + (i.wrapping_mul(7919) % 8009) as u16;
    let bytes: Vec<u8> = (0..width * height * bands)
        .flat_map(|i| value(i).to_le_bytes())
        .collect();
    fs::write(folder.join(format!("{name}.img")), bytes).expect("a file");
    let path = folder.join(format!("{name}.hdr"));
    fs::write(&path, header).expect("a file");
    path
}

fn first_image(path: &Path) -> Arc<SpectralImage> {
    match open::load_path(path) {
        Loaded::File(opened) => opened.images[0].clone(),
        other => panic!("{other:?}"),
    }
}

/// A real file, where they are at hand.
fn shared(name: &str) -> Option<PathBuf> {
    let folder = root().join("../shared/data/real_files");
    Some(folder.join(name)).filter(|path| path.is_file())
}

#[test]
fn a_pixel_and_a_region_are_named_with_file_and_place() {
    let image = image(Kind::Reflectance, [5, 4], uneven);
    let pixel = picture::named(&image, Rect::pixel(3, 1)).expect("measured");
    assert_eq!(pixel.name, "scene, row 1 column 3");
    assert_eq!(pixel.samples, image.pixel(3, 1).expect("measured").samples);
    assert_eq!(pixel.source, "scene.img");
    let note = pixel.notes.last().expect("a note");
    assert_eq!(note, "Pixel in column 3, row 1 (counted from 0) of 5 x 4.");
    let rect = Rect::between([4, 3], [2, 1]);
    let mean = picture::named(&image, rect).expect("measured");
    assert_eq!(mean.name, "scene, mean of 3 x 3 from row 1 column 2");
    assert_eq!(mean.samples, image.mean_of(rect).expect("measured").samples);
    let note = mean.notes.last().expect("a note");
    assert!(note.contains("columns 2-4, rows 1-3"), "{note}");
}

// --------------------------------------------------------------------------------------- the page

fn over(window: Window, size: [f32; 2]) -> Ui {
    let mut ui = harness(Shown(window), size, 0.02, 60);
    ui.step();
    ui
}

fn fresh(size: [f32; 2]) -> Ui {
    let files = no_files();
    over(
        Window::new(plain(), Preferences::default(), files, None),
        size,
    )
}

fn open_file(ui: &mut Ui, path: &Path) {
    let wake = waker(&ui.ctx);
    ui.state_mut().0.open_files(vec![path.to_owned()], wake);
    settle(ui);
}

fn memory(ui: &Ui) -> &ImageMemory {
    &ui.state().0.app.document().pages.image
}

fn click(ui: &mut Ui, name: &str) {
    let found = ui.query_all_by_label(name).next();
    found
        .unwrap_or_else(|| panic!("nothing is called {name:?}"))
        .click();
    settle(ui);
}

/// Where a pixel of an image of 20 x 10 stands in its picture.
fn place(ui: &Ui, [x, y]: [f32; 2]) -> Pos2 {
    let area = ui.get_by_role_and_label(Role::Image, "Picture of scene, 20 x 10 pixels");
    let area = area.rect();
    let scale = (area.width() / 20.0).min(area.height() / 10.0);
    area.center() + (vec2(x + 0.5, y + 0.5) - vec2(10.0, 5.0)) * scale
}

/// All that is written or named on screen, a line each.
fn text(ui: &Ui) -> String {
    words(ui).join("\n")
}

fn scene(folder: &Path) -> PathBuf {
    write_cube(folder, "scene", [20, 10], 7, "bsq")
}

#[test]
fn every_page_about_pictures_lives_at_every_size_of_the_window() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = scene(folder.path());
    let pictures = Page::all().filter(|page| page.place() == Place::Picture);
    for page in pictures {
        let mut ui = fresh([1280.0, 800.0]);
        open_file(&mut ui, &scene);
        ui.state_mut().0.preferences.page = page;
        // 640 x 480 pixels at 250 % are 256 x 192 points.
        for size in [[200.0, 100.0], [256.0, 192.0], [1.0, 1.0], [560.0, 24.0]] {
            ui.set_size(size.into());
            for _ in 0..3 {
                ui.step();
            }
        }
    }
}

#[test]
fn nothing_of_the_page_stands_over_the_windows_edge() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = scene(folder.path());
    for size in [[1280.0, 800.0], [1100.0, 700.0], [1000.0, 700.0]] {
        let mut ui = fresh(size);
        open_file(&mut ui, &scene);
        // A region of several pixels has the most controls.
        let app = &mut ui.state_mut().0.app;
        app.pages_follow(|pages| pages.image.selection = None);
        settle(&mut ui);
        for shape in &ui.output().shapes {
            let egui::Shape::Text(text) = &shape.shape else {
                continue;
            };
            let words = text.galley.text();
            let right = text.visual_bounding_rect().right();
            let is_cut = right > shape.clip_rect.right() + 1.0 || right > size[0] + 1.0;
            let is_of_page = text.visual_bounding_rect().top() > 48.0;
            assert!(
                !(is_cut && is_of_page),
                "{size:?}: {words:?} ends at {right}"
            );
        }
    }
}

#[test]
fn without_an_image_the_page_shows_the_made_one_and_what_opens_another() {
    let mut ui = fresh([1280.0, 800.0]);
    click(&mut ui, "Picture");
    assert_eq!(ui.state().0.preferences.page, Page::Image);
    let words = text(&ui);
    for word in ["A wall of paints", "81 bands", "Open an image"] {
        assert!(words.contains(word), "{word}: {words}");
    }
    // Its pixels can be taken although it is no image of the document.
    click(&mut ui, "Take as spectrum");
    let document = ui.state().0.app.document();
    assert!(document.images.is_empty());
    assert_eq!(document.own.len(), 1);
}

#[test]
fn the_empty_page_opens_an_image_by_its_button() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path());
    let picker = Arc::new(move |ask: &Ask| {
        assert_eq!(*ask, Ask::Open);
        Picked::Paths(vec![path.clone()])
    });
    let window = Window::new(plain(), Preferences::default(), picker, None);
    let mut ui = over(window, [1280.0, 800.0]);
    click(&mut ui, "Picture");
    click(&mut ui, names::OPEN);
    settle(&mut ui);
    assert_eq!(app(&ui).document().images.len(), 1);
}

#[test]
fn a_cube_opens_on_its_page_and_pixels_become_spectra() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path());
    let mut ui = fresh([1280.0, 800.0]);
    open_file(&mut ui, &path);
    assert_eq!(ui.state().0.preferences.page, Page::Image);
    let message = app(&ui).message().expect("said").text.clone();
    assert!(message.contains("20 x 10 pixels, 7 bands"), "{message}");
    assert_eq!(app(&ui).document().images.len(), 1);
    assert!(text(&ui).contains("ΔE₀₀"), "the model of the whole image");

    // A click is a pixel.
    let at = place(&ui, [13.0, 4.0]);
    ui.hover_at(at);
    ui.run();
    assert!(text(&ui).contains("row 4, column 13, #"), "{}", text(&ui));
    ui.drag_at(at);
    ui.run();
    ui.drop_at(at);
    settle(&mut ui);
    assert_eq!(memory(&ui).selection, Some(Rect::pixel(13, 4)));

    // A drag is a rectangle, whichever corner it begins in.
    let (from, to) = (place(&ui, [9.0, 8.0]), place(&ui, [4.0, 2.0]));
    ui.hover_at(from);
    ui.run();
    ui.drag_at(from);
    ui.run();
    ui.hover_at(to);
    ui.run();
    ui.drop_at(to);
    settle(&mut ui);
    let rect = Rect::between([4, 2], [9, 8]);
    assert_eq!(memory(&ui).selection, Some(rect));

    click(&mut ui, names::TAKE);
    let entry = app(&ui).document().subject_entry().clone();
    assert_eq!(entry.name(), "scene, mean of 6 x 7 from row 2 column 4");
    assert_eq!(entry.kind(), Kind::Reflectance);
    let image = &app(&ui).document().images[0].image;
    let mean = image.mean_of(rect).expect("measured").samples;
    assert_eq!(entry.spectrum.samples, mean);
    assert!(
        entry
            .spectrum
            .notes
            .iter()
            .any(|n| n.contains("columns 4-9, rows 2-8"))
    );

    // The command line takes the very same.
    let out = folder.path().join("tile.csv");
    let convert = [
        "spectral-explorer",
        "convert",
        &path.to_string_lossy(),
        &out.to_string_lossy(),
        "--region",
        "4,2,6,7",
    ]
    .map(std::ffi::OsString::from);
    assert_eq!(run(&convert), 0);
    let Loaded::File(opened) = open::load_path(&out) else {
        panic!("the file that was written");
    };
    assert_eq!(opened.spectra[0].samples.values(), mean.values());
}

#[test]
fn keys_choose_and_take_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut ui = fresh([1280.0, 800.0]);
    open_file(&mut ui, &scene(folder.path()));
    let at = place(&ui, [3.0, 3.0]);
    ui.hover_at(at);
    ui.run();
    ui.drag_at(at);
    ui.run();
    ui.drop_at(at);
    settle(&mut ui);
    ui.key_press(Key::ArrowRight);
    ui.run();
    ui.key_press(Key::ArrowDown);
    settle(&mut ui);
    assert_eq!(memory(&ui).selection, Some(Rect::pixel(4, 4)));
    ui.key_press(Key::Enter);
    settle(&mut ui);
    let entry = app(&ui).document().subject_entry();
    assert_eq!(entry.name(), "scene, row 4 column 4");
    click(&mut ui, names::WHOLE);
    assert_eq!(memory(&ui).selection, None);
}

#[test]
fn bands_and_exposure_are_chosen_and_images_are_removed_and_come_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut ui = fresh([1920.0, 1080.0]);
    open_file(&mut ui, &scene(folder.path()));
    let other = write_cube(folder.path(), "other", [8, 8], 7, "bil");
    open_file(&mut ui, &other);
    assert_eq!(app(&ui).document().images.len(), 2);
    assert!(text(&ui).contains("Picture of other, 8 x 8 pixels"));
    click(&mut ui, "one band");
    assert_eq!(memory(&ui).show, Show::OneBand);
    ui.get_by_role_and_label(Role::Slider, names::BAND)
        .set_value_accesskit(5.0);
    settle(&mut ui);
    assert_eq!(memory(&ui).one_nm, 650.0);
    click(&mut ui, "three bands");
    for name in names::RGB {
        ui.get_by_role_and_label(Role::Slider, name);
    }
    ui.get_by_role_and_label(Role::Slider, names::EXPOSURE)
        .set_value_accesskit(2.0);
    settle(&mut ui);
    assert_eq!(memory(&ui).stops, 2.0);
    assert!(text(&ui).contains("brighter than white, cut"));
    click(&mut ui, names::REMOVE);
    assert_eq!(app(&ui).document().images.len(), 1);
    assert!(text(&ui).contains("Picture of scene, 20 x 10 pixels"));
    ui.state_mut().0.app.apply(Command::Undo);
    settle(&mut ui);
    assert_eq!(app(&ui).document().images.len(), 2);
}

#[test]
fn images_come_back_after_a_restart_and_what_is_gone_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let files = || no_files();
    let saver = Some(Saver::new(path.clone()));
    let first = Window::new(plain(), Preferences::default(), files(), saver);
    let mut ui = over(first, [1280.0, 800.0]);
    open_file(&mut ui, &scene(folder.path()));
    let gone = write_cube(folder.path(), "gone", [8, 8], 7, "bil");
    open_file(&mut ui, &gone);
    let keys: Vec<String> = app(&ui)
        .document()
        .images
        .iter()
        .map(|i| i.key.clone())
        .collect();
    ui.state_mut().0.app.edit_pages(|pages| {
        pages.image.choose(&keys[0]);
        pages.image.selection = Some(Rect::pixel(1, 2));
    });
    ui.state_mut().0.keep_now();
    drop(ui.into_state());
    fs::remove_file(folder.path().join("gone.img")).expect("there");

    let restored = workspace::load(&path).expect("readable").expect("kept");
    assert_eq!(restored.images.len(), 2);
    let (app_again, preferences, images) = Window::restored(restored);
    let saver = Some(Saver::new(path.clone()));
    let mut window = Window::new(app_again, preferences, files(), saver);
    window.bring_back(images, &egui::Context::default());
    // Killed while they are still being read, nothing is lost.
    window.keep_now();
    let mut ui = over(window, [1280.0, 800.0]);
    settle(&mut ui);
    let back = &app(&ui).document().images;
    assert_eq!(back.len(), 1);
    assert_eq!(back[0].key, keys[0]);
    assert_eq!(memory(&ui).selection, Some(Rect::pixel(1, 2)));
    assert!(text(&ui).contains("Picture of scene, 20 x 10 pixels"));
    let problems = app(&ui)
        .messages()
        .iter()
        .filter(|m| m.tone == Tone::Problem);
    let problems: Vec<&str> = problems.map(|m| m.text.as_str()).collect();
    assert!(
        problems.len() == 1 && problems[0].contains("gone"),
        "{problems:?}"
    );
    assert!(app(&ui).undo_words().is_none(), "nothing that a person did");
    ui.state_mut().0.keep_now();
    drop(ui.into_state());
    let kept = workspace::load(&path).expect("readable").expect("kept");
    assert_eq!(kept.images.len(), 2, "a disk may be plugged in again");
    assert!(kept.images.iter().all(|image| image.path.is_absolute()));
}

#[test]
fn a_missing_image_is_looked_for_at_every_start_until_it_is_forgotten() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let saver = Some(Saver::new(path.clone()));
    let files = no_files();
    let mut window = Window::new(plain(), Preferences::default(), files, saver);
    let lost = StoredImage {
        choices: spectral_explorer::io::Choices::default(),
        key: "image/7".to_owned(),
        path: folder.path().join("unplugged.hdr"),
        index: 0,
    };
    window.bring_back(vec![lost], &egui::Context::default());
    let mut ui = over(window, [1280.0, 800.0]);
    settle(&mut ui);
    ui.state_mut().0.keep_now();
    click(&mut ui, "forget 1 missing image");
    drop(ui.into_state());
    let kept = workspace::load(&path).expect("readable").expect("kept");
    assert_eq!(kept.images, []);
}

#[test]
fn a_picture_is_reduced_to_the_largest_texture_of_the_driver() {
    let folder = tempfile::tempdir().expect("a folder");
    let long = write_cube(folder.path(), "long", [1500, 2], 7, "bil");
    let mut ui = fresh([1280.0, 800.0]);
    ui.input_mut().max_texture_side = Some(1024);
    ui.step();
    // A texture beyond it is a panic.
    open_file(&mut ui, &long);
    assert_written(&ui, "Reduced: each drawn pixel is the mean of 2 x 2");
}

#[test]
fn real_images_open_on_the_page() {
    for (name, pixels) in [
        ("cubus_gamsberg_subset.hdr", "10 x 25 pixels"),
        ("Ohta1997.exr", "6 x 4 pixels"),
        ("BiSpectral.exr", "16 x 16 pixels"),
    ] {
        let Some(path) = shared(name) else {
            println!("{name} is not here: left out");
            continue;
        };
        let mut ui = fresh([1280.0, 800.0]);
        ui.state_mut().0.preferences.page = Page::Image;
        open_file(&mut ui, &path);
        let words = text(&ui);
        assert!(words.contains(pixels), "{name}: {words}");
        assert!(words.contains("ΔE₀₀"), "{name}");
    }
}

// ------------------------------------------------------------------------------- the command line

fn run(arguments: &[std::ffi::OsString]) -> u8 {
    said(arguments).0
}

fn said(arguments: &[std::ffi::OsString]) -> (u8, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = spectral_explorer::cli::run(arguments.iter().cloned(), None, &mut out, &mut err);
    let spectral_explorer::cli::Outcome::Done(code) = outcome else {
        panic!("a command");
    };
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (code, text(out), text(err))
}

#[test]
fn pixels_are_named_on_the_command_line_and_refused_in_words() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path());
    let input = path.to_string_lossy().into_owned();
    let report = |more: &[&str]| {
        let words = ["spectral-explorer", "report", &input, "--json"];
        let words = words.iter().chain(more);
        said(&words.map(std::ffi::OsString::from).collect::<Vec<_>>())
    };
    let (code, out, _) = report(&["--pixel", "3,4"]);
    assert_eq!(code, 0);
    assert!(out.contains("scene, row 4 column 3"), "{out}");
    let (code, _, err) = report(&["--pixel", "20,4"]);
    assert_eq!(code, 1);
    assert!(err.contains("expected columns 0-19 and rows 0-9"), "{err}");
    let (code, _, err) = report(&["--region", "1,2,3"]);
    assert_eq!(code, 2);
    assert!(err.contains("X,Y,W,H"), "{err}");
    let words = ["spectral-explorer", "report", "FL2", "--pixel", "1,1"];
    let (code, _, err) = said(&words.map(std::ffi::OsString::from));
    assert_eq!(code, 1);
    assert!(err.contains("expected a spectral image"), "{err}");
}
