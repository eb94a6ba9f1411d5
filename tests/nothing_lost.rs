//! Nothing is lost: the program killed while it saves, a full disk, a folder that cannot be
//! written, a damaged workspace.

use std::{
    fs,
    io::{BufRead as _, BufReader},
    path::{Path, PathBuf},
    process::{Command as Process, Stdio},
    sync::Arc,
    time::{Duration, Instant},
};

use eframe::egui;
use spectral_explorer::{
    app::{
        App, Command, Settings,
        following::{Asked, FollowAsked, is_capture},
        workspace::{self, Preferences},
    },
    io::{read_bytes, save_atomically},
    streams::Pace,
    ui::{
        Window,
        files::{Ask, Picked},
        saver::Saver,
        shell,
    },
};

/// Where the child that is killed keeps its workspace.
const WORKSPACE: &str = "SPECTRAL_EXPLORER_TEST_KILLED_WORKSPACE";
/// How often it is killed.
const KILLS: usize = 200;
/// Latest moment of a kill after the child's start.
const LATEST: Duration = Duration::from_millis(90);

/// The child: a program whose user never lets go of the slider. Does nothing unless it is told
/// where to save.
#[test]
fn child_that_saves_without_end() {
    let Some(path) = std::env::var_os(WORKSPACE).map(PathBuf::from) else {
        return;
    };
    let mut app = match workspace::load(&path).expect("the last kill left a sound workspace") {
        Some(restored) => {
            assert!(restored.losses.is_empty(), "{:?}", restored.losses);
            App::with_document(restored.document)
        }
        None => {
            let mut app = App::new();
            let table: String = (0..4000)
                .map(|i| format!("{},{}\n", 380.0 + 0.1 * f64::from(i), i % 37))
                .collect();
            let reading = read_bytes("mine.csv", table.as_bytes()).expect("a table");
            app.apply(Command::Adopt(reading.spectra));
            app
        }
    };
    let saver = Saver::new(path);
    for step in 0_usize.. {
        app.apply(Command::Edit(Settings {
            order: step % 40,
            ..app.document().settings
        }));
        app.end_gesture();
        saver.keep(app.document(), &Preferences::default());
        std::thread::sleep(Duration::from_micros(700));
    }
}

#[test]
fn a_program_killed_at_any_moment_leaves_a_workspace_that_loads() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("workspace.json");
    let program = std::env::current_exe().expect("this test's own program");
    let (mut seen, mut random) = (0, 0x9e37_79b9_u32);
    for kill in 0..KILLS {
        let mut child = Process::new(&program)
            .args(["--exact", "child_that_saves_without_end", "--nocapture"])
            .env(WORKSPACE, &path)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("a child");
        // A linear congruential sequence: other moments at every kill, the same in every run.
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let moment = LATEST.mul_f64(f64::from(random) / f64::from(u32::MAX));
        let start = Instant::now();
        // The first child lives until there is something to lose.
        while start.elapsed() < moment || (kill == 0 && !path.exists()) {
            assert!(start.elapsed().as_secs() < 60, "no workspace was saved");
            std::thread::sleep(Duration::from_millis(1));
            let ended = child.try_wait().expect("a child that can be asked");
            assert!(
                ended.is_none(),
                "the child gave up before kill {kill}: {ended:?}"
            );
        }
        child.kill().expect("a child that is alive");
        child.wait().expect("a child that was killed");
        let restored = workspace::load(&path)
            .unwrap_or_else(|why| panic!("after kill {kill}: {why}"))
            .unwrap_or_else(|| panic!("after kill {kill} the workspace is gone"));
        assert!(restored.losses.is_empty(), "{:?}", restored.losses);
        assert_eq!(restored.document.own.len(), 1);
        assert_eq!(restored.document.own[0].spectrum.samples.len(), 4000);
        seen += usize::from(restored.document.settings != Settings::default());
    }
    println!("{KILLS} kills; {seen} workspaces held an edit");
    assert!(seen > KILLS / 2, "the child was hardly ever saving: {seen}");
    // What was being written when the program was killed does not stay for ever.
    let left = || {
        let names = fs::read_dir(folder.path()).expect("the folder");
        names.filter_map(Result::ok).count()
    };
    let before = left();
    workspace::sweep_leftovers(&path, Duration::ZERO);
    println!("{} unfinished files swept", before - left());
    assert_eq!(left(), 1);
}

/// Where the child that captures keeps its workspace; the recording lies beside it.
const CAPTURES: &str = "SPECTRAL_EXPLORER_TEST_CAPTURES_WORKSPACE";

/// The child: a window whose user captures a light at every frame, and is told of each. Does nothing
/// unless it is told where to save.
#[test]
fn child_that_captures_without_end() {
    let Some(path) = std::env::var_os(CAPTURES).map(PathBuf::from) else {
        return;
    };
    let source = Asked::Replay(path.with_extension("jsonl"), Pace::Stepped);
    let preferences = Preferences {
        follow_asked: Some(FollowAsked::new(source)),
        ..Preferences::default()
    };
    let saver = Saver::new(path);
    let no_files = Arc::new(|_: &Ask| Picked::Cancelled);
    let mut window = Window::new(App::new(), preferences, no_files, Some(saver));
    let context = egui::Context::default();
    let enter = egui::Event::Key {
        key: egui::Key::Enter,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: egui::Modifiers::NONE,
    };
    let mut told = 0;
    loop {
        let input = egui::RawInput {
            events: vec![enter.clone()],
            ..egui::RawInput::default()
        };
        context
            .run_ui(input, |ui| window.show(ui))
            .textures_delta
            .clear();
        let own = window.app.document().own.iter();
        let captures = own.filter(|entry| is_capture(entry)).count();
        if captures > told {
            told = captures;
            println!("captured {told}");
        }
    }
}

#[test]
fn a_program_killed_at_any_moment_loses_no_capture_that_it_told_of() {
    let program = std::env::current_exe().expect("this test's own program");
    let nm: Vec<f64> = (380..=780).map(f64::from).collect();
    let line = format!("{{\"time_ms\":1000,\"wavelength_nm\":{nm:?},\"values\":{nm:?}}}\n");
    let mut random = 0x9e37_79b9_u32;
    for kill in 0..12 {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("workspace.json");
        fs::write(path.with_extension("jsonl"), &line).expect("a recording");
        let mut child = Process::new(&program)
            .args(["--exact", "child_that_captures_without_end", "--nocapture"])
            .env(CAPTURES, &path)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("a child");
        let mut lines = BufReader::new(child.stdout.take().expect("a pipe")).lines();
        let mut told = 0;
        let mut hear = |told: &mut usize| -> bool {
            let Some(Ok(line)) = lines.next() else {
                return false;
            };
            let count = line.strip_prefix("captured ");
            *told = count.and_then(|count| count.parse().ok()).unwrap_or(*told);
            true
        };
        // At another capture at every kill, and at another moment of it.
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let wanted = 1 + (random >> 8) as usize % 12;
        while told < wanted {
            assert!(hear(&mut told), "the child gave up before kill {kill}");
        }
        std::thread::sleep(Duration::from_micros(u64::from(random >> 20)));
        child.kill().expect("a child that is alive");
        child.wait().expect("a child that was killed");
        while hear(&mut told) {}
        let restored = workspace::load(&path)
            .unwrap_or_else(|why| panic!("after kill {kill}: {why}"))
            .unwrap_or_else(|| panic!("after kill {kill} the workspace is gone"));
        assert!(restored.losses.is_empty(), "{:?}", restored.losses);
        let own = restored.document.own.iter();
        let found = own.filter(|entry| is_capture(entry)).count();
        assert!(found >= told, "after kill {kill}: {found} of {told}");
        // One may be on disk that the program did not come to tell of.
        assert!(found <= told + 1, "after kill {kill}: {found} of {told}");
    }
}

/// A disk of our own for the time of a test; `None` where this user may not mount one.
struct Disk {
    folder: tempfile::TempDir,
}

impl Disk {
    fn mounted(options: &str) -> Option<Self> {
        let folder = tempfile::tempdir().ok()?;
        let mounted = Process::new("mount")
            .args(["-t", "tmpfs", "-o", options, "tmpfs"])
            .arg(folder.path())
            .stderr(Stdio::null())
            .status();
        if mounted.is_ok_and(|status| status.success()) {
            return Some(Self { folder });
        }
        eprintln!("skipped: this user may not mount a disk");
        None
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }

    fn remount(&self, options: &str) {
        let done = Process::new("mount")
            .args(["-o", options])
            .arg(self.path())
            .status();
        assert!(done.is_ok_and(|status| status.success()));
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        let _ = Process::new("umount").arg(self.path()).status();
    }
}

#[test]
fn a_full_disk_is_a_message_and_the_old_file_stays() {
    let Some(disk) = Disk::mounted("size=64k") else {
        return;
    };
    let path = disk.path().join("workspace.json");
    workspace::save(&path, "the old one").expect("room for a line");
    let refusal = workspace::save(&path, &"x".repeat(200_000)).expect_err("no room for that");
    assert!(refusal.contains("the disk full"), "{refusal}");
    assert_eq!(refusal.lines().count(), 1);
    assert_eq!(
        fs::read_to_string(&path).expect("the old file"),
        "the old one"
    );
    let beside = fs::read_dir(disk.path()).expect("the disk").count();
    assert_eq!(beside, 1, "the half-written file is gone");
    let export = save_atomically(&disk.path().join("plot.png"), &[0; 100_000]);
    assert!(
        export
            .expect_err("no room")
            .to_string()
            .contains("nothing was changed")
    );
}

#[test]
fn a_disk_that_cannot_be_written_is_a_message() {
    let Some(disk) = Disk::mounted("size=64k") else {
        return;
    };
    let path = disk.path().join("workspace.json");
    workspace::save(&path, "the old one").expect("a disk that can be written");
    disk.remount("remount,ro");
    let refusal = workspace::save(&path, "the new one").expect_err("read-only");
    assert!(refusal.contains("read-only"), "{refusal}");
    assert_eq!(
        fs::read_to_string(&path).expect("the old file"),
        "the old one"
    );
}

#[test]
fn a_damaged_workspace_is_kept_aside_under_a_name_that_is_told() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("workspace.json");
    let whole = workspace::to_json(App::new().document(), Some(&Preferences::default())).unwrap();
    // Cut short anywhere, or with a byte changed into another, it loads or is set aside.
    let cuts = (0..whole.len()).step_by(whole.len() / 60 + 1);
    for cut in cuts {
        fs::write(&path, &whole.as_bytes()[..cut]).expect("a file");
        let why = workspace::load(&path).expect_err("half a workspace");
        assert_eq!(why.lines().count(), 1);
        let kept = why.split("kept as ").nth(1).expect("where it is kept");
        let (name, rest) = kept.split_once(" in ").expect("its folder");
        let kept = PathBuf::from(rest.split(" (").next().expect("a folder")).join(name);
        assert_eq!(
            fs::read(&kept).expect("the damaged one"),
            &whole.as_bytes()[..cut]
        );
        assert!(!path.exists(), "the next start begins anew");
        fs::remove_file(kept).expect("swept up");
    }
}

/// Things at a path that are no file, as far as this user may make them; each with what it is.
#[cfg(unix)]
fn no_files(folder: &Path) -> Vec<(PathBuf, std::fs::FileType)> {
    let made = |program: &str, name: &str, rest: &[&str]| {
        let path = folder.join(name);
        let done = Process::new(program)
            .arg(&path)
            .args(rest)
            .stderr(Stdio::null())
            .status();
        done.is_ok_and(|status| status.success()).then_some(path)
    };
    let link = folder.join("link.json");
    std::os::unix::fs::symlink("/dev/null", &link).expect("a link");
    fs::create_dir(folder.join("folder.json")).expect("a folder");
    let device = made("mknod", "device.json", &["c", "1", "3"]);
    if device.is_none() {
        eprintln!("without a device: this user may not make one");
    }
    [
        device,
        made("mkfifo", "pipe.json", &[]),
        Some(link),
        Some(folder.join("folder.json")),
    ]
    .into_iter()
    .flatten()
    .map(|path| {
        let kind = fs::symlink_metadata(&path).expect("made").file_type();
        (path, kind)
    })
    .collect()
}

#[cfg(unix)]
#[test]
fn what_is_no_file_is_neither_renamed_nor_written_nor_waited_for() {
    use std::sync::mpsc::channel;
    let folder = tempfile::tempdir().expect("a temporary folder");
    let all = no_files(folder.path());
    assert!(all.len() >= 3, "{all:?}");
    let names = || {
        let mut names: Vec<_> = fs::read_dir(folder.path())
            .expect("listed")
            .map(|entry| entry.expect("listed").file_name())
            .collect();
        names.sort();
        names
    };
    let before = names();
    for (path, kind) in all {
        // A pipe that is read before anybody writes waits for ever: on a thread of its own.
        let (done, wait) = channel();
        let at = path.clone();
        std::thread::spawn(move || {
            let restart = shell::restore(Some(&at));
            let words: Vec<String> = restart
                .app
                .messages()
                .iter()
                .map(|message| message.text.clone())
                .collect();
            let loaded = workspace::load(&at).expect_err("no file");
            let saved = workspace::save(&at, "{}").expect_err("no file");
            done.send((restart.place.is_none(), words, loaded, saved))
        });
        let told = wait.recv_timeout(Duration::from_secs(60));
        let (is_kept_nowhere, words, loaded, saved) = told.expect("nobody waits for a pipe");
        assert!(is_kept_nowhere, "{path:?}");
        assert_eq!(words.len(), 1, "{words:?}");
        for words in [&words[0], &loaded, &saved] {
            assert!(words.contains("nothing is kept"), "{words}");
            assert!(!words.contains("damaged"), "{words}");
        }
        let now = fs::symlink_metadata(&path).expect("it is where it was");
        assert_eq!(now.file_type(), kind, "{path:?}");
    }
    assert_eq!(names(), before, "nothing came, nothing went");
}
