//! The page "Image": a spectral image as a picture, from which a pixel or a region's mean becomes
//! a spectrum.

mod asks;
mod canvas;
mod controls;
mod figures;

use std::sync::Arc;

use eframe::egui;
use egui::{TextureHandle, Ui, vec2};

use super::{PageContext, PageWish, progress};
use crate::{
    app::{
        ByAddress, Command, Entry, ImageEntry, MadeFor, Memo, Recipe,
        chart::Chart,
        charts::image::region_chart,
        headlines,
        pages::Spread,
        picture::{
            BandWeights, Exposed, Raster, RasterAsk, RegionAsk, RegionSpectrum, at_hand, exposed,
            named, shown,
        },
        studies::Stage,
    },
    color::Observer,
    io::many::capitalised,
    spectrum::{Rect, SpectralImage},
    ui::{
        kit::{self, GROUP, headline},
        swatch,
    },
};
use canvas::{Canvas, Picture, Touched};

/// What people and tests call the controls.
pub mod names {
    pub const OPEN: &str = later!("Open an image…");
    pub const IMAGE: &str = later!("Image");
    pub const REMOVE: &str = later!("Remove image");
    pub const READING: &str = later!("How it was read…");
    pub const TAKE: &str = later!("Take as spectrum");
    pub const COLOUR: &str = later!("From its colour");
    pub const WHOLE: &str = later!("Whole image");
    pub const FIT: &str = later!("Fit");
    pub const EXPOSURE: &str = later!("Exposure");
    pub const BAND: &str = later!("Band");
    pub const RGB: [&str; 3] = [later!("Red"), later!("Green"), later!("Blue")];
    pub const ADAPT: &str = later!("adapt to light");
}

/// From this width on picture and spectrum stand side by side, points.
const WIDE: f32 = 900.0;

/// A picture on the graphics card and what it was made of.
struct Drawn {
    raster: Arc<Raster>,
    stops: f64,
    exposed: Exposed,
    texture: TextureHandle,
}

/// What the weights of an image's bands depend on: the image, the observer, the light on it, and
/// whether that light becomes the screen's white.
type WeightsOf = (
    ByAddress<SpectralImage>,
    Observer,
    Option<ByAddress<Entry>>,
    bool,
);

#[derive(Default)]
pub struct ImageView {
    canvas: Canvas,
    weights: Memo<WeightsOf, Option<Box<BandWeights>>>,
    drawn: Option<Drawn>,
    chart: Memo<(ByAddress<RegionSpectrum>, Spread), Chart>,
    pointed: Option<[usize; 2]>,
    /// The spectrum that was taken last: its image's key, its pixels, its name.
    taken: Option<(String, Rect, String)>,
}

/// The image on the page, with what is asked about it.
struct Shown {
    entry: Arc<ImageEntry>,
    rect: Rect,
    /// The weights in force; `None` where bands are shown.
    weights: Option<Box<BandWeights>>,
    /// The bands shown; empty for true colour.
    bands: Vec<usize>,
    /// Why it is not shown in true colour although it was asked for.
    instead: Option<&'static str>,
}

impl ImageView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let opened = shown(context.app.document(), &context.pages.image);
        let Some(entry) = opened.cloned().or_else(|| at_hand().cloned()) else {
            return;
        };
        let pixels = context.pages.image.rect(&entry.image.cube);
        let words = headlines::image(&entry, pixels.width * pixels.height);
        headline(ui, context.theme, words);
        ui.add_space(GROUP);
        let presents = context.theme.presents;
        if !presents && controls::images(ui, context, &entry) {
            context.wishes.push(PageWish::Reading(entry.key.clone()));
        }
        controls::looks(ui, context, &entry);
        let shown = self.shown(context, entry);
        let side = ui.input(|i| i.max_texture_side);
        let raster = asks::raster(context, &shown, side);
        let region = asks::region(context, &shown);
        let region = region.as_ref();
        self.draw(ui, context, &shown, raster);

        let room = ui.available_size();
        let scale = context.theme.scale;
        if presents {
            let size = vec2(room.x, room.y - 2.0 * line(ui));
            self.picture(ui, context, &shown, region, size);
        } else if room.x >= WIDE * scale {
            ui.columns(2, |columns| {
                let [left, right] = columns else { return };
                let below = 2.0 * line(left);
                let size = vec2(left.available_width(), room.y - below);
                self.picture(left, context, &shown, region, size);
                self.spectrum(right, context, &shown, region, room.y - 6.0);
            });
        } else {
            let [width, height] = [shown.cube().width(), shown.cube().height()];
            let wanted = room.x * height as f32 / width as f32;
            let size = vec2(room.x, kit::bounded(wanted, 120.0, 0.44 * room.y));
            self.picture(ui, context, &shown, region, size);
            let left = ui.available_height();
            self.spectrum(ui, context, &shown, region, left);
        }
    }

    /// What is to be shown of an image.
    fn shown(&mut self, context: &PageContext<'_>, entry: Arc<ImageEntry>) -> Shown {
        let (document, memory) = (context.app.document(), &context.pages.image);
        let image = &entry.image;
        let rect = memory.rect(&image.cube);
        let mut shown = Shown {
            rect,
            weights: None,
            bands: Vec::new(),
            instead: None,
            entry: entry.clone(),
        };
        // The read-out tells XYZ whatever is shown.
        let under = image
            .kind
            .is_factor()
            .then(|| ByAddress(document.light.clone()));
        let observer = document.settings.observer;
        let of = (
            ByAddress(image.clone()),
            observer,
            under,
            document.view.adapt_patches,
        );
        let weights = self.weights.get(of, |(image, observer, under, to_light)| {
            let under = under.as_ref().map(|light| &light.0.spectrum);
            BandWeights::of(&image.0, *observer, under, *to_light).map(Box::new)
        });
        shown.weights = weights.clone();
        let dark = match &shown.weights {
            None => Some(said!(
                "The document's light does not shine: one band instead."
            )),
            Some(weights) if !weights.sees() => Some(said!(
                "No band lies in the visible range: there is no true colour, one band instead."
            )),
            Some(_) => None,
        };
        shown.weights = shown.weights.filter(|_| dark.is_none());
        if let Some(bands) = memory.bands(&image.cube) {
            shown.bands = bands;
        } else if dark.is_some() {
            shown.bands = vec![image.cube.nearest_band(memory.one_nm)];
            shown.instead = dark;
        }
        shown
    }

    /// The texture, made anew when picture or exposure changed.
    fn draw(
        &mut self,
        ui: &Ui,
        context: &PageContext<'_>,
        shown: &Shown,
        raster: Option<Arc<Raster>>,
    ) {
        let Some(raster) = raster else {
            self.drawn = None;
            return;
        };
        let stops = context.pages.image.stops;
        let fresh = |drawn: &Drawn| Arc::ptr_eq(&drawn.raster, &raster) && drawn.stops == stops;
        if self.drawn.as_ref().is_some_and(fresh) {
            return;
        }
        let exposed = exposed(&raster, stops);
        let image = swatch::image([exposed.width, exposed.height], &exposed.pixels);
        let texture = ui
            .ctx()
            .load_texture(&shown.entry.key, image, swatch::SQUARES);
        self.drawn = Some(Drawn {
            raster,
            stops,
            exposed,
            texture,
        });
    }

    /// The picture with what is under the pointer and how it is drawn.
    fn picture(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        shown: &Shown,
        region: Option<&Arc<RegionSpectrum>>,
        size: egui::Vec2,
    ) {
        let cube = shown.cube();
        let name = tr!(
            "Picture of {image}, {width} x {height} pixels",
            image = shown.entry.image.name,
            width = cube.width(),
            height = cube.height()
        );
        let texture = self.drawn.as_ref().map(|drawn| {
            let raster = &drawn.raster;
            let size = [raster.width, raster.height];
            (drawn.texture.id(), size, raster.step)
        });
        let picture = Picture {
            key: &shown.entry.key,
            name: &name,
            pixels: [cube.width(), cube.height()],
            texture,
            selection: Some(shown.rect).filter(|rect| *rect != cube.all()),
        };
        let touched = self.canvas.show(ui, size, &picture, context.theme);
        self.pointed = touched.pointed;
        self.touch(ui, context, (shown, region), touched);
        let drawn = self.drawn.as_ref();
        kit::line(ui, |ui| figures::pointed(ui, shown, drawn, self.pointed));
        kit::line(ui, |ui| how_drawn(ui, context, shown, drawn));
    }

    /// Carries out what a hand did.
    fn touch(
        &mut self,
        ui: &Ui,
        context: &mut PageContext<'_>,
        (shown, region): (&Shown, Option<&Arc<RegionSpectrum>>),
        touched: Touched,
    ) {
        let all = shown.cube().all();
        if let Some(rect) = touched.selected {
            let memory = &mut context.pages.image;
            let chosen = Some(rect).filter(|rect| *rect != all);
            memory.choose(&shown.entry.key);
            if memory.selection != chosen {
                memory.selection = chosen;
                // Its spectrum was asked for before the hand moved.
                ui.ctx().request_repaint();
            }
        }
        // Enter on a button is that button's.
        let free = touched.focused || ui.memory(|m| m.focused()).is_none();
        let entered = free && ui.input(|i| i.key_pressed(egui::Key::Enter));
        if touched.take || entered {
            let rect = touched.selected.unwrap_or(shown.rect);
            self.take(context, shown, region, rect);
        }
    }

    /// The chosen pixels become a spectrum of the user's own.
    fn take(
        &mut self,
        context: &mut PageContext<'_>,
        shown: &Shown,
        region: Option<&Arc<RegionSpectrum>>,
        rect: Rect,
    ) {
        let spectrum = match region.filter(|region| region.rect == rect && shown.is_of(region)) {
            Some(region) => Some(region.spectrum.clone()),
            None => named(&shown.entry.image, rect),
        };
        if let Some(spectrum) = spectrum {
            let key = shown.entry.key.clone();
            self.taken = Some((key.clone(), rect, spectrum.name.clone()));
            context.commands.push(Command::Make {
                recipe: Recipe::Region { image: key, rect },
                place: MadeFor::Shown,
            });
        }
    }

    /// The chosen spectrum with its model.
    fn spectrum(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        shown: &Shown,
        region: Option<&Arc<RegionSpectrum>>,
        height: f32,
    ) {
        let top = ui.cursor().top();
        let colour =
            region.and_then(|region| figures::colour_of(region, shown, self.drawn.as_ref()));
        let take = controls::choice(ui, context, (shown, colour), &mut self.canvas);
        if take {
            self.take(context, shown, region, shown.rect);
        }
        let taken = self.taken.as_ref().filter(|(key, rect, name)| {
            let is_here = *key == shown.entry.key && *rect == shown.rect;
            // An undo takes it away again.
            is_here && context.app.document().own.iter().any(|e| e.name() == name)
        });
        if let Some((_, _, name)) = taken {
            kit::line(ui, |ui| controls::taken(ui, context, name));
        }
        let Some(region) = region else {
            let job = context.studies.of::<RegionAsk>();
            if job.stage() == Stage::Impossible {
                ui.label(said!("Nothing was measured in these pixels."));
            } else {
                progress(ui, job, said!("The spectrum"));
            }
            return;
        };
        let used = ui.cursor().top() - top;
        let figures = figures::height(ui, context.theme);
        let room = vec2(
            ui.available_width(),
            (height - used - figures - 4.0).max(110.0 * context.theme.scale),
        );
        let spread = context.pages.image.spread;
        let of = (ByAddress(region.clone()), spread);
        let chart = self
            .chart
            .get(of, |(region, spread)| region_chart(&region.0, *spread));
        context.chart(ui, chart, "image spectrum", room);
        let drawn = self.drawn.as_ref();
        figures::model(ui, context, region, shown, drawn);
    }
}

impl Shown {
    fn cube(&self) -> &crate::spectrum::Cube {
        &self.entry.image.cube
    }

    /// Whether a spectrum is of this image.
    fn is_of(&self, region: &RegionSpectrum) -> bool {
        self.entry.image.name_of(region.rect) == region.spectrum.name
            && self.entry.image.source == region.spectrum.source
    }
}

/// How the picture is drawn and what of it is not shown as it is.
fn how_drawn(ui: &mut Ui, context: &mut PageContext<'_>, shown: &Shown, drawn: Option<&Drawn>) {
    let job = context.studies.of::<RasterAsk>();
    let Some(drawn) = drawn else {
        return progress(ui, job, said!("The picture"));
    };
    if let Some(instead) = shown.instead {
        ui.colored_label(context.theme.warning, instead);
        return;
    }
    let mut words = Vec::new();
    let raster = &drawn.raster;
    if raster.step > 1 {
        words.push(tr!(
            "reduced: each drawn pixel is the mean of {step} x {step}",
            step = raster.step
        ));
    }
    words.extend(Some(drawn.exposed.words()).filter(|words| !words.is_empty()));
    if raster.full.iter().all(|full| *full <= 0.0) {
        words.push(said!("nothing is above zero: black").to_owned());
    }
    if words.is_empty() {
        words.push(said!("every pixel is drawn as it is").to_owned());
    }
    let text = format!("{}.", capitalised(&words.join("; ")));
    ui.add(egui::Label::new(egui::RichText::new(text).weak()).truncate())
        .on_hover_text(said!(
            "Exposure 0 takes the 99th percentile of the strongest of red, green and blue, or of \
             each band, to the screen's full brightness. Pixels outside sRGB are cut to it; shares \
             are of the drawn pixels."
        ));
}

/// Height of a row of text with its space, points.
fn line(ui: &Ui) -> f32 {
    ui.spacing().interact_size.y + ui.spacing().item_spacing.y
}
