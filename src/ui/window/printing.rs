//! Printing: a picture on a page that opens the browser's dialog for it. No library for printers is
//! needed, and there is one everywhere.

use std::sync::Arc;

use eframe::egui::Context;

use super::{
    super::{picture, theme::waker},
    Window,
};
use crate::{
    app::{
        Tone,
        chart::{Theme, escaped},
        charts::spectrum::spectrum_chart,
        lessons::handout::data_url,
        pages::Page,
        worker::Worker,
        workspace::Preferences,
    },
    io::save_atomically,
};

/// Size of a chart's picture, px, in a file and on paper.
pub(super) const CHART_SIZE: [u32; 2] = [1200, 760];

/// A picture to print.
pub(super) enum PrintedAs {
    Svg(String),
    Png(Vec<u8>),
}

/// Name of the page.
const FILE: &str = "spectral-explorer-print.html";

/// Size of a page's picture, points.
const PAGE_SIZE: [u32; 2] = [1280, 800];

impl Window {
    /// Prints the spectrum, or another page as it is presented, on white.
    pub(super) fn print_page(&mut self, context: &Context) {
        let page = self.preferences.page;
        let title = crate::languages::with_colon(page.place().title(), page.title());
        let printed = match page {
            Page::Spectrum => {
                let [width, height] = CHART_SIZE;
                PrintedAs::Svg(spectrum_chart(&self.app).to_svg(width, height, Theme::Light))
            }
            _ => {
                let preferences = Preferences {
                    dark: false,
                    present: true,
                    ..self.preferences.clone()
                };
                PrintedAs::Png(picture::window_png(&self.app, &preferences, PAGE_SIZE))
            }
        };
        self.print(&title, printed, context);
    }

    /// Writes the page on a thread of its own and has it opened.
    pub(super) fn print(&mut self, title: &str, printed: PrintedAs, context: &Context) {
        let title = title.to_owned();
        let printer = Arc::clone(&self.printer);
        self.writing
            .push(Worker::start(&waker(context), move |tell| {
                let path = match cfg!(target_arch = "wasm32") {
                    true => FILE.into(),
                    false => std::env::temp_dir().join(FILE),
                };
                let html = page(&title, &printed);
                let written = save_atomically(&path, html.as_bytes());
                let opened = written.map_err(|why| why.to_string());
                let opened = opened.and_then(|()| printer(&path));
                tell.send(match opened {
                    Ok(()) => (
                        Tone::Info,
                        said!("The browser opens the page and asks for the printer.").to_owned(),
                    ),
                    Err(why) => {
                        let path = path.display();
                        let words = tr!(
                            "No browser opened ({reason}). Print this file: {path}",
                            reason = why,
                            path
                        );
                        (Tone::Problem, words)
                    }
                });
            }));
    }
}

/// A page with one picture, as wide as the paper, that asks for the printer when it is there.
fn page(title: &str, printed: &PrintedAs) -> String {
    let picture = match printed {
        PrintedAs::Svg(svg) => svg.clone(),
        PrintedAs::Png(png) => {
            format!("<img alt=\"\" src=\"{}\">", data_url(png))
        }
    };
    let title = escaped(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\n\
         <style>@page {{ size: landscape; margin: 12mm }} body {{ margin: 0 }}\n\
         svg, img {{ width: 100%; height: auto }}</style></head>\n\
         <body onload=\"window.print()\">{picture}</body></html>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_printed_page_holds_the_picture_and_asks_for_the_printer() {
        let html = page("A < B", &PrintedAs::Svg("<svg></svg>".to_owned()));
        assert!(html.contains("<svg></svg>") && html.contains("window.print()"));
        assert!(html.contains("A &lt; B"), "{html}");
        let html = page("lamp", &PrintedAs::Png(vec![1, 2, 3]));
        assert!(html.contains("image/png;base64,AQID"), "{html}");
    }
}
