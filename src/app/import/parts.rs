//! Which of a file's spectra or images the questions are about.

use super::{Import, questions::Alike};
use crate::languages::{said, with_colon};

/// Which spectra (or images) of a file the questions are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// All that were understood as the one at this place was.
    Alike(usize),
    /// One alone.
    One(usize),
}

/// Some of a file's spectra or images that can be asked about.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// "all 2 taken as reflectance: R(adaxial), R(abaxial)", or a name with its kind.
    pub words: String,
    /// What takes the questions there.
    pub about: About,
    /// Whether a person should look at it.
    pub doubtful: bool,
}

/// Single spectra that are offered to be asked about.
const MOST_PARTS: usize = 200;

impl Import {
    /// The parts of the file that the questions are about.
    pub(super) fn asked_about(&self) -> Vec<usize> {
        let alike = &self.alike;
        match self.about {
            About::One(at) => vec![at],
            About::Alike(at) => {
                let of = alike.get(at);
                (0..alike.len()).filter(|i| alike.get(*i) == of).collect()
            }
        }
    }

    /// The part that stands for all that are asked about.
    pub(super) fn asked_first(&self) -> usize {
        let (About::One(at) | About::Alike(at)) = self.about;
        at
    }

    pub(super) fn first_doubtful(&self) -> usize {
        let mut alike = self.alike.iter();
        alike.position(|one| one.doubtful).unwrap_or(0)
    }

    /// Which part of the file is asked about.
    pub fn about(&self) -> About {
        self.about
    }

    /// Asks about another part of the file.
    pub fn ask_about(&mut self, about: About) {
        self.about = about;
    }

    /// What of the file can be asked about: those understood alike, then each by itself; nothing
    /// where there is one only.
    pub fn parts(&self) -> Vec<Part> {
        let alike = &self.alike;
        if alike.len() < 2 {
            return Vec::new();
        }
        let mut parts = Vec::new();
        let mut known: Vec<&Alike> = Vec::new();
        for (at, one) in alike.iter().enumerate() {
            if known.contains(&one) {
                continue;
            }
            known.push(one);
            let count = alike.iter().filter(|other| *other == one).count();
            if count > 1 {
                parts.push(Part {
                    words: self.words_of_many(one, count),
                    about: About::Alike(at),
                    doubtful: one.doubtful,
                });
            }
        }
        parts.extend((0..alike.len().min(MOST_PARTS)).map(|at| Part {
            words: with_colon(self.name_of(at), said(alike[at].kind.word())),
            about: About::One(at),
            doubtful: alike[at].doubtful,
        }));
        parts
    }

    /// What is asked about, in words.
    pub fn about_words(&self) -> String {
        let alike = &self.alike;
        let at = self.asked_first();
        match (alike.get(at), self.asked_about().len()) {
            (Some(one), 2..) => self.words_of_many(one, self.asked_about().len()),
            (Some(one), _) => with_colon(self.name_of(at), said(one.kind.word())),
            (None, _) => String::new(),
        }
    }

    fn words_of_many(&self, one: &Alike, count: usize) -> String {
        let kind = said(one.kind.word());
        let all = count == self.alike.len();
        match (all, self.is_of_images(), one.guessed) {
            (true, true, true) => tr!("all {count} images taken as {kind}", count, kind),
            (true, true, false) => tr!("all {count} images of {kind}", count, kind),
            (true, false, true) => tr!("all {count} spectra taken as {kind}", count, kind),
            (true, false, false) => tr!("all {count} spectra of {kind}", count, kind),
            (false, true, true) => tr!("the {count} images taken as {kind}", count, kind),
            (false, true, false) => tr!("the {count} images of {kind}", count, kind),
            (false, false, true) => tr!("the {count} spectra taken as {kind}", count, kind),
            (false, false, false) => tr!("the {count} spectra of {kind}", count, kind),
        }
    }

    pub(super) fn name_of(&self, at: usize) -> &str {
        let opened = self.opened();
        if self.is_of_images() {
            opened.images.get(at).map_or("", |image| &image.name)
        } else {
            opened.spectra.get(at).map_or("", |spectrum| &spectrum.name)
        }
    }
}
