//! The light that is followed: what of it reaches the program, its keys, and its bar on every page.

use std::time::Duration;

use eframe::egui;
use egui::{Context, Label, Margin, Panel, RichText, Ui};

use super::{
    super::{
        files::{NO_DIALOG, Picked},
        kit::pressed,
        pages::live_view::{LiveView, ToFollow, names},
        theme::{Theme, waker},
    },
    Window,
    panels::plain,
};
use crate::{
    app::{
        Command, Tone,
        following::{Asked, FollowAsked, Following, Standing},
        pages::Page,
    },
    languages::{said, with_colon},
};

/// How often what is said of the last frame's age is said anew.
const AGES: Duration = Duration::from_secs(1);

/// Height of the bar, points.
const BAR: f32 = 34.0;

impl Window {
    /// Follows something from now on, in place of what was followed before.
    pub fn follow_light(&mut self, asked: FollowAsked, context: &Context) {
        // What a thread says of it is said as the window speaks, from its first frame on.
        self.speak();
        self.greets = false;
        self.preferences.page = Page::Live;
        self.following = Some(match self.quiet {
            // A picture does not wait.
            true => Following::played(&asked),
            false => Following::start(asked, &waker(context)),
        });
        context.request_repaint();
    }

    /// The newest frame becomes the light.
    pub(super) fn follow_on(&mut self, context: &Context) {
        if let Some(asked) = self.preferences.follow_asked.take() {
            self.follow_light(asked, context);
        }
        if let Some(key) = self.library.wants_following.take() {
            self.follow_file_of(&key, context);
        }
        let Some(following) = &mut self.following else {
            self.studies.patient = false;
            return;
        };
        let before = self.app.changes();
        let is_first = following.key().is_none();
        following.look(&mut self.app);
        // The workspace keeps captures, not frames.
        if !is_first && self.kept.0 == before {
            self.kept.0 = self.app.changes();
        }
        self.studies.patient = following.seen().standing != Standing::Held;
        if following.is_on() {
            context.request_repaint_after(AGES);
        }
    }

    fn follow_file_of(&mut self, key: &str, context: &Context) {
        let own = self.app.document().own.iter();
        let mut own = own.filter(|entry| entry.key == key);
        let reading = own.next().and_then(|entry| entry.origin.file());
        let reading = reading.map(|from| from.reading.clone());
        let path = reading
            .as_ref()
            .and_then(|reading| reading.file.path.clone());
        if let Some((path, reading)) = path.zip(reading) {
            let asked = FollowAsked {
                choices: reading.choices.clone(),
                ..FollowAsked::new(Asked::Path(path))
            };
            self.follow_light(asked, context);
        }
    }

    /// A path that was chosen to be followed.
    pub(super) fn picked_to_follow(&mut self, what: ToFollow, picked: Picked) {
        let path = match picked {
            Picked::Paths(paths) => paths.into_iter().next(),
            Picked::Cancelled => return self.app.say(Tone::Info, said!("No file chosen.")),
            Picked::NoDialog => return self.app.say(Tone::Problem, said(NO_DIALOG)),
            // A page follows nothing.
            #[cfg(target_arch = "wasm32")]
            Picked::Later => return,
        };
        let Some(path) = path else { return };
        let source = match what {
            ToFollow::Instrument => return self.pages.take_instrument(&path),
            ToFollow::Recording(pace) => Asked::Replay(path, pace),
            ToFollow::File | ToFollow::Folder => Asked::Path(path),
        };
        self.preferences.follow_asked = Some(self.through(FollowAsked::new(source)));
    }

    /// The same through the instrument that the page names.
    fn through(&mut self, asked: FollowAsked) -> FollowAsked {
        FollowAsked {
            instrument: self.pages.of::<LiveView>().instrument(),
            ..asked
        }
    }

    /// Holds what is shown, or goes on.
    pub(super) fn hold(&mut self) {
        if let Some(following) = &self.following {
            let mut stream = following.stream();
            let is_held = stream.live.is_held();
            stream.hold(!is_held);
        }
    }

    /// Keeps what is shown, on disk before anything else is done.
    pub(super) fn capture(&mut self) {
        let Some(following) = &self.following else {
            return;
        };
        let Some(entry) = following.capture() else {
            let words = said!("There is no spectrum to capture yet.");
            return self.app.say(Tone::Problem, words);
        };
        let words = tr!("Captured to My files: {name}.", name = entry.name());
        self.app.apply(Command::Capture(Box::new(entry)));
        self.app.end_gesture();
        if let Some(saver) = &self.saver {
            let absent = self.images.absent();
            saver.keep_and_wait(self.app.document(), &self.preferences, &absent);
            self.kept = (self.app.changes(), self.preferences.clone());
        }
        self.app.say(Tone::Info, words);
    }

    /// A small bar on every page but its own.
    pub(super) fn following_bar(&mut self, ui: &mut Ui, theme: Theme) {
        if self.preferences.page == Page::Live {
            return;
        }
        let Some(seen) = self
            .following
            .as_ref()
            .map(|following| following.seen().clone())
        else {
            return;
        };
        let frame = plain(ui, Margin::symmetric(16, 2)).fill(ui.visuals().faint_bg_color);
        let is_held = seen.standing == Standing::Held;
        let (mut holds, mut captures, mut goes, mut stops) = (false, false, false, false);
        Panel::top("following")
            .frame(frame)
            .exact_size(BAR)
            .show(ui, |ui| {
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    stops = pressed(ui, said(names::STOP), said(names::STOP_MEANS));
                    goes = pressed(
                        ui,
                        said!("Live"),
                        said!("The page Live: figures, captures, over time."),
                    );
                    captures = pressed(ui, said(names::CAPTURE), said(names::CAPTURE_MEANS));
                    let hold = if is_held {
                        said(names::GO_ON)
                    } else {
                        said(names::HOLD)
                    };
                    holds = pressed(ui, hold, said(names::HOLD_MEANS));
                    ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                        let sign = if seen.standing.is_trouble() {
                            "▲"
                        } else {
                            "●"
                        };
                        let colour = match seen.standing.is_trouble() {
                            true => theme.warning,
                            false => theme.accent,
                        };
                        ui.colored_label(colour, sign);
                        let more: Vec<&str> = std::iter::once(seen.words.as_str())
                            .chain(seen.warnings.iter().map(String::as_str))
                            .collect();
                        let words = RichText::new(with_colon(&seen.name, more.join(" ")));
                        ui.add(Label::new(words).truncate());
                    });
                });
            });
        if holds {
            self.hold();
        }
        if captures {
            self.capture();
        }
        if goes {
            self.preferences.page = Page::Live;
        }
        if stops {
            self.follow_no_more();
        }
    }

    /// Follows it no longer; the light as it was last stays.
    pub(super) fn follow_no_more(&mut self) {
        self.following = None;
        self.app.follow_no_more();
    }
}
