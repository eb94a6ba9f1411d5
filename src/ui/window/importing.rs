//! The look at how a file was read: when it opens, and what its buttons do.

use eframe::egui;
use egui::{Context, Rect};

use super::{
    super::{
        import_view::Wish,
        theme::{Theme, waker},
    },
    Window,
};
use crate::app::{
    Command, Opened, Tone,
    import::{Again, Import},
};

impl Window {
    /// Takes a file in; when it came alone and is doubtful, shows how it was read.
    pub(super) fn open_and_ask(&mut self, opened: Opened) {
        let asked = opened.is_doubtful().then(|| opened.clone());
        self.app.apply(Command::Open(vec![opened]));
        if let Some(opened) = asked {
            self.import.open(Import::of(&self.app, opened));
        }
    }

    /// The window over the plot.
    pub(super) fn importing(&mut self, context: &Context, theme: Theme, centre: Rect) {
        let wake = waker(context);
        let document = self.app.document();
        if let Some(key) = self.library.wants_reading.take() {
            let own = document.own.iter().find(|entry| entry.key == key);
            let from = own.and_then(|entry| entry.origin.file());
            self.import.again = from.map(|from| Again::of(from, &wake));
        }
        if let Some(done) = self.import.again.as_mut().and_then(Again::finished) {
            self.import.again = None;
            match done {
                Ok(import) => self.import.open(Some(import)),
                Err(why) => self.app.say(Tone::Problem, why),
            }
            context.request_repaint();
        }
        let keys_are_free = self.dialog.is_none();
        let wishes = self
            .import
            .show(context, &self.app, theme, centre, keys_are_free);
        for wish in wishes {
            match wish {
                Wish::Flip(flip) => {
                    if let Some(import) = &mut self.import.now {
                        import.flip(flip, &wake);
                    }
                }
                Wish::About(about) => {
                    if let Some(import) = &mut self.import.now {
                        import.ask_about(about);
                    }
                    context.request_repaint();
                }
                Wish::Keep => {
                    drop(self.import.close());
                    // It was drawn once more before.
                    context.request_repaint();
                }
                Wish::Remove => {
                    if let Some(import) = self.import.close() {
                        self.app.apply(import.removal(&self.app));
                        self.app.end_gesture();
                        let file = &import.opened().file;
                        let words = tr!("{file} was taken out again.", file);
                        self.app.say(Tone::Info, words);
                    }
                    context.request_repaint();
                }
                Wish::Save(chart) => self.save_chart(chart, context),
            }
        }
        if let Some(import) = &mut self.import.now
            && import.settle(&mut self.app)
        {
            // The plot was drawn before.
            context.request_repaint();
        }
    }
}
