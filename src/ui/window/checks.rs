//! Lessons of files that are being checked, on a thread of their own: each is played through, and the
//! pages that it points at are drawn.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use super::super::{picture, theme::Wake};
use crate::{
    app::{
        App,
        lessons::{self, Findings, Lesson, shelf},
        pages::Page,
        studies::{Job, Work as _},
        workspace::Preferences,
    },
    study::Progress,
};

/// A lesson that holds, or what is wrong with it.
pub(super) type Checked = Result<Arc<Lesson>, String>;

/// The checks under way, and the files behind them.
#[derive(Default)]
pub(super) struct LessonChecks {
    job: Job<u64, Vec<Checked>>,
    waiting: Vec<PathBuf>,
    /// How often was asked, and up to which question the answers were taken in.
    asked: u64,
    taken: u64,
}

impl LessonChecks {
    /// Has files checked, after those that were asked about before.
    pub(super) fn ask(&mut self, paths: Vec<PathBuf>, wake: &Wake) {
        self.waiting.extend(paths);
        self.go_on(wake);
    }

    /// Whether something is being checked.
    pub(super) fn is_busy(&self) -> bool {
        self.asked != self.taken || !self.waiting.is_empty()
    }

    /// What was found since the last time, each once.
    pub(super) fn take_in(&mut self, wake: &Wake) -> Vec<Checked> {
        self.job.take_in();
        if self.asked == self.taken || self.job.is_running() {
            return Vec::new();
        }
        self.taken = self.asked;
        let found = match self.job.result_for(&self.asked) {
            Some(found) => found.to_vec(),
            None => vec![Err(said!("The check of a lesson broke down.").to_owned())],
        };
        self.go_on(wake);
        found
    }

    fn go_on(&mut self, wake: &Wake) {
        if self.asked != self.taken || self.waiting.is_empty() {
            return;
        }
        self.asked += 1;
        let paths = std::mem::take(&mut self.waiting);
        self.job.ask(&self.asked, wake, || {
            move |_: &Progress| Some(paths.iter().map(|path| checked(path)).collect())
        });
    }
}

/// A lesson as `lessons check` checks it.
fn checked(path: &Path) -> Checked {
    let names = |app: &App, page: Page| {
        let preferences = Preferences {
            page,
            ..Preferences::default()
        };
        Some(picture::names(app, &preferences))
    };
    let lesson = shelf::read_whole(path).map_err(|faults| Findings::lines(&faults))?;
    let found = lessons::check(&lesson, &names);
    match found.faults.is_empty() {
        true => Ok(Arc::new(lesson)),
        false => Err(Findings::lines(&found.faults)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn files_are_checked_beside_the_window_and_those_that_come_meanwhile_wait() {
        let folder = tempfile::tempdir().expect("a folder");
        let samples = |(name, _): &&(&str, &str)| *name == "samples";
        let (_, text) = shelf::FILES.iter().find(samples).expect("shipped");
        let put = |name: &str, text: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).expect("a file");
            path
        };
        let text: &str = text;
        let wrong = put("wrong.json", &text.replacen("\"say\"", "\"sya\"", 1));
        let good = put("good.json", text);
        let wake: Wake = Arc::new(|| {});
        let mut checks = LessonChecks::default();
        assert!(!checks.is_busy() && checks.take_in(&wake).is_empty());
        checks.ask(vec![wrong], &wake);
        assert!(checks.is_busy());
        checks.ask(vec![good], &wake);
        let mut found = Vec::new();
        while checks.is_busy() {
            found.extend(checks.take_in(&wake));
            std::thread::sleep(Duration::from_millis(2));
        }
        let [first, second] = &found[..] else {
            panic!("two answers: {found:?}");
        };
        let why = first.as_ref().expect_err("it has a fault");
        assert!(why.contains("found the field `sya`"), "{why}");
        let lesson = second.as_ref().expect("it holds");
        assert_eq!(lesson.text, text);
        assert!(checks.take_in(&wake).is_empty());
    }
}
