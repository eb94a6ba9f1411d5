//! A folder that files come into.

use super::*;

fn put(folder: &Path, name: &str, value: f64, at_s: u64) {
    let rows = (400..=500).map(|nm| format!("{nm},{value}\n"));
    let path = folder.join(name);
    fs::write(&path, rows.collect::<String>()).expect(name);
    let file = fs::File::options().write(true).open(&path).expect(name);
    let time = SystemTime::UNIX_EPOCH + Duration::from_secs(at_s);
    file.set_modified(time).expect(name);
}

fn shown(source: &mut FolderSource) -> Vec<(String, f64)> {
    let events = std::mem::take(&mut source.waiting).into_iter();
    events
        .filter_map(|event| match event {
            Event::Frame(frame) => Some((frame.name, frame.samples.values()[0])),
            _ => None,
        })
        .collect()
}

#[test]
fn the_newest_file_that_can_be_read_is_shown_and_the_others_are_a_step_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path();
    put(path, "b.csv", 1.0, 10);
    put(path, "a.csv", 2.0, 20);
    put(path, "c.csv", f64::NAN, 30);
    let mut source = FolderSource::new(path, &Choices::default());
    source.look(0.0);
    assert_eq!(shown(&mut source), [("a.csv".to_owned(), 2.0)]);
    put(path, "d.csv", 3.0, 35);
    put(path, "b.csv", 4.0, 40);
    // A first reading of a file rests for a second.
    for step in 1..=8 {
        source.look(0.25 * f64::from(step));
    }
    let names = [("d.csv".to_owned(), 3.0), ("b.csv".to_owned(), 4.0)];
    assert_eq!(shown(&mut source), names);
    let list = source.list().iter().map(|one| name_of(&one.path));
    assert_eq!(
        list.collect::<Vec<_>>(),
        ["c.csv", "a.csv", "d.csv", "b.csv"]
    );
}

#[test]
fn two_hundred_spectra_are_kept_and_the_names_of_older_ones() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut source = FolderSource::new(folder.path(), &Choices::default());
    source.look(0.0);
    for index in 0..MOST_KEPT as u64 + 10 {
        put(
            folder.path(),
            &format!("{index:04}.csv"),
            0.5 + index as f64,
            index,
        );
    }
    source.look(1.0);
    source.look(2.0);
    assert_eq!(source.list().len(), MOST_KEPT + 10);
    let kept = source.list().iter().map(|one| one.frame.is_some());
    let kept: Vec<bool> = kept.collect();
    assert!(kept[..10].iter().all(|kept| !kept) && kept[10..].iter().all(|kept| *kept));
}
