//! The user's own spectra and images: how they join, change, follow what they are made of, and go.

use std::sync::Arc;

use super::{App, Tone};
use crate::{
    app::{
        command::MadeFor,
        document::{Document, FIRST_LIGHT, MOST_OWN_PATCHES, Subject},
        entry::Entry,
        make::{self, WhyNot},
        measured::is_sigma_of,
        memo::ByAddress,
        opened::{ImageEntry, Opened},
        origin::{FileReading, FromFile, MadeBy, Origin, SourceFile},
        products::{Link, MOST_LINKS},
        recipe::Recipe,
    },
    spectrum::{Kind, NamedSpectrum},
};

impl App {
    /// Takes spectra in and shows the first; the first of those that are `sure`, where there are.
    pub(super) fn adopt(&mut self, spectra: impl Iterator<Item = Entry>, sure: &[bool]) {
        let before = self.document.own.len();
        for entry in spectra {
            let entry = self.numbered(entry);
            self.document.own.push(entry);
        }
        // Among many files the first may be one that is only drawn over another.
        let new = &self.document.own[before..];
        let mut known = new.iter().zip(sure).filter(|(_, sure)| **sure);
        let first = known
            .find_map(|(entry, _)| entry.is_usable().then_some(entry))
            .or(new.iter().find(|e| e.is_usable()))
            .or(new.first())
            .cloned();
        if let Some(entry) = first {
            self.show(entry);
        }
    }

    /// The next free number among own spectra and images.
    fn next_number(&mut self) -> u64 {
        let number = self.document.next_own;
        self.document.next_own = number.saturating_add(1);
        number
    }

    /// One of the user's own, under the next free number.
    pub(super) fn numbered(&mut self, entry: Entry) -> Arc<Entry> {
        let Entry { key, .. } = Entry::own(self.next_number(), entry.spectrum.clone());
        Arc::new(Entry { key, ..entry })
    }

    pub(super) fn take_in(&mut self, files: Vec<Opened>) {
        // Of several files the first is shown.
        let sure: Vec<bool> = match &files[..] {
            [file] => {
                let doubtful = file.doubtful_kinds().into_iter().enumerate();
                let joins = doubtful.filter(|(index, _)| !file.is_sigma(*index));
                joins.map(|(_, doubtful)| !doubtful).collect()
            }
            _ => Vec::new(),
        };
        let before = self.document.looks();
        let mut spectra = Vec::new();
        for file in files {
            let source = SourceFile {
                path: file.path.clone(),
                bytes: file.bytes.clone(),
                name: file.file.clone(),
                images_only: false,
                before: before.clone(),
            };
            let reading = reading(&file, Arc::new(source));
            for (index, image) in file.images.iter().enumerate() {
                let key = format!("image/{}", self.next_number());
                let from = FromFile {
                    reading: reading.clone(),
                    index,
                };
                let image = image.clone();
                let entry = ImageEntry { key, from, image };
                self.document.images.push(Arc::new(entry));
            }
            let all = file.spectra.iter().enumerate();
            let all = all.filter(|(index, _)| !file.is_sigma(*index));
            spectra.extend(all.map(|(index, _)| joining(&file, index, &reading)));
        }
        self.adopt(spectra.into_iter(), &sure);
    }

    /// Puts what was read anew in the place of what a file brought before.
    pub(super) fn reread(&mut self, key: &str, opened: &Opened) {
        let document = &self.document;
        let own = document.own.iter().find(|entry| entry.key == key);
        let image = document.images.iter().find(|image| image.key == key);
        let from = own.and_then(|entry| entry.origin.file());
        let Some(from) = from.or(image.map(|image| &image.from)) else {
            return;
        };
        let from = from.clone();
        let file = &ByAddress(from.reading.file.clone());
        let reading = reading(opened, file.0.clone());
        self.reread_images(file, opened, &reading);
        let of_file = |entry: &Arc<Entry>| {
            let from = entry.origin.file().filter(|from| from.is_of(file))?;
            Some((entry.key.clone(), from.index, from.reading.spectra))
        };
        let mut known: Vec<_> = self.document.own.iter().filter_map(of_file).collect();
        known.sort_by_key(|(_, index, _)| *index);
        let first = |app: &Self| {
            let (key, ..) = known.first()?;
            app.document.own.iter().find(|e| e.key == *key).cloned()
        };
        let was_shown = first(self).is_some_and(|entry| entry.is_usable());
        for (key, index, _) in &known {
            let spectrum = opened.spectra.get(*index);
            let Some(spectrum) = spectrum.filter(|_| !opened.is_sigma(*index)) else {
                self.remove(key);
                continue;
            };
            let makers = opened.makers_of(*index);
            let measured = opened.measured_of(*index);
            self.change_entry(key, |entry| {
                entry.spectrum = spectrum.clone();
                entry.measured.clone_from(&measured);
                entry.makers.clone_from(&makers);
                entry.composite = opened.composite_of(*index);
                entry.origin = Origin::File(FromFile {
                    reading: reading.clone(),
                    index: *index,
                });
            });
        }
        // Those that a person took out stay out.
        let before = known.first().map_or(0, |(.., spectra)| *spectra);
        let was_taken = from.reading.choices.take_sigma;
        let was_sigma = |index: usize| {
            let name = |index: usize| opened.spectra.get(index).map(|s| s.name.as_str());
            let pair = index.checked_sub(1).and_then(name).zip(name(index));
            was_taken && pair.is_some_and(|(of, title)| is_sigma_of(title, of) == Some(false))
        };
        let new = (0..opened.spectra.len()).filter(|index| *index >= before || was_sigma(*index));
        for index in new.filter(|index| !opened.is_sigma(*index)) {
            let entry = self.numbered(joining(opened, index, &reading));
            self.document.own.push(entry);
        }
        // What was an overlay at best and is a light now is shown as one.
        if let Some(entry) = first(self)
            && !was_shown
            && entry.is_usable()
        {
            self.document.overlays.retain(|o| o.key != entry.key);
            self.show(entry);
        }
    }

    fn reread_images(
        &mut self,
        file: &ByAddress<SourceFile>,
        opened: &Opened,
        reading: &Arc<FileReading>,
    ) {
        for known in &mut self.document.images {
            let index = known.from.index;
            let image = opened.images.get(index);
            if let Some(image) = image.filter(|_| known.from.is_of(file)) {
                *known = Arc::new(ImageEntry {
                    key: known.key.clone(),
                    from: FromFile {
                        reading: reading.clone(),
                        index,
                    },
                    image: image.clone(),
                });
            }
        }
    }

    pub(super) fn rename(&mut self, key: &str, name: &str) {
        self.change_entry(key, |entry| {
            name.clone_into(&mut entry.spectrum.name);
            if let Origin::Made(made) = &mut entry.origin {
                made.name = Some(name.to_owned());
            }
        });
    }

    pub(super) fn change_entry(&mut self, key: &str, change: impl Fn(&mut Entry)) {
        let Some(old) = self.document.own.iter().find(|e| e.key == key) else {
            return;
        };
        let mut entry = Entry::clone(old);
        change(&mut entry);
        // The same everywhere: what is on screen is what is in the library.
        let entry = Arc::new(entry);
        let document = &mut self.document;
        let everywhere = document
            .own
            .iter_mut()
            .chain(&mut document.overlays)
            .chain(&mut document.factor)
            .chain(&mut document.second)
            .chain(std::iter::once(&mut document.light))
            .chain(document.products.entries_mut());
        for held in everywhere.filter(|e| e.key == key) {
            *held = entry.clone();
        }
        // What is no factor any more leaves the chain.
        let products = std::mem::take(&mut self.document.products);
        self.document.products = products.clamped();
        let second = &mut self.document.second;
        second.take_if(|second| second.kind() != Kind::Light);
        // A light that turned into a reflectance changes its place.
        let is_light = self.document.light.key == key;
        let is_factor = self.document.factor.as_ref().is_some_and(|f| f.key == key);
        if is_light && entry.kind() != Kind::Light {
            self.document.light = self.the_first_light();
            self.show(entry);
        } else if is_factor && !entry.kind().is_factor() {
            self.document.factor = None;
            self.show(entry);
        }
    }

    pub(super) fn remove(&mut self, key: &str) {
        self.document.own.retain(|e| e.key != key);
        self.document.overlays.retain(|e| e.key != key);
        self.document.second.take_if(|second| second.key == key);
        self.document.edits.remove(key);
        self.document.products.forget(key);
        self.document.pages.forget(key);
        self.document.own_patches.retain(|known| known != key);
        self.freeze_what_stands_on(key);
        if self.document.factor.as_ref().is_some_and(|f| f.key == key) {
            self.document.factor = None;
            self.document.subject = Subject::Light;
        }
        if self.document.light.key == key {
            self.document.light = self.the_first_light();
        }
        self.document.show_again();
    }

    fn the_first_light(&self) -> Arc<Entry> {
        self.entry(FIRST_LIGHT)
            .unwrap_or_else(|| self.bundled()[0].clone())
    }

    /// Makes a spectrum, one of the user's own from now on.
    pub(super) fn make(&mut self, recipe: Recipe, place: MadeFor) {
        let made = match make::make(&recipe, &self.document) {
            Ok(made) => made,
            Err(why) => return self.say(Tone::Problem, tr!("It cannot be made: {why}.", why)),
        };
        let made = Entry {
            origin: Origin::Made(MadeBy { recipe, name: None }),
            ..made
        };
        match place {
            MadeFor::Shown => self.adopt(std::iter::once(made), &[]),
            MadeFor::Outgoing => {
                let entry = self.join(made);
                self.document.products.outgoing = Some(entry);
            }
            MadeFor::Chain if self.document.products.chain.len() >= MOST_LINKS => {
                let words = tr!("The chain is full: it has {most} links.", most = MOST_LINKS);
                self.say(Tone::Problem, words);
            }
            MadeFor::Chain => {
                let entry = self.join(made);
                self.document.products.chain.push(Link::once(entry));
            }
            MadeFor::Patches => {
                let entry = self.join(made);
                self.toggle_own_patch(&entry.key);
            }
        }
    }

    /// Puts an own surface behind the patches, or takes it away.
    pub(super) fn toggle_own_patch(&mut self, key: &str) {
        let keys = &mut self.document.own_patches;
        match keys.iter().position(|known| known == key) {
            Some(index) => drop(keys.remove(index)),
            None if keys.len() < MOST_OWN_PATCHES => keys.push(key.to_owned()),
            None => {
                let words = tr!(
                    "{most} own surfaces are the most in a set.",
                    most = MOST_OWN_PATCHES
                );
                self.say(Tone::Problem, words);
            }
        }
        self.document.patch = None;
    }

    pub(super) fn make_otherwise(&mut self, key: &str, recipe: Recipe) {
        let why = if make::stands_on(&recipe, &self.document, key) {
            Some(WhyNot::Circle)
        } else {
            self.remake(key, &recipe).err()
        };
        if let Some(why) = why {
            self.say(Tone::Problem, tr!("It cannot be made so: {why}.", why));
        }
    }

    /// Makes again what stands on something that changed since `before`. What cannot be made any
    /// more keeps its numbers.
    pub(super) fn make_again(&mut self, before: &Document) {
        let made: Vec<(String, Recipe)> = self
            .document
            .own
            .iter()
            .filter_map(|entry| Some((entry.key.clone(), entry.origin.recipe()?.clone())))
            .collect();
        for (key, recipe) in made {
            // In the order in which they were made, so that one can stand on another.
            let now = make::signature(&recipe, &self.document);
            if now != make::signature(&recipe, before) && self.remake(&key, &recipe).is_err() {
                // Its numbers are the last that could be made.
            }
        }
    }

    fn remake(&mut self, key: &str, recipe: &Recipe) -> Result<(), WhyNot> {
        let made = make::make(recipe, &self.document)?;
        let mut own = self.document.own.iter();
        let Some(entry) = own.find(|entry| entry.key == key) else {
            return Ok(());
        };
        let name = entry.origin.made().and_then(|made| made.name.clone());
        let spectrum = NamedSpectrum {
            name: name.clone().unwrap_or_else(|| made.spectrum.name.clone()),
            ..made.spectrum
        };
        let origin = Origin::Made(MadeBy {
            recipe: recipe.clone(),
            name,
        });
        if (&entry.spectrum, &entry.origin) != (&spectrum, &origin)
            || (&entry.measured, &entry.composite) != (&made.measured, &made.composite)
        {
            self.change_entry(key, |entry| {
                entry.spectrum = spectrum.clone();
                entry.measured.clone_from(&made.measured);
                entry.composite.clone_from(&made.composite);
                entry.origin = origin.clone();
            });
        }
        Ok(())
    }

    /// The numbers stay as they are.
    pub(super) fn freeze(&mut self, key: &str) {
        let mut own = self.document.own.iter();
        if own.any(|entry| entry.key == key && entry.origin.recipe().is_some()) {
            self.change_entry(key, |entry| entry.origin = Origin::Numbers);
        }
    }

    /// What was made of something that is gone is what it was.
    pub(super) fn freeze_what_stands_on(&mut self, key: &str) {
        let stands = |entry: &&Arc<Entry>| {
            let recipe = entry.origin.recipe();
            recipe.is_some_and(|recipe| recipe.stands_on().contains(&key))
        };
        let own = self.document.own.iter().filter(stands);
        let keys: Vec<String> = own.map(|entry| entry.key.clone()).collect();
        for key in keys {
            self.freeze(&key);
        }
    }

    /// An image of the last time was read again: it stands where it stood, in every step of the
    /// history too. That it was away for a moment is nothing to undo.
    pub(super) fn image_is_back(&mut self, image: &Arc<ImageEntry>) {
        let number = |key: &str| key.rsplit('/').next().and_then(|n| n.parse::<u64>().ok());
        let documents = std::iter::once(&mut self.document).chain(self.history.all_mut());
        for document in documents {
            let images = &mut document.images;
            if images.iter().any(|known| known.key == image.key) {
                continue;
            }
            let before = |known: &Arc<ImageEntry>| number(&known.key) < number(&image.key);
            let place = images.partition_point(before);
            images.insert(place, image.clone());
            if let Some(number) = number(&image.key) {
                document.next_own = document.next_own.max(number.saturating_add(1));
            }
        }
        self.revision += 1;
    }
}

fn reading(opened: &Opened, file: Arc<SourceFile>) -> Arc<FileReading> {
    Arc::new(FileReading {
        file,
        choices: opened.choices.clone(),
        spectra: opened.spectra.len(),
    })
}

/// One of a file's spectra, as it joins the user's own.
fn joining(file: &Opened, index: usize, reading: &Arc<FileReading>) -> Entry {
    let reading = reading.clone();
    Entry {
        makers: file.makers_of(index),
        origin: Origin::File(FromFile { reading, index }),
        composite: file.composite_of(index),
        measured: file.measured_of(index),
        ..Entry::own(0, file.spectra[index].clone())
    }
}
