//! `render`: a picture of the window, with no display needed.

use std::{io::Write, path::Path, sync::Arc};

use super::{Pictures, arguments::Render, print, refusal::Refusal, subject};
use crate::{
    app::{
        App, Command,
        open::{self, Loaded},
        opened::Opened,
        pages::{Page, PageMemory},
        picture::{ImageMemory, reload},
        plot_svg::Theme,
        products::ProductsMemory,
        workspace::Preferences,
    },
    io::atomic::save_atomically,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or a picture that cannot be written.
pub fn run(
    options: &Render,
    pictures: &dyn Pictures,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> Result<(), Refusal> {
    let Render {
        input,
        pick,
        model,
        out: path,
        size,
        theme,
        page,
    } = options;
    let app = match input {
        Some(input) => subject::app(input, pick, *model, err)?,
        None => subject::first_app(pick, *model)?,
    };
    let mut app = app;
    let memory = ImageMemory {
        selection: pick.pixels(),
        ..ImageMemory::default()
    };
    if let (Page::Image, Some(input)) = (page.0, input) {
        open_images(&mut app, input);
    }
    let preferences = Preferences {
        dark: *theme == Theme::Dark,
        pages: PageMemory {
            page: page.0,
            products: ProductsMemory {
                part: page.1,
                ..ProductsMemory::default()
            },
            image: memory,
            ..PageMemory::default()
        },
        ..Preferences::default()
    };
    let picture = pictures.window(&app, &preferences, *size);
    save_atomically(path, &picture).map_err(|why| Refusal::File(why.to_string()))?;
    let [width, height] = size;
    print(
        out,
        &format!("Wrote {}, {width} x {height} px.\n", path.display()),
    )
}

/// The images of a file or a project, for the page that shows them.
fn open_images(app: &mut App, input: &str) {
    match open::load_path(Path::new(input)) {
        Loaded::File(opened) => {
            let images_alone = Opened {
                spectra: Vec::new(),
                ..*opened
            };
            app.apply(Command::Open(vec![images_alone]));
        }
        Loaded::Project { restored, .. } => {
            // What cannot be read again is not on the page, which says that nothing is open.
            let images = restored
                .images
                .iter()
                .filter_map(|i| reload::read_again(i).ok());
            images.for_each(|image| app.image_is_back(&Arc::new(image)));
        }
        // A preset, or what was refused before.
        Loaded::Refused(_) => {}
    }
}
