//! Images of the last time, read again from their files on a thread of its own; and what a file
//! will need, told before it is read.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use crate::{
    app::{
        open::{Loaded, load_path_as, unshaken},
        opened::ImageEntry,
        origin::FromFile,
        worker::{Wake, Worker, news_of},
        workspace::StoredImage,
    },
    io::{budget, envi},
};

/// What a thread has to tell.
#[derive(Debug)]
pub enum News {
    /// An image is there again.
    Back(ImageEntry),
    /// An image is not: a sentence says why.
    Lost(StoredImage, String),
    /// What a file that is being read needs, a sentence.
    Needs(String),
}

/// Reads images again.
#[derive(Default)]
pub struct ReloadJob {
    workers: Vec<Worker<News>>,
    waiting: Vec<StoredImage>,
    lost: Vec<StoredImage>,
}

/// Data above this are told of before they are read, bytes.
const WORTH_TELLING: usize = 16 << 20;

impl ReloadJob {
    /// Starts reading images again; `wake` is called when each one is there.
    pub fn bring_back(&mut self, images: Vec<StoredImage>, wake: &Wake) {
        if images.is_empty() {
            return;
        }
        self.waiting.extend(images.iter().cloned());
        self.workers.push(Worker::start(wake, move |tell| {
            // A file with several images is read once.
            let mut last: Option<(StoredImage, Result<Vec<ImageEntry>, String>)> = None;
            for stored in images {
                let is_of = |(of, _): &(StoredImage, _)| {
                    (&of.path, &of.choices) == (&stored.path, &stored.choices)
                };
                if !last.as_ref().is_some_and(is_of) {
                    last = Some((stored.clone(), images_of(&stored)));
                }
                let found = last.as_ref().map(|(_, found)| found);
                let news = match found.map(|found| pick(found, &stored)) {
                    Some(Ok(image)) => News::Back(image),
                    Some(Err(why)) => News::Lost(stored, why),
                    None => return,
                };
                if !tell.show(news) {
                    return;
                }
            }
        }));
    }

    /// Looks at headers for what their data need.
    pub fn tell_needs(&mut self, paths: &[PathBuf], wake: &Wake) {
        let may_be_large = |path: &&PathBuf| {
            let known = envi::FORMAT.extensions;
            let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
            ending.is_none_or(|ending| known.contains(&ending.as_str()))
        };
        let paths: Vec<PathBuf> = paths.iter().filter(may_be_large).cloned().collect();
        if paths.is_empty() {
            return;
        }
        self.workers.push(Worker::start(wake, move |tell| {
            let needs = paths.iter().filter_map(|path| needs(path));
            // Nobody listens any more once the window is closed.
            for _ in needs.take_while(|words| tell.show(News::Needs(words.clone()))) {}
        }));
    }

    /// What has come since the last call.
    pub fn news(&mut self) -> Vec<News> {
        let mut news = news_of(&mut self.workers);
        let (waiting, lost) = (&mut self.waiting, &mut self.lost);
        news.retain(|one| {
            let key = match one {
                News::Back(image) => &image.key,
                News::Lost(stored, _) => &stored.key,
                News::Needs(_) => return true,
            };
            let place = waiting.iter().position(|waiting| waiting.key == *key);
            let is_awaited = place.map(|place| waiting.remove(place)).is_some();
            if let News::Lost(stored, _) = one
                && is_awaited
            {
                lost.push(stored.clone());
            }
            // What was forgotten meanwhile is no news.
            is_awaited
        });
        news
    }

    /// Nobody waits for images any more: they were of another document.
    pub fn forget(&mut self) {
        self.waiting.clear();
        self.lost.clear();
    }

    /// Images that are still being read.
    pub fn waiting(&self) -> &[StoredImage] {
        &self.waiting
    }

    /// Images that were not found this time.
    pub fn lost(&self) -> &[StoredImage] {
        &self.lost
    }

    /// Gives up the images that were not found.
    pub fn give_up(&mut self) {
        self.lost.clear();
    }

    /// What the workspace names besides the images that are there: a disk that is not plugged in
    /// today may be tomorrow.
    pub fn absent(&self) -> Vec<StoredImage> {
        self.waiting.iter().chain(&self.lost).cloned().collect()
    }
}

/// One image of a file as it was known before.
///
/// # Errors
/// A sentence that says why there is none.
pub fn read_again(stored: &StoredImage) -> Result<ImageEntry, String> {
    pick(&images_of(stored), stored)
}

fn pick(
    found: &Result<Vec<ImageEntry>, String>,
    stored: &StoredImage,
) -> Result<ImageEntry, String> {
    let StoredImage {
        key,
        path,
        index,
        choices: _,
    } = stored;
    let images = found.as_ref().map_err(Clone::clone)?;
    let image = images.get(*index).ok_or_else(|| {
        tr!(
            "{file}: found {count} images, expected number {number} again",
            file = path.display(),
            count = images.len(),
            number = index + 1
        )
    })?;
    Ok(ImageEntry {
        key: key.clone(),
        ..image.clone()
    })
}

fn images_of(stored: &StoredImage) -> Result<Vec<ImageEntry>, String> {
    let StoredImage { path, choices, .. } = stored;
    let reading = stored.reading();
    match unshaken(path.display(), || load_path_as(path, choices)) {
        Loaded::File(opened) => Ok(opened
            .images
            .iter()
            .enumerate()
            .map(|(index, image)| ImageEntry {
                key: String::new(),
                from: FromFile {
                    reading: reading.clone(),
                    index,
                },
                image: Arc::clone(image),
            })
            .collect()),
        Loaded::Refused(why) => Err(why),
        Loaded::Project { .. } => Err(tr!(
            "{file}: found a project, expected an image again",
            file = path.display()
        )),
    }
}

/// "scene.hdr: 2000 x 1500 pixels, 31 bands, needs 186 MB of memory."
fn needs(path: &Path) -> Option<String> {
    let header = envi::needs(path).ok()?;
    let (width, height, bands) = (header.width, header.height, header.channels);
    let bytes = header.bytes()?;
    let name = path.file_name()?.to_string_lossy();
    (bytes >= WORTH_TELLING).then(|| {
        tr!(
            "{file}: {width} x {height} pixels, {bands} bands, takes {memory} of memory; being \
             read.",
            file = name,
            width,
            height,
            bands,
            memory = budget::in_words(bytes)
        )
    })
}
