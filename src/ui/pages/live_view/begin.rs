//! Nothing is followed yet: what may be.

use crate::ui::kit::drag_value;
use std::{
    net::{Ipv4Addr, SocketAddr},
    path::PathBuf,
};

use eframe::egui;
use egui::{RichText, Ui};

use super::{ToFollow, names};
use crate::{
    app::following::{Asked, FollowAsked, ports},
    io::shown,
    languages::said,
    streams::{BAUD, Pace, Reach},
    ui::{
        kit::{
            Choice, Form, GROUP, form, headline, number, pressed, pressed_if, scrolled, segments,
            text_field, warning,
        },
        pages::{PageContext, PageWish},
        theme::Theme,
    },
};

/// Speeds of a recording, with their words.
const SPEEDS: [(f64, &str); 4] = [
    (1.0, "1×"),
    (10.0, "10×"),
    (100.0, "100×"),
    (0.0, later!("at once")),
];

/// Most and least width of a path's field, and what stands beside it, points.
const PATH: f32 = 260.0;
const LEAST_PATH: f32 = 100.0;
const BESIDE: f32 = 250.0;

/// What was typed so far.
pub(super) struct Begin {
    path: String,
    pub instrument: String,
    speed: f64,
    port: u16,
    serial: Option<PathBuf>,
    /// The ports that were there when they were looked for.
    ports: Option<Result<Vec<PathBuf>, String>>,
    baud: u32,
}

impl Default for Begin {
    fn default() -> Self {
        Self {
            path: String::new(),
            instrument: String::new(),
            speed: 1.0,
            port: 5000,
            serial: None,
            ports: None,
            baud: BAUD,
        }
    }
}

/// The lines that may be sent.
pub(super) fn lines(ui: &mut Ui, theme: Theme) {
    ui.label(RichText::new(said!("A line is one spectrum")).strong());
    for words in [
        said!(
            "Wavelengths once, then a line of values for each spectrum: 400,405,410 … then \
             0.1,0.2,0.3 …"
        ),
        said!(
            "Or an object: \
             {\"wavelength_nm\":[400,405],\"values\":[0.1,0.2],\"integration_ms\":30}."
        ),
        said!("Or labels with their wavelengths: 415nm:12 445nm:30."),
    ] {
        ui.add(egui::Label::new(RichText::new(words).color(theme.faint)).wrap());
    }
}

impl Begin {
    fn pace(&self) -> Pace {
        match self.speed > 0.0 {
            true => Pace::Times(self.speed),
            false => Pace::Stepped,
        }
    }

    /// Draws what may be followed.
    pub(super) fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        headline(ui, context.theme, said!("Follow a light that changes"));
        ui.add(
            egui::Label::new(said!(
                "A meter that writes a file every second, a folder that spectra are saved into, a \
                 sensor board on a serial port, a program that sends lines: each new spectrum is \
                 shown on every page as it comes."
            ))
            .wrap(),
        );
        ui.add_space(GROUP);
        if cfg!(target_arch = "wasm32") {
            let words = said!(
                "A page in a browser reaches neither files nor ports: the program itself follows \
                 lights."
            );
            return warning(ui, context.theme, words);
        }
        let mut asked = None;
        let mut picks = None;
        scrolled(ui, "follow", |ui| {
            let scale = context.theme.scale;
            let room = ui.available_width() / scale;
            let path = (room - BESIDE).clamp(LEAST_PATH, PATH) * scale;
            form(ui, "follow", |form| {
                self.paths(form, path, &mut asked, &mut picks);
                self.recording(form, &mut picks);
                self.tcp(form, &mut asked);
                self.serial(form, (room - 316.0).clamp(80.0, 150.0) * scale, &mut asked);
                self.through(form, path, &mut picks);
            });
            ui.add_space(GROUP);
            if let Some(Err(why)) = &self.ports {
                warning(ui, context.theme, why.clone());
            }
            lines(ui, context.theme);
        });
        context.wishes.extend(picks.map(PageWish::PickToFollow));
        if let Some(source) = asked {
            let instrument = self.instrument.trim();
            let asked = FollowAsked {
                instrument: (!instrument.is_empty()).then(|| PathBuf::from(instrument)),
                ..FollowAsked::new(source)
            };
            context.wishes.push(PageWish::Follow(Box::new(asked)));
        }
    }

    fn paths(
        &mut self,
        form: &mut Form<'_>,
        width: f32,
        asked: &mut Option<Asked>,
        picks: &mut Option<ToFollow>,
    ) {
        let meaning =
            said!("It is read again whenever it changes; of a folder the newest file is shown.");
        form.row((said!("File or folder"), meaning), |ui, _| {
            let field = text_field(
                ui,
                &mut self.path,
                [said(names::PATH), said!("its path")],
                width,
            );
            let path = self.path.trim();
            let enters = field.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
            let button = egui::Button::new(said(names::FOLLOW));
            let is_pressed = pressed_if(ui, !path.is_empty(), button, meaning);
            if (enters || is_pressed) && !path.is_empty() {
                *asked = Some(Asked::Path(PathBuf::from(path)));
            }
        });
        form.rest(|ui| {
            if pressed(ui, said(names::FILE), meaning) {
                *picks = Some(ToFollow::File);
            }
            if pressed(ui, said(names::FOLDER), meaning) {
                *picks = Some(ToFollow::Folder);
            }
        });
    }

    fn recording(&mut self, form: &mut Form<'_>, picks: &mut Option<ToFollow>) {
        let meaning = said!("Lines of spectra with their times, as follow --record writes them.");
        form.row((said!("Recording"), meaning), |ui, _| {
            if pressed(ui, said(names::RECORDING), meaning) {
                *picks = Some(ToFollow::Recording(self.pace()));
            }
        });
        form.rest(|ui| {
            let words = |speed: f64| {
                let found = SPEEDS.iter().find(|(known, _)| *known == speed);
                (found.map_or("", |(_, words)| said(words)), "")
            };
            segments(ui, &mut self.speed, SPEEDS.map(|(speed, _)| speed), words);
        });
    }

    fn tcp(&mut self, form: &mut Form<'_>, asked: &mut Option<Asked>) {
        let meaning = said!(
            "Programs on this machine send lines to 127.0.0.1 at this port. Nothing listens \
             before, and nobody else on the network reaches it."
        );
        form.row((said!("TCP port"), meaning), |ui, _| {
            let field = drag_value(&mut self.port).range(1024..=u16::MAX);
            number(ui, field, said(names::PORT)).on_hover_text(meaning);
            if pressed(ui, said(names::LISTEN), meaning) {
                let address = SocketAddr::from((Ipv4Addr::LOCALHOST, self.port));
                *asked = Some(Asked::Tcp(address, Reach::Loopback));
            }
        });
    }

    fn serial(&mut self, form: &mut Form<'_>, width: f32, asked: &mut Option<Asked>) {
        let meaning = said!("Lines of a sensor board; one that is unplugged is waited for.");
        let says = match (&self.serial, &self.ports) {
            (Some(path), _) => shown(path),
            (None, Some(Ok(ports))) if ports.is_empty() => said!("none found").to_owned(),
            _ => said!("choose a port").to_owned(),
        };
        form.row((said!("Serial port"), meaning), |ui, _| {
            let choice = Choice {
                name: said(names::SERIAL),
                meaning,
                width,
            };
            choice.cut(ui, says, |ui| {
                let found = self.ports.get_or_insert_with(ports);
                for path in found.iter().flatten() {
                    let is_chosen = self.serial.as_ref() == Some(path);
                    if ui.selectable_label(is_chosen, shown(path)).clicked() {
                        self.serial = Some(path.clone());
                    }
                }
                if found.as_ref().is_ok_and(Vec::is_empty) {
                    ui.weak(said!("This machine has none."));
                }
                if ui.button(said!("Look again")).clicked() {
                    self.ports = None;
                }
            });
            let field = drag_value(&mut self.baud)
                .range(1..=10_000_000)
                .suffix(" bit/s");
            number(ui, field, said(names::BAUD)).on_hover_text(said!("As the board sends."));
            let button = egui::Button::new(said!("Open"));
            let is_pressed = pressed_if(ui, self.serial.is_some(), button, meaning);
            if let Some(path) = self.serial.clone().filter(|_| is_pressed) {
                *asked = Some(Asked::Serial(path, self.baud));
            }
        });
    }

    fn through(&mut self, form: &mut Form<'_>, width: f32, picks: &mut Option<ToFollow>) {
        let meaning = said!(
            "An instrument's file, as the page Photograph or combine instrument learn saves it: \
             wavelengths for lines that tell none, and the response that is taken off. Leave it \
             empty for none."
        );
        form.row((said!("Instrument"), meaning), |ui, _| {
            let hint = [said!("Instrument's file"), said!("none")];
            text_field(ui, &mut self.instrument, hint, width);
            if pressed(ui, said(names::INSTRUMENT), meaning) {
                *picks = Some(ToFollow::Instrument);
            }
        });
    }
}
