//! Many files at once: folders, progress, cancel, the summary, one step of undo.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::{Arc, Mutex},
    time::{Duration, Instant},
};

use crate::driver::{
    LONGEST_WAIT, Ui, app, assert_written, at_rest, click, is_written, no_files, wait_until, words,
};
use crate::own_time::own_seconds;
use crate::plain::plain;
use eframe::egui;
use egui::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use spectral_explorer::{
    app::{
        Command, Tone,
        open::{Came, Loader, Outcome, batch::read_all},
        workspace::Preferences,
    },
    spectrum::{Kind, NamedSpectrum, Sampled},
    ui::{
        Window,
        files::{Ask, Picked, Picker},
    },
};

fn over(picker: Picker) -> Ui {
    at_rest(Window::new(plain(), Preferences::default(), picker, None))
}

fn fresh() -> Ui {
    over(no_files())
}

fn open(ui: &mut Ui, paths: Vec<PathBuf>) {
    ui.state_mut().open_files(paths, Arc::new(|| {}));
    wait_until(ui, "the files", |ui| !ui.state().is_busy());
}

const LAMP: &str = "wavelength (nm),irradiance\n400,1\n450,2\n500,4\n550,2\n600,1\n700,1\n";

/// Good files, bad ones and one that leaves its meaning open, in a folder with a subfolder.
fn mixed(folder: &Path) -> PathBuf {
    let top = folder.join("lamps");
    fs::create_dir_all(top.join("more")).unwrap();
    for (name, text) in [
        ("a.csv", LAMP),
        (
            "b.spd",
            "# kind: light\n# unit: W m-2 nm-1\n400 1\n500 2\n600 3\n",
        ),
        ("bare.csv", "400,0.5\n500,0.25\n600,0.125\n"),
        ("notes.txt", "Bulbs bought in May.\nAll are warm.\n"),
        ("more/c.csv", LAMP),
        (".hidden.csv", LAMP),
    ] {
        fs::write(top.join(name), text).unwrap();
    }
    top
}

#[test]
fn a_folder_is_opened_in_one_step_with_a_summary_and_undone_in_one() {
    let folder = tempfile::tempdir().unwrap();
    let top = mixed(folder.path());
    let mut ui = fresh();
    let before = app(&ui).document().clone();
    open(&mut ui, vec![top.clone()]);
    let names: Vec<&str> = app(&ui).document().own.iter().map(|e| e.name()).collect();
    assert_eq!(names.len(), 4, "{names:?}");
    assert_eq!(app(&ui).document().light.key, "own/1");
    let message = app(&ui).message().unwrap();
    assert!(app(&ui).current_message().is_some());
    assert_eq!(message.tone, Tone::Problem);
    assert!(
        message
            .text
            .starts_with("4 of 5 files read, 4 spectra: 3 plain columns, 1 pbrt .spd"),
        "{message:?}"
    );
    assert!(
        message
            .text
            .ends_with("; 1 with a doubtful guess; 1 refused."),
        "{message:?}"
    );
    // The list of files stands over the window.
    assert_written(&ui, "lamps/more/c.csv: plain columns");
    // Its name stands in the row and not again in the reason.
    assert_written(&ui, "lamps/notes.txt: –, refused: ");
    assert!(!is_written(&ui, "refused: notes.txt"));
    assert_written(&ui, "doubtful: taken for light");
    // The folder is among what was opened last, not its files.
    assert_eq!(ui.state().preferences.recent, [top]);
    // Only what was refused.
    click(&mut ui, "Refused or not read (1)");
    assert!(!is_written(&ui, "lamps/more/c.csv: plain"));
    click(&mut ui, "Close");
    assert!(!is_written(&ui, "lamps/notes.txt: –"));
    // And again from the status line.
    click(&mut ui, "Each file…");
    assert_written(&ui, "lamps/notes.txt: –");
    click(&mut ui, "Close");
    click(&mut ui, "Undo");
    assert_eq!(app(&ui).document(), &before);
    assert!(app(&ui).undo_words().is_none());
    // What was told of the files is no news of what is shown now: that is what was undone.
    let said = app(&ui).current_message().expect("a word");
    assert!(said.text.starts_with("Undone: opened 4 files"), "{said:?}");
    click(&mut ui, "Redo");
    assert_eq!(app(&ui).document().own.len(), 4);
    // It is still to be had from the menu when the message is gone.
    click(&mut ui, "Open");
    click(&mut ui, "Files opened together…");
    assert_written(&ui, "lamps/notes.txt: –");
}

/// A row of the summary by the beginning of its name.
#[track_caller]
fn click_row(ui: &mut Ui, begins: &str) {
    let row = ui.query_all_by_role(Role::Button).find(|node| {
        let label = node.accesskit_node().label();
        label.is_some_and(|label| label.starts_with(begins))
    });
    row.unwrap_or_else(|| panic!("no row begins with {begins:?}"))
        .click();
    ui.run();
}

#[test]
fn a_row_of_the_summary_shows_its_spectrum_and_a_doubtful_one_how_it_was_read() {
    let folder = tempfile::tempdir().unwrap();
    let mut ui = fresh();
    open(&mut ui, vec![mixed(folder.path())]);
    click_row(&mut ui, "lamps/b.spd: ");
    assert_eq!(app(&ui).document().light.name(), "b");
    // A refused one shows nothing and tells why once more.
    click_row(&mut ui, "lamps/notes.txt: ");
    assert_eq!(app(&ui).document().light.name(), "b");
    assert!(app(&ui).message().unwrap().text.contains("refused"));
    // Escape closes it, and opening it again is one click.
    ui.key_press(egui::Key::Escape);
    ui.run();
    assert!(!is_written(&ui, "lamps/b.spd: "));
    click(&mut ui, "Open");
    click(&mut ui, "Files opened together…");
    click(&mut ui, "Look…");
    wait_until(&mut ui, "the look at the file", |ui| {
        is_written(ui, "Remove it again")
    });
    assert_written(&ui, "How bare.csv was read");
    // After an undo the file is gone, and that is said.
    ui.state_mut().app.apply(Command::Undo);
    ui.state_mut().app.apply(Command::Undo);
    ui.state_mut().app.apply(Command::Undo);
    ui.run();
    click_row(&mut ui, "lamps/a.csv: ");
    let message = app(&ui).message().unwrap();
    assert!(
        message.text.contains("are not open any more"),
        "{message:?}"
    );
}

#[test]
fn a_file_that_is_open_is_shown_again_and_not_opened_twice() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a.csv"), folder.path().join("b.csv"));
    fs::write(&a, LAMP).unwrap();
    fs::write(&b, LAMP.replace("500,4", "500,3")).unwrap();
    let mut ui = fresh();
    open(&mut ui, vec![a.clone()]);
    open(&mut ui, vec![b.clone()]);
    assert_eq!(app(&ui).document().light.key, "own/2");
    open(&mut ui, vec![a.clone()]);
    assert_eq!(app(&ui).document().own.len(), 2);
    assert_eq!(app(&ui).document().light.key, "own/1");
    let message = app(&ui).message().unwrap();
    assert_eq!(message.text, "a.csv is open already, with the same values.");
    // Shown already: nothing to undo was added, the last step is the showing.
    open(&mut ui, vec![a.clone()]);
    ui.state_mut().app.apply(Command::Undo);
    assert_eq!(app(&ui).document().light.key, "own/2");
    // In a batch it is told and left out.
    let c = folder.path().join("c.csv");
    fs::write(&c, LAMP).unwrap();
    open(&mut ui, vec![a.clone(), c, b.clone()]);
    assert_eq!(app(&ui).document().own.len(), 3);
    let message = app(&ui).message().unwrap();
    assert!(message.text.contains("; 2 open already"), "{message:?}");
    click_row(&mut ui, "b.csv: plain columns, open already; ");
    assert_eq!(app(&ui).document().light.key, "own/2");
    click(&mut ui, "Close");
    // With other values it stands beside the first one.
    fs::write(&a, LAMP.replace("500,4", "500,5")).unwrap();
    open(&mut ui, vec![a]);
    assert_eq!(app(&ui).document().own.len(), 4);
    let message = app(&ui).message().unwrap();
    assert!(
        message.text.contains("with other values is open"),
        "{message:?}"
    );
}

#[test]
fn undo_reaches_back_over_several_loads_and_what_was_done_between() {
    let folder = tempfile::tempdir().unwrap();
    let top = mixed(folder.path());
    let mut ui = fresh();
    let mut states = vec![app(&ui).document().clone()];
    open(&mut ui, vec![top.clone()]);
    states.push(app(&ui).document().clone());
    let lamp = app(&ui).entry("cie_illuminants/CIE A").unwrap();
    ui.state_mut().app.apply(Command::Show(lamp));
    ui.state_mut().app.end_gesture();
    states.push(app(&ui).document().clone());
    // The same values under other names are other files.
    for name in ["d.csv", "e.csv", "f.csv"] {
        fs::write(folder.path().join(name), LAMP).unwrap();
    }
    let at = |name: &str| folder.path().join(name);
    open(&mut ui, vec![at("d.csv"), at("e.csv")]);
    states.push(app(&ui).document().clone());
    open(&mut ui, vec![at("f.csv")]);
    for state in states.iter().rev() {
        ui.state_mut().app.apply(Command::Undo);
        assert!(app(&ui).document() == state);
    }
    assert!(app(&ui).undo_words().is_none());
    for _ in 0..4 {
        ui.state_mut().app.apply(Command::Redo);
    }
    assert_eq!(app(&ui).document().own.len(), 7);
}

#[test]
fn one_file_alone_is_told_as_one_and_a_folder_of_one_too() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.csv"), LAMP).unwrap();
    for path in [folder.path().join("a.csv"), folder.path().to_owned()] {
        let mut ui = fresh();
        open(&mut ui, vec![path]);
        let message = app(&ui).message().unwrap();
        assert!(
            message.text.starts_with("a.csv: plain columns"),
            "{message:?}"
        );
        assert!(!is_written(&ui, "Files opened together"));
    }
}

#[test]
fn an_empty_folder_and_one_with_only_bad_files_leave_everything() {
    let folder = tempfile::tempdir().unwrap();
    let empty = folder.path().join("empty");
    let bad = folder.path().join("bad");
    fs::create_dir_all(&empty).unwrap();
    fs::create_dir_all(&bad).unwrap();
    for name in ["one.txt", "two.txt"] {
        fs::write(bad.join(name), "no numbers here").unwrap();
    }
    let mut ui = fresh();
    let before = app(&ui).document().clone();
    open(&mut ui, vec![empty]);
    let message = app(&ui).message().unwrap();
    assert!(
        message.text.contains("expected a folder with files"),
        "{message:?}"
    );
    open(&mut ui, vec![bad]);
    let message = app(&ui).message().unwrap();
    assert_eq!(message.text, "0 of 2 files read; 2 refused.");
    assert_eq!(app(&ui).document(), &before);
    assert!(app(&ui).undo_words().is_none());
}

#[test]
fn the_folder_dialog_gives_a_folder() {
    let folder = tempfile::tempdir().unwrap();
    let top = mixed(folder.path());
    let asked = Arc::new(Mutex::new(Vec::new()));
    let record = asked.clone();
    let mut ui = over(Arc::new(move |ask: &Ask| {
        record.lock().unwrap().push(ask.clone());
        Picked::Paths(vec![top.clone()])
    }));
    click(&mut ui, "Open");
    click(&mut ui, "Open a folder…");
    wait_until(&mut ui, "the folder", |ui| {
        app(ui).document().own.len() == 4
    });
    assert_eq!(*asked.lock().unwrap(), [Ask::OpenFolder]);
}

#[test]
fn cancelling_keeps_what_was_read_and_tells_what_was_not() {
    let folder = tempfile::tempdir().unwrap();
    let count = 400;
    for i in 0..count {
        let rows: String = (0..2000)
            .map(|row| format!("{},{}\n", 300.0 + 0.25 * f64::from(row), row * i % 97))
            .collect();
        fs::write(folder.path().join(format!("{i:03}.csv")), rows).unwrap();
    }
    let mut ui = fresh();
    let before = app(&ui).document().clone();
    ui.state_mut()
        .open_files(vec![folder.path().to_owned()], Arc::new(|| {}));
    let start = Instant::now();
    let some = |ui: &Ui| {
        words(ui)
            .iter()
            .any(|w| w.ends_with(" of 400 files") && !w.starts_with("0 "))
    };
    while !some(&ui) {
        assert!(
            start.elapsed() < LONGEST_WAIT && ui.state().is_busy(),
            "no progress was seen"
        );
        std::thread::sleep(Duration::from_millis(1));
        ui.step();
    }
    // The window lives: another light is shown meanwhile.
    ui.query_all_by_role_and_label(Role::Button, "Cancel")
        .next()
        .expect("a way to stop")
        .click();
    ui.step();
    ui.step();
    assert!(!ui.state().is_busy(), "a cancel is not waited for");
    ui.run();
    let read = app(&ui).document().own.len();
    assert!((1..count as usize).contains(&read), "{read}");
    let message = app(&ui).message().unwrap();
    assert!(
        message
            .text
            .starts_with(&format!("Cancelled: {read} of 400 files read")),
        "{message:?}"
    );
    assert!(
        message.text.contains(&format!("; {} not read", 400 - read)),
        "{message:?}"
    );
    click(&mut ui, &format!("Refused or not read ({})", 400 - read));
    assert_written(&ui, "not read: cancelled before its turn");
    ui.state_mut().app.apply(Command::Undo);
    assert_eq!(app(&ui).document(), &before);
}

#[test]
fn both_files_of_an_envi_pair_are_read_once() {
    let folder = tempfile::tempdir().unwrap();
    let top = folder.path();
    let header = "ENVI\nsamples = 3\nlines = 2\nbands = 1\nheader offset = 0\n\
        file type = ENVI Spectral Library\ndata type = 4\ninterleave = bsq\nbyte order = 0\n\
        wavelength units = Nanometers\nwavelength = {400, 500, 600}\n\
        spectra names = {grass, sand}\n";
    let numbers: Vec<u8> = [0.1_f32, 0.2, 0.3, 0.4, 0.5, 0.6]
        .iter()
        .flat_map(|v| v.to_le_bytes())
        .collect();
    for stem in ["x", "y"] {
        fs::write(top.join(format!("{stem}.hdr")), header).unwrap();
    }
    fs::write(top.join("x.sli"), &numbers).unwrap();
    fs::write(top.join("y"), &numbers).unwrap();
    // A table of the same stem is no part of the pair.
    fs::write(top.join("x.csv"), LAMP).unwrap();
    for paths in [
        vec![top.to_owned()],
        ["x.sli", "y", "x.csv", "y.hdr", "x.hdr"]
            .map(|n| top.join(n))
            .to_vec(),
    ] {
        let summary = read_all(&paths).summary();
        assert_eq!(summary.rows.len(), 3, "{:?}", summary.rows);
        assert_eq!(summary.spectra(), 5);
        assert!(
            summary
                .rows
                .iter()
                .any(|row| row.file.ends_with("x.hdr + x.sli"))
        );
        assert!(
            summary
                .rows
                .iter()
                .any(|row| row.file.ends_with("y.hdr + y"))
        );
    }
}

#[test]
fn a_file_beyond_the_limit_is_refused_unread() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("large.csv", "400,1\n"),
        ("large.json", "{\"format\": \"spectral-explorer-project\", "),
    ] {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        // Holes take no room on disk.
        let file = fs::OpenOptions::new().write(true).open(&path).unwrap();
        file.set_len(3 << 30).unwrap();
    }
    let summary = read_all(&[folder.path().to_owned()]).summary();
    for row in &summary.rows {
        let Outcome::Refused(why) = &row.outcome else {
            panic!("{row:?}");
        };
        assert!(
            why.contains("expected at most 512 MiB in one file"),
            "{why}"
        );
    }
}

#[test]
fn projects_in_a_folder_do_not_put_everything_else_away() {
    let folder = tempfile::tempdir().unwrap();
    let text = spectral_explorer::app::workspace::to_json(plain().document(), None).unwrap();
    fs::write(folder.path().join("a.json"), text).unwrap();
    fs::write(folder.path().join("b.csv"), LAMP).unwrap();
    let finished = read_all(&[folder.path().to_owned()]);
    assert!(matches!(&finished.files[0].came, Came::NotRead(why) if why.contains("by itself")));
    let (opened, projects) = finished.into_loaded();
    assert_eq!((opened.len(), projects.len()), (1, 0));
}

#[test]
fn the_summary_copies_as_a_table_with_a_row_for_each_file() {
    let folder = tempfile::tempdir().unwrap();
    let summary = read_all(&[mixed(folder.path())]).summary();
    let csv = summary.table().csv();
    let lines: Vec<&str> = csv.lines().collect();
    assert!(lines[0].starts_with("# 4 of 5 files read"), "{csv}");
    assert_eq!(
        lines[2],
        "file,outcome,format,spectra,images,how,doubtful,path"
    );
    assert_eq!(lines.len(), 3 + 5);
    assert!(
        lines[3].starts_with("lamps/a.csv,read,plain columns,1,0,"),
        "{csv}"
    );
    assert!(csv.contains("\nlamps/notes.txt,refused,,0,0,"), "{csv}");
}

#[test]
fn a_second_batch_waits_for_the_first() {
    let folder = tempfile::tempdir().unwrap();
    let top = mixed(folder.path());
    let mut loader = Loader::default();
    loader.open(vec![top.clone()], Arc::new(|| {}));
    loader.open(vec![top.join("a.csv")], Arc::new(|| {}));
    let start = Instant::now();
    let mut counts = Vec::new();
    while loader.is_busy() {
        assert!(start.elapsed() < LONGEST_WAIT);
        counts.extend(loader.finished().map(|finished| finished.files.len()));
    }
    assert_eq!(counts, [5, 1]);
}

#[test]
fn the_library_stays_quick_and_searchable_with_a_thousand_own_spectra() {
    let mut ui = fresh();
    let spectra = (0..1000).map(|i| NamedSpectrum {
        name: format!("leaf {i}"),
        kind: Kind::Reflectance,
        unit: "fraction".to_owned(),
        scale: 1.0,
        samples: Sampled::even(400.0, 2.0, vec![f64::from(i % 10) / 10.0; 180]).unwrap(),
        notes: Vec::new(),
        source: if i == 777 { "oak.sli" } else { "library.sli" }.to_owned(),
    });
    ui.state_mut().app.apply(Command::Adopt(spectra.collect()));
    ui.state_mut().drawer.open = true;
    ui.run();
    let frames = 20;
    let ((), all) = own_seconds(|| (0..frames).for_each(|_| ui.step()));
    let one = all / f64::from(frames);
    // Far above what it takes, for slow machines; looking through all in every frame is more.
    assert!(one < 0.06, "{one} s");
    for (search, found) in [("leaf 123", "leaf 123"), ("oak.sli", "leaf 777")] {
        let field = ui
            .query_by_role_and_label(Role::TextInput, "Search the library")
            .expect("a search field");
        field.click();
        ui.run();
        ui.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
        ui.event(egui::Event::Text(search.to_owned()));
        ui.run();
        assert!(
            ui.query_by_role_and_label(Role::Button, found).is_some(),
            "{search}"
        );
        assert!(
            ui.query_by_role_and_label(Role::Button, "leaf 500")
                .is_none()
        );
    }
}

#[test]
fn a_hundred_tables_are_read_at_once() {
    let folder = tempfile::tempdir().unwrap();
    for i in 0..100 {
        let rows: String = (0..401)
            .map(|row| format!("{},{}\n", 380 + row, f64::from(row * i % 97) / 97.0))
            .collect();
        fs::write(folder.path().join(format!("{i}.csv")), rows).unwrap();
    }
    let summary = read_all(&[folder.path().to_owned()]).summary();
    assert_eq!(summary.spectra(), 100);
}
