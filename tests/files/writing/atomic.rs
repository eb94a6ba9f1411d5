//! Saving a file in one step.

use spectral_explorer::io::save_atomically;
use std::fs;
use std::path::Path;

#[test]
fn a_file_is_replaced_whole_and_nothing_is_left_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.txt");
    save_atomically(&path, b"old").unwrap();
    save_atomically(&path, b"new").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"new");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_missing_folder_and_a_folder_of_that_name_are_refused_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let missing = save_atomically(&folder.path().join("none").join("a.txt"), b"").unwrap_err();
    assert!(
        missing.to_string().starts_with("a.txt: found no folder"),
        "{missing}"
    );
    let taken = save_atomically(folder.path(), b"").unwrap_err().to_string();
    assert!(taken.contains("found a folder of this name"), "{taken}");
}

#[cfg(unix)]
#[test]
fn permissions_of_a_replaced_file_stay_and_new_files_are_ordinary() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
    let path = folder.path().join("a.txt");
    save_atomically(&path, b"1").unwrap();
    assert_eq!(mode(&path) & 0o600, 0o600);
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    save_atomically(&path, b"2").unwrap();
    assert_eq!(mode(&path), 0o640);
}

#[cfg(unix)]
#[test]
fn a_pipe_is_written_into_and_stays_a_pipe() {
    use std::os::unix::fs::FileTypeExt;
    let folder = tempfile::tempdir().unwrap();
    let pipe = folder.path().join("pipe.csv");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.is_ok_and(|status| status.success()));
    let end = pipe.clone();
    let reader = std::thread::spawn(move || fs::read(end).unwrap());
    save_atomically(&pipe, b"380,1").unwrap();
    assert_eq!(reader.join().unwrap(), b"380,1");
    assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_told_in_words() {
    let full = save_atomically(Path::new("/dev/full"), b"380,1").unwrap_err();
    assert!(full.to_string().contains("found the disk full"), "{full}");
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link() {
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("a.txt"), folder.path().join("l.txt"));
    save_atomically(&file, b"1").unwrap();
    std::os::unix::fs::symlink(&file, &link).unwrap();
    save_atomically(&link, b"2").unwrap();
    assert_eq!(fs::read(&file).unwrap(), b"2");
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
}
