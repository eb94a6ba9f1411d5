//! Spectral images that come in: opened now, or read again after a restart.

use std::sync::Arc;

use eframe::egui::Context;

use super::{super::theme::waker, Window};
use crate::app::{Command, Tone, pages::Page, picture::reload::News, workspace::StoredImage};

impl Window {
    /// Images that are to be read again, as a workspace or project names them.
    pub fn bring_back(&mut self, images: Vec<StoredImage>, context: &Context) {
        self.images.bring_back(images, &waker(context));
    }

    /// What came from the thread that reads images again.
    pub(super) fn take_images(&mut self, context: &Context) {
        let stored = std::mem::take(&mut self.stored_images);
        self.bring_back(stored, context);
        for news in self.images.news() {
            match news {
                News::Back(image) => self.app.apply(Command::ImageIsBack(Arc::new(image))),
                News::Lost(_, why) => {
                    let words = tr!(
                        "An image of your last session is missing: {reason}",
                        reason = why
                    );
                    self.app.say(Tone::Problem, words);
                }
                // Late news: the file is here already.
                News::Needs(_) if !self.loader.is_busy() => {}
                News::Needs(words) => self.app.say(Tone::Info, words),
            }
        }
    }

    /// The last `count` images of the document were opened just now; `alone` when their files
    /// brought no spectra: then the page shows them by itself.
    pub(super) fn images_opened(&mut self, count: usize, alone: bool) {
        let images = &self.app.document().images;
        let first = images.len().checked_sub(count.max(1));
        let Some(first) = first.filter(|_| count > 0).and_then(|i| images.get(i)) else {
            return;
        };
        let key = first.key.clone();
        self.app.pages_follow(|pages| pages.image.choose(&key));
        if alone {
            self.preferences.page = Page::Image;
        }
    }
}
