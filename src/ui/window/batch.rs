//! Many files opened together: what each brought, and what is open already.

use eframe::egui::Context;

use super::{
    super::{
        batch_view::{self, Brought},
        lights_quality_view,
        theme::{Theme, waker},
    },
    Window,
};
use crate::app::{
    Command, Known, Opened, Tone, known,
    open::{Came, FileRow, Finished, OpenBefore, Summary},
    pages::{FieldChoice, Page},
};

impl Window {
    /// What came of files that were opened together; one alone is told as one.
    pub(super) fn take_batch(&mut self, mut finished: Finished) {
        if finished.files.len() == 1
            && let Some(file) = finished.files.pop()
        {
            match file.came {
                Came::Loaded(loaded) => self.take(loaded),
                Came::NotRead(why) => {
                    let words = tr!(
                        "{file}: not read, {reason}.",
                        file = file.label,
                        reason = why
                    );
                    self.app.say(Tone::Problem, words);
                }
            }
            return;
        }
        let mut summary = finished.summary();
        for path in finished.named.iter().rev() {
            self.preferences.remember_file(path);
        }
        let (opened, projects) = finished.into_loaded();
        for project in projects {
            self.take(project);
        }
        let brought = self.open_new_ones(opened, &mut summary);
        let is_whole = summary.rows.iter().all(FileRow::is_read);
        let tone = if is_whole { Tone::Info } else { Tone::Problem };
        self.app
            .say_for_now(tone, format!("{}.", summary.headline()));
        self.batch.take(summary, brought);
    }

    /// Opens the files of a batch, in the order of its rows, but those that are open already;
    /// tells what each row brought.
    fn open_new_ones(&mut self, opened: Vec<Opened>, summary: &mut Summary) -> Vec<Brought> {
        let mut brought = vec![Brought::Nothing; summary.rows.len()];
        let is_file = |row: &FileRow| row.is_read() && !row.is_project();
        let read = summary.rows.iter_mut().enumerate();
        let mut read = read.filter(|(_, row)| is_file(row));
        let (mut fresh, mut rows) = (Vec::new(), Vec::new());
        let mut shown = None;
        for file in opened {
            let Some((index, row)) = read.next() else {
                break;
            };
            match known(self.app.document(), &file) {
                Known::All(spectrum, image) => {
                    row.before = OpenBefore::Same;
                    brought[index] = match (spectrum, image) {
                        (Some(key), _) => self.brought(key),
                        (None, Some(key)) => Brought::Image(key),
                        (None, None) => Brought::Nothing,
                    };
                    shown = shown.or(Some(brought[index].clone()));
                    continue;
                }
                Known::OtherValues => row.before = OpenBefore::OtherValues,
                Known::No => {}
            }
            rows.push((index, file.spectra.len(), file.images.len()));
            fresh.push(file);
        }
        self.app.end_gesture();
        if fresh.is_empty() {
            if let Some(shown) = shown {
                self.show_brought(&shown);
            }
            return brought;
        }
        let (own, images) = (
            self.app.document().own.len(),
            self.app.document().images.len(),
        );
        self.app.apply(Command::Open(fresh));
        let (mut own, mut images) = (own, images);
        for (index, spectra, pictures) in rows {
            let document = self.app.document();
            brought[index] = match (document.own.get(own), document.images.get(images)) {
                (Some(entry), _) if spectra > 0 => self.brought(entry.key.clone()),
                (_, Some(image)) if pictures > 0 => Brought::Image(image.key.clone()),
                _ => Brought::Nothing,
            };
            own += spectra;
            images += pictures;
        }
        brought
    }

    fn brought(&self, key: String) -> Brought {
        let entry = self.app.entry(&key);
        let source = entry.map_or_else(String::new, |e| e.spectrum.source.clone());
        Brought::Spectrum { key, source }
    }

    /// Carries out what was asked for in the summary.
    pub(super) fn fulfil_of_batch(&mut self, wish: batch_view::Wish, context: &Context) {
        match wish {
            batch_view::Wish::Say(words) => self.app.say(Tone::Info, words),
            batch_view::Wish::Numbers => {
                self.preferences.page = Page::Many;
                // What was asked of the files is no step of its own.
                self.app
                    .pages_follow(|pages| pages.many.field = FieldChoice::Own);
            }
            batch_view::Wish::Quality => self.lights_quality.open(self.batch.keys()),
            batch_view::Wish::Show(brought) => {
                self.app.end_gesture();
                if !self.show_brought(&brought) {
                    let words = said!("The spectra of that file are not open any more.");
                    self.app.say(Tone::Info, words);
                }
            }
            batch_view::Wish::Look(brought) => {
                if self.show_brought(&brought)
                    && let Brought::Spectrum { key, .. } = brought
                {
                    self.library.wants_reading = Some(key);
                }
            }
        }
        // Plot and library were drawn before.
        context.request_repaint();
    }

    /// The window that compares the quality of lights.
    pub(super) fn quality_of_lights(
        &mut self,
        context: &Context,
        theme: Theme,
        keys_are_free: bool,
    ) {
        let keys = std::mem::take(&mut self.library.wants_quality);
        if !keys.is_empty() {
            self.lights_quality.open(keys);
        }
        let scene = (&self.app, &mut self.studies, &waker(context));
        let wish = self
            .lights_quality
            .window(context, scene, theme, keys_are_free);
        match wish {
            None => return,
            Some(lights_quality_view::Wish::Say(words)) => self.app.say(Tone::Info, words),
            Some(lights_quality_view::Wish::Show(key)) => {
                if let Some(entry) = self.app.entry(&key) {
                    self.app.apply(Command::Show(entry));
                    self.app.end_gesture();
                }
            }
        }
        // Plot and library were drawn before.
        context.request_repaint();
    }

    /// Shows a spectrum or an image that a file brought; `false` where it is there no more.
    fn show_brought(&mut self, brought: &Brought) -> bool {
        match brought {
            Brought::Nothing => false,
            Brought::Spectrum { key, source } => {
                let entry = self.app.entry(key);
                let Some(entry) = entry.filter(|e| e.spectrum.source == *source) else {
                    return false;
                };
                self.app.apply(Command::Show(entry));
                let page = &mut self.preferences.page;
                if *page == Page::Image {
                    *page = Page::Spectrum;
                }
                true
            }
            Brought::Image(key) => {
                let images = &self.app.document().images;
                let is_there = images.iter().any(|image| image.key == *key);
                if is_there {
                    self.app.pages_follow(|pages| pages.image.choose(key));
                    self.preferences.page = Page::Image;
                }
                is_there
            }
        }
    }

    /// Shows again what is open already; `false` where the file is to be opened.
    pub(super) fn show_again(&mut self, opened: &Opened, known: Known) -> bool {
        let Known::All(spectrum, image) = known else {
            return false;
        };
        self.app.end_gesture();
        if let Some(key) = image.filter(|_| opened.spectra.is_empty()) {
            self.show_brought(&Brought::Image(key));
        }
        if let Some(key) = spectrum {
            self.show_brought(&self.brought(key));
        }
        let words = tr!(
            "{file} is open already, with the same values.",
            file = opened.file
        );
        self.app.say(Tone::Info, words);
        true
    }
}
