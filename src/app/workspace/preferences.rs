//! How the window looks, kept beside the document.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Deserializer, Serialize, de::Error as _};

use crate::{
    app::{
        derived::OF_CURVE,
        following::FollowAsked,
        pages::{AskedLesson, Page, Place},
        stored_path,
    },
    color::MissingCones,
    languages::Language,
    study::Measure,
};

/// How the window looks; not part of undo.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Preferences {
    /// Dark surroundings.
    pub dark: bool,
    /// The window is shown as an eye without these cones sees it.
    pub without_cones: Option<MissingCones>,
    /// Zoom of the whole window, 0.8-2.5.
    pub zoom: f32,
    /// Targets are large enough for fingers; `None` until the window is touched or a person chooses.
    pub touch: Option<bool>,
    /// Presenting: plot, swatch, patches and the two sliders alone, large.
    pub present: bool,
    /// Files opened last, newest first.
    #[serde(with = "stored_path::list")]
    pub recent: Vec<PathBuf>,
    /// Inner size of the window in points, if it was ever shown.
    pub window: Option<[f32; 2]>,
    /// What the error-against-order curve shows.
    #[serde(deserialize_with = "of_curve")]
    pub curve: Measure,
    /// The shelves that are folded in the library.
    pub folded: Vec<String>,
    /// The library stays open beside the page.
    pub pinned: bool,
    /// The ways to begin were seen.
    pub greeted: bool,
    /// By how much type is larger in a large window: the window finds it anew.
    #[serde(skip)]
    pub grown: f32,
    /// The page shown.
    pub page: Page,
    /// The pages that were shown last, one a place: the rail leads back to them.
    pub last_of_places: Vec<Page>,
    /// Names of the lessons that were gone through.
    pub lessons_finished: Vec<String>,
    /// The language of the window.
    pub language: Language,
    /// Tables that are saved or copied have decimal commas, for spreadsheets.
    pub decimal_commas: bool,
    /// The code of the language that lessons are shown in, where they have texts in it.
    pub lesson_language: String,
    /// Photographs of spectra that are to be read, and files of instruments, once.
    #[serde(skip)]
    pub photographs_asked: Vec<PathBuf>,
    /// A lesson that is to be begun, once.
    #[serde(skip)]
    pub lesson_asked: Option<AskedLesson>,
    /// What is to be followed, once.
    #[serde(skip)]
    pub follow_asked: Option<FollowAsked>,
}

impl Preferences {
    /// Whether a page is being presented: it has the window alone, in large type.
    pub fn presents(&self) -> bool {
        self.present
    }
}

impl Default for Preferences {
    fn default() -> Self {
        Self {
            dark: true,
            without_cones: None,
            zoom: 1.0,
            touch: None,
            present: false,
            recent: Vec::new(),
            window: None,
            curve: Measure::PatchesWorst,
            folded: FOLDED_AT_FIRST.map(str::to_owned).to_vec(),
            pinned: false,
            greeted: false,
            grown: 1.0,
            page: Page::Spectrum,
            last_of_places: Vec::new(),
            lessons_finished: Vec::new(),
            language: Language::English,
            decimal_commas: false,
            lesson_language: Language::English.code().to_owned(),
            photographs_asked: Vec::new(),
            lesson_asked: None,
            follow_asked: None,
        }
    }
}

/// Shelves of the library that start folded: there are hundreds of reflectances.
pub const FOLDED_AT_FIRST: [&str; 3] = ["Reflectances", "Filters and glasses", "Observers"];

/// Smallest and largest zoom.
pub const ZOOMS: [f32; 2] = [0.8, 2.5];

impl Preferences {
    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(mut self) -> Self {
        self.zoom = if self.zoom.is_finite() {
            self.zoom.clamp(ZOOMS[0], ZOOMS[1])
        } else {
            1.0
        };
        self.window = self
            .window
            .filter(|size| size.iter().all(|s| (200.0..=20_000.0).contains(s)));
        self.recent.truncate(MOST_RECENT);
        // One page a place, the last.
        let (page, all) = (self.page, std::mem::take(&mut self.last_of_places));
        for last in all {
            self.page = last;
            self.note_page();
        }
        self.page = page;
        self
    }

    /// Remembers the page that is shown as the last of its place.
    pub fn note_page(&mut self) {
        let page = self.page;
        if !self.last_of_places.contains(&page) {
            let is_elsewhere = |other: &Page| other.place() != page.place();
            self.last_of_places.retain(is_elsewhere);
            self.last_of_places.push(page);
        }
    }

    /// Goes to the page of a place that was shown last.
    pub fn go_to(&mut self, place: Place) {
        self.note_page();
        let mut last = self.last_of_places.iter();
        let last = last.find(|page| page.place() == place).copied();
        self.page = last.unwrap_or_else(|| place.first());
    }

    /// Has the window speak a language, and lessons with it.
    pub fn speak(&mut self, language: Language) {
        self.language = language;
        language.code().clone_into(&mut self.lesson_language);
    }

    /// Puts a file on top of the recent ones.
    pub fn remember_file(&mut self, path: &Path) {
        // A browser forgets files with the page.
        if cfg!(target_arch = "wasm32") {
            return;
        }
        self.recent.retain(|p| p != path);
        self.recent.insert(0, path.to_owned());
        self.recent.truncate(MOST_RECENT);
    }
}

/// Recent files kept.
const MOST_RECENT: usize = 12;

/// One of the errors that the curve has.
fn of_curve<'de, D: Deserializer<'de>>(stored: D) -> Result<Measure, D::Error> {
    let measure = Measure::deserialize(stored)?;
    let known = OF_CURVE.contains(&measure).then_some(measure);
    known.ok_or_else(|| D::Error::custom("expected an error of the curve"))
}
