//! Pictures in few numbers on the command line: kept, shown under another light, refused; and
//! tables of spectra fitted.

use std::{fs, path::Path};

use serde_json::Value;
use spectral_explorer::pictures::{Pixels, Scene};

use crate::tell::{json, refusal, tell};

/// A wall of paints of 31 bands as an ENVI cube; the path of its header.
pub(crate) fn wall(folder: &Path) -> String {
    let nm: Vec<f64> = (0..31).map(|j| 400.0 + 10.0 * f64::from(j)).collect();
    let scene = Scene::reflectance(48, 32, nm.clone()).expect("a scene");
    let mut values = vec![0.0_f32; 48 * 32 * 31];
    scene.rows(0, 32, &mut values).expect("rows");
    let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
    fs::write(folder.join("wall.img"), bytes).expect("data");
    let list: Vec<String> = nm.iter().map(f64::to_string).collect();
    let header = format!(
        "ENVI\nsamples = 48\nlines = 32\nbands = 31\nheader offset = 0\ndata type = 4\n\
         interleave = bsq\nbyte order = 0\nwavelength units = Nanometers\n\
         reflectance scale factor = 1\nwavelength = {{{}}}\n",
        list.join(", ")
    );
    let path = folder.join("wall.hdr");
    fs::write(&path, header).expect("a header");
    word(&path).to_owned()
}

fn word(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

#[test]
fn more_numbers_are_off_by_less_and_take_more_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    let kept = |numbers: &str| json(&["picture", &wall, "--numbers", numbers, "--json"]);
    let (few, many) = (kept("5"), kept("15"));
    assert_eq!([&few["numbers"], &many["numbers"]], [5, 15]);
    let rms = |json: &Value| json["error"]["relative_rms"].as_f64().expect("a figure");
    assert!(rms(&many) < rms(&few));
    let full = |json: &Value| json["bytes"]["full"].as_u64().expect("bytes");
    assert!(full(&many) > full(&few));
}

#[test]
fn both_forms_are_written_and_seen_under_another_light() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    for name in ["wall.exr", "wall.cspx.png"] {
        let file = folder.path().join(name);
        let (code, out, err) = tell(&["picture", &wall, "--numbers", "9", "--out", word(&file)]);
        assert_eq!(code, 0, "{err}");
        assert!(out.contains("Wrote "), "{out}");
        let relit = folder.path().join(format!("{name}.relit.png"));
        let args = [
            "picture",
            word(&file),
            "--relight",
            "CIE A",
            "--out",
            word(&relit),
        ];
        let (code, out, err) = tell(&args);
        assert_eq!(code, 0, "{err}");
        assert!(out.contains("48 x 32 px, under CIE A"), "{out}");
        assert!(!err.is_empty(), "how far to trust it");
        assert!(fs::read(&relit).expect("a picture").starts_with(b"\x89PNG"));
        assert!(refusal(&args).0.contains("--force"));
    }
}

#[test]
fn a_bound_is_kept_or_it_is_said_that_it_is_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    let (code, _, err) = tell(&["picture", &wall, "--bound", "2", "--json"]);
    assert_eq!((code, err.as_str()), (0, ""));
}

#[test]
fn reference_and_lines_are_taken_as_told_with_a_bound_or_a_count() {
    for (args, kind, lines) in [
        (&["--numbers", "12"][..], "light", 0),
        (
            &["--numbers", "12", "--reference", "mean", "--lines", "none"],
            "mean",
            0,
        ),
        (
            &["--bound", "3", "--reference", "mean", "--lines", "auto"],
            "mean",
            1,
        ),
        (
            &["--numbers", "9", "--reference", "one", "--lines", "436,546"],
            "one",
            2,
        ),
    ] {
        let told = json(&[&["picture", "wall", "--light", "FL11", "--json"], args].concat());
        assert_eq!(told["reference"]["kind"], kind, "{args:?}");
        let found = told["lines"].as_array().expect("lines").len();
        // How many are found is the detector's matter.
        assert_eq!(
            found.min(lines + usize::from(lines != 1)),
            lines,
            "{args:?}"
        );
        if args.contains(&"12") {
            assert_eq!(told["numbers"], 12, "{args:?}");
        }
    }
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    let (_, _, err) = tell(&[
        "picture",
        &wall,
        "--numbers",
        "9",
        "--lines",
        "500,501",
        "--json",
    ]);
    assert!(err.contains("lines at 500 and 501 nm are one"), "{err}");
}

#[test]
fn the_wall_of_paints_is_at_hand_under_any_light_of_the_library() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("wall.cspx.png");
    let (code, out, err) = tell(&[
        "picture",
        "wall",
        "--light",
        "lamps_nist_traditional/Mercury",
        "--numbers",
        "11",
        "--out",
        word(&file),
    ]);
    assert_eq!(code, 0, "{err}");
    assert!(
        out.contains("11 numbers a pixel, reference Mercury"),
        "{out}"
    );
    let relit = folder.path().join("day.png");
    let (code, out, err) = tell(&[
        "picture",
        word(&file),
        "--relight",
        "CIE D65",
        "--out",
        word(&relit),
    ]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("256 x 192 px, under CIE D65"), "{out}");
}

#[test]
fn a_photograph_becomes_a_spectral_picture_in_few_numbers() {
    let folder = tempfile::tempdir().expect("a folder");
    let photo = folder.path().join("photo.png");
    let mut file = Vec::new();
    let mut writer = png::Encoder::new(&mut file, 8, 6);
    writer.set_color(png::ColorType::Rgb);
    let mut writer = writer.write_header().expect("a header");
    let pixels: Vec<u8> = (0..8 * 6 * 3).map(|i| (37 * i % 251) as u8).collect();
    writer.write_image_data(&pixels).expect("pixels");
    writer.finish().expect("an end");
    fs::write(&photo, file).expect("a photograph");
    let spectral = folder.path().join("photo.exr");
    let (code, _, err) = tell(&["recover", "--image", word(&photo), "--out", word(&spectral)]);
    assert_eq!(code, 0, "{err}");
    let told = json(&["picture", word(&spectral), "--bound", "1", "--json"]);
    let own = told["error"]["own"]["p95"].as_f64().expect("a figure");
    let under_a = told["error"]["lights"]["A"]["p95"]
        .as_f64()
        .expect("a figure");
    assert!(own < 0.5 && under_a < 1.5, "{told}");
}

#[test]
fn data_beyond_what_is_read_whole_stay_on_disk() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    let (side, bands) = (2100_u64, 31);
    let header = fs::read_to_string(&wall).expect("the header");
    let header = header
        .replace("samples = 48", &format!("samples = {side}"))
        .replace("lines = 32", &format!("lines = {side}"));
    fs::write(&wall, header).expect("a header");
    // A hole of 547 MB in the disk: nothing but zeros, and that is what is said of it.
    let data = fs::File::create(folder.path().join("wall.img")).expect("data");
    data.set_len(side * side * bands * 4).expect("a hole");
    let (err, code) = refusal(&["picture", &wall, "--numbers", "8"]);
    assert_eq!(code, 1);
    assert!(err.contains("found none"), "{err}");
}

#[test]
fn what_is_saved_has_the_rights_of_any_new_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let plain = folder.path().join("plain");
    fs::write(&plain, "").expect("a file");
    let wall = wall(folder.path());
    let out = folder.path().join("wall.cspx.png");
    let (code, _, err) = tell(&["picture", &wall, "--numbers", "5", "--out", word(&out)]);
    assert_eq!(code, 0, "{err}");
    let rights = |path: &Path| fs::metadata(path).expect("there").permissions();
    assert_eq!(rights(&out), rights(&plain));
    let nowhere = folder.path().join("none").join("wall.exr");
    let (err, code) = refusal(&["picture", &wall, "--numbers", "5", "--out", word(&nowhere)]);
    assert_eq!(code, 1);
    assert!(err.contains("found no folder"), "{err}");
}

#[test]
fn what_cannot_be_kept_is_refused_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    for (more, part) in [
        (&["--numbers", "2"][..], "--numbers: expected 3 to 30"),
        (&["--numbers", "31"], "--numbers: expected 3 to 30"),
        (
            &["--numbers", "9", "--lines", "900"],
            "--lines: expected a line between",
        ),
        (&["--numbers", "9", "--bound", "1"], "expected one of them"),
        (
            &["--numbers", "5", "--lines", "450,550,650"],
            "--lines: expected at most 2 lines of 5 numbers",
        ),
        (
            &["--reference", "light"],
            "--reference: expected a picture of light",
        ),
        (&["--out", "a.jpg"], ".png or .exr"),
    ] {
        let (err, code) = refusal(&[&["picture", &wall], more].concat());
        assert_eq!(code, 2, "{more:?}: {err}");
        assert!(err.contains(part), "{more:?}: {err}");
    }
    let (err, code) = refusal(&["picture", "nothing.exr"]);
    assert_eq!(code, 1, "{err}");
    let out = folder.path().join("a.png");
    let (err, code) = refusal(&["picture", &wall, "--relight", "CIE A", "--out", word(&out)]);
    assert_eq!(code, 1, "{err}");
}

/// A cube of 8 x 6 floats with some header fields more.
fn cube(folder: &Path, nm: &[f64], more: &str, value: fn(usize) -> f32) -> String {
    let bytes = (0..48 * nm.len()).flat_map(|i| value(i).to_le_bytes());
    fs::write(folder.join("cube.img"), bytes.collect::<Vec<u8>>()).expect("data");
    let list: Vec<String> = nm.iter().map(f64::to_string).collect();
    let header = format!(
        "ENVI\nsamples = 8\nlines = 6\nbands = {}\nheader offset = 0\ndata type = 4\n\
         interleave = bsq\nbyte order = 0\nwavelength units = Nanometers\n{more}\n\
         wavelength = {{{}}}\n",
        nm.len(),
        list.join(", ")
    );
    let path = folder.join("cube.hdr");
    fs::write(&path, header).expect("a header");
    word(&path).to_owned()
}

#[test]
fn pictures_of_nothing_are_refused_by_what_they_are() {
    let folder = tempfile::tempdir().expect("a folder");
    let seen: Vec<f64> = (0..12).map(|i| 400.0 + 25.0 * f64::from(i)).collect();
    let unseen: Vec<f64> = seen.iter().map(|nm| nm + 700.0).collect();
    let some = |i: usize| 0.2 + 0.01 * (i % 7) as f32;
    let (factor, light) = (
        "reflectance scale factor = 1",
        "data units = W m-2 sr-1 nm-1",
    );
    type Case<'a> = (&'a [f64], &'a str, fn(usize) -> f32, &'a [&'a str], &'a str);
    let cases: [Case<'_>; 6] = [
        (
            &seen[..2],
            factor,
            some,
            &[],
            "expected 3 bands or more, found 2",
        ),
        (
            &seen,
            factor,
            |_| f32::NAN,
            &[],
            "expected a measured pixel",
        ),
        (&seen, factor, |_| 0.0, &[], "found none"),
        (
            &unseen,
            light,
            some,
            &["--light", "FL11"],
            "a known light that overlaps the bands",
        ),
        (
            &seen,
            light,
            some,
            &["--reference", "light"],
            "--reference: ",
        ),
        (
            &seen,
            factor,
            some,
            &["--numbers", "12"],
            "expected 3 to 11 numbers",
        ),
    ];
    for (nm, more, value, args, part) in cases {
        let cube = cube(folder.path(), nm, more, value);
        let (err, _) = refusal(&[&["picture", &cube][..], args].concat());
        assert!(err.contains(part), "{part}: {err}");
    }
    // Nobody knows what lit it: it is kept, and not relit until the light is told.
    let cube = cube(folder.path(), &seen, light, some);
    let (kept, relit) = (folder.path().join("a.exr"), folder.path().join("a.png"));
    let (code, _, err) = tell(&["picture", &cube, "--numbers", "6", "--out", word(&kept)]);
    assert_eq!(code, 0, "{err}");
    let args = [
        "picture",
        word(&kept),
        "--relight",
        "CIE A",
        "--out",
        word(&relit),
    ];
    let (err, code) = refusal(&args);
    assert!(code == 1 && err.contains("choose the light"), "{err}");
    let (code, _, err) = tell(&[&args[..], &["--light", "FL11"]].concat());
    assert_eq!(code, 0, "{err}");
}

#[test]
fn a_table_becomes_a_row_of_numbers_for_each_spectrum() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = folder.path().join("lamps.csv");
    let rows: String = (380..=780)
        .map(|nm| {
            let x = f64::from(nm) / 100.0;
            format!("{nm},{},{}\n", 1.0 + x.sin(), 2.0 + x.cos())
        })
        .collect();
    fs::write(&table, format!("nm,one,two\n{rows}")).expect("a table");
    for name in ["numbers.csv", "numbers.json"] {
        let out = folder.path().join(name);
        let args = ["fit", word(&table), "--numbers", "9", "--out", word(&out)];
        let (code, told, err) = tell(&args);
        assert_eq!(code, 0, "{err}");
        assert!(told.contains("2 spectra in 9 numbers each"), "{told}");
        let text = fs::read_to_string(&out).expect("numbers");
        assert!(text.contains("one") && text.contains("two"), "{text}");
        assert!(refusal(&args).0.contains("--force"));
    }
    let out = folder.path().join("again.json");
    let told = json(&[
        "fit",
        word(&table),
        "--reference",
        "mean",
        "--out",
        word(&out),
        "--json",
    ]);
    assert_eq!(
        (&told["spectra"], &told["numbers"]),
        (&2.into(), &20.into())
    );
    let (err, code) = refusal(&["fit", word(&table)]);
    assert_eq!(code, 2);
    assert!(err.contains("found no --out"), "{err}");
    // A table has no pixels, and no picture either.
    let out = folder.path().join("none.csv");
    let (err, code) = refusal(&["fit", word(&table), "--numbers", "2", "--out", word(&out)]);
    assert_eq!(code, 2);
    let words = "--numbers: expected 3 to 400 numbers, fewer than there are wavelengths, found 2\n";
    assert!(err.ends_with(words), "{err}");
    fs::write(&table, "nm,one\n400,0\n410,0\n420,0\n430,0\n440,0\n").expect("a table");
    let args = ["fit", word(&table), "--numbers", "3", "--out", word(&out)];
    let (err, code) = refusal(&args);
    assert_eq!(code, 1);
    assert!(
        err.ends_with(
            "expected values above zero that a file of 32-bit numbers holds, found none\n"
        ),
        "{err}"
    );
}

#[test]
fn of_a_folder_every_spectrum_of_its_files_is_a_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamps = folder.path().join("lamps");
    fs::create_dir(&lamps).expect("a folder");
    for (name, head) in [("a.csv", "nm,one,two"), ("b.csv", "nm,three,four")] {
        let rows: String = (380..=780)
            .map(|nm| {
                let x = f64::from(nm) / 100.0;
                format!("{nm},{},{}\n", 1.0 + x.sin(), 2.0 + x.cos())
            })
            .collect();
        fs::write(lamps.join(name), format!("{head}\n{rows}")).expect("a table");
    }
    let wider: String = (370..=790).map(|nm| format!("{nm},{}\n", nm % 7)).collect();
    fs::write(lamps.join("c.csv"), format!("nm,five\n{wider}")).expect("a table");
    fs::write(lamps.join("notes.md"), "no spectrum at all").expect("a file");
    let out = folder.path().join("numbers.csv");
    let args = ["fit", word(&lamps), "--numbers", "9", "--out", word(&out)];
    let (code, told, err) = tell(&[&args[..], &["--reference", "mean"]].concat());
    assert_eq!(code, 0, "{err}");
    assert!(told.contains("5 spectra in 9 numbers each"), "{told}");
    let cut = "1 spectrum is cut to 380 to 780 nm, the range of one";
    assert!(err.contains(cut), "{err}");
    assert!(err.contains("skipped") && err.contains("notes.md"), "{err}");
    let text = fs::read_to_string(&out).expect("numbers");
    // The only column of a file is called after the file.
    for name in ["one", "two", "three", "four", "c"] {
        let is_its = |line: &str| line.split(',').next() == Some(name);
        assert!(text.lines().any(is_its), "{name}: {text}");
    }
    fs::write(lamps.join("leaf.csv"), format!("nm,reflectance\n{wider}")).expect("a table");
    let (code, _, err) = tell(&[&args[..], &["--force"]].concat());
    assert_eq!(code, 1, "{err}");
    assert!(
        err.contains("leaf.csv: ") && err.contains("one kind"),
        "{err}"
    );
    // What multiplies the series is there too: without it nobody could read the numbers.
    let listed = |what: &str| text.lines().find_map(|line| line.strip_prefix(what));
    let [bands, mean] = ["# bands_nm ", "# reference "].map(|what| listed(what).expect("a list"));
    assert_eq!(
        (bands.split(' ').count(), mean.split(' ').count()),
        (401, 401)
    );
}

/// Lines of JSON, one a lamp.
fn lamps() -> String {
    (0..40)
        .map(|i| {
            let nm: Vec<u32> = (380..=780).step_by(5).collect();
            let values: Vec<f64> = nm
                .iter()
                .map(|nm| 2.0 + (f64::from(*nm) / (60.0 + f64::from(i))).sin())
                .collect();
            let line = serde_json::json!({"name": format!("lamp {i}"), "nm": nm, "values": values});
            format!("{line}\n")
        })
        .collect()
}

/// What a program makes of its standard input.
fn piped(program: &str, args: &[&str], input: &str) -> Option<String> {
    use std::process::{Command, Stdio};
    let mut child = Command::new(program)
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    let mut stdin = child.stdin.take().expect("a pipe");
    let input = input.to_owned();
    let writer = std::thread::spawn(move || {
        use std::io::Write;
        stdin.write_all(input.as_bytes())
    });
    let output = child.wait_with_output().expect("an end");
    writer.join().expect("no panic").expect("all was read");
    assert!(output.status.success(), "{program} {args:?}");
    Some(String::from_utf8(output.stdout).expect("UTF-8"))
}

#[test]
fn lines_of_json_are_answered_line_by_line_wherever_they_are_cut() {
    let program = env!("CARGO_BIN_EXE_spectral-explorer");
    let fit = ["fit", "-", "--numbers", "12"];
    let all = piped(program, &fit, &lamps()).expect("it runs");
    assert_eq!(all.lines().count(), 40);
    let first: Value = serde_json::from_str(all.lines().next().expect("a line")).expect("JSON");
    assert_eq!(
        (&first["name"], &first["numbers"]),
        (&"lamp 0".into(), &12.into())
    );
    let odd = piped(program, &fit, "{}\nno JSON\n\n").expect("it runs");
    assert_eq!(
        odd.lines()
            .filter(|line| line.contains("\"error\""))
            .count(),
        2
    );
    // A blank line is answered by one, so that lines in and out pair.
    assert_eq!(odd.lines().nth(2), Some(""));
    // GNU parallel cuts its input into blocks and starts a process for each, in order.
    let command = format!("{program} fit - --numbers 12");
    let spread = [
        "--pipe",
        "--keep-order",
        "--block",
        "4k",
        "--will-cite",
        &command,
    ];
    match piped("parallel", &spread, &lamps()) {
        Some(spread) => assert_eq!(spread, all),
        None => println!("GNU parallel is not installed: not run"),
    }
}

#[test]
fn our_own_pictures_are_read_and_kept_again_and_tell_no_path() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    for name in ["own.exr", "own.cspx.png"] {
        let file = folder.path().join(name);
        let (code, _, err) = tell(&["picture", &wall, "--numbers", "9", "--out", word(&file)]);
        assert_eq!(code, 0, "{err}");
        let told = json(&["read", word(&file), "--json"]);
        let image = &told[0]["images"][0];
        assert_eq!(
            [&image["width"], &image["height"], &image["bands"]],
            [48, 32, 31]
        );
        assert_eq!(image["kind"], "reflectance");
        let (code, out, _) = tell(&["read", word(&file)]);
        assert_eq!(code, 0);
        assert!(
            out.contains("9 numbers a pixel stand for 31 bands"),
            "{out}"
        );
        let again = json(&["picture", word(&file), "--numbers", "9", "--json"]);
        assert_eq!(again["numbers"], 9);
        // The header is JSON within the one and packed within the other: the image tells it too.
        assert_eq!(told[0]["spectra"][0]["source"], "wall.hdr");
        let bytes = fs::read(&file).expect("a picture");
        let path = folder.path().to_string_lossy().into_owned();
        assert!(
            !bytes
                .windows(path.len())
                .any(|some| some == path.as_bytes())
        );
    }
    let cut = folder.path().join("cut.exr");
    let whole = fs::read(folder.path().join("own.exr")).expect("a picture");
    fs::write(&cut, &whole[..whole.len() / 2]).expect("half of it");
    assert!(refusal(&["read", word(&cut)]).0.contains("expected"));
}

#[test]
fn what_is_only_guessed_of_a_pictures_values_is_said_and_relighting_is_with_care() {
    let folder = tempfile::tempdir().expect("a folder");
    let nm: Vec<f64> = (0..31).map(|j| 400.0 + 10.0 * f64::from(j)).collect();
    // Raw counts: nothing states that they are reflectances.
    let counts = cube(folder.path(), &nm, "", |at| {
        1000.0 + (at * 37 % 4001) as f32
    });
    let args = ["picture", &counts, "--numbers", "8", "--reference", "mean"];
    let (code, out, err) = tell(&args);
    assert_eq!(code, 0, "{err}");
    let read = tell(&["read", &counts]).1;
    if read.contains("taken as reflectance") {
        assert!(err.contains("taken as reflectance"), "{err}");
        assert!(
            out.contains("relit to A: with care: nothing states"),
            "{out}"
        );
        let trust = &json(&[&args[..], &["--json"]].concat())["trust"];
        assert_eq!(trust["verdict"], "care");
    }
    // A person's word is no guess.
    let (code, out, err) = tell(&[&args[..], &["--kind", "reflectance"]].concat());
    assert_eq!(code, 0, "{err}");
    assert!(!err.contains("taken as reflectance"), "{err}");
    assert!(!out.contains("nothing states"), "{out}");
    let light = json(&[&args[..], &["--kind", "light", "--json"]].concat());
    assert!(light["trust"].is_null());
}

#[test]
fn data_longer_than_their_header_and_a_factor_of_0_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let header = wall(folder.path());
    let text = fs::read_to_string(&header).expect("a header");
    let odd = text.replace(
        "reflectance scale factor = 1",
        "reflectance scale factor = 0",
    );
    fs::write(&header, odd).expect("a header");
    let data = folder.path().join("wall.img");
    let mut bytes = fs::read(&data).expect("data");
    bytes.extend([0; 100]);
    fs::write(&data, bytes).expect("data");
    let (code, _, err) = tell(&["picture", &header, "--numbers", "8"]);
    assert_eq!(code, 0, "{err}");
    assert!(
        err.contains("the data are 100 bytes longer than the header says"),
        "{err}"
    );
    assert!(
        err.contains("reflectance scale factor of 0 is not used"),
        "{err}"
    );
    let (_, read, _) = tell(&["read", &header]);
    assert!(
        read.contains("reflectance scale factor of 0 is not used"),
        "{read}"
    );
}

#[test]
fn a_bound_that_is_not_reached_names_both_figures_and_rounding_keeps_own_colour() {
    // White noise in 61 bands: 40 numbers do not keep it.
    let folder = tempfile::tempdir().expect("a folder");
    let nm: Vec<f64> = (0..61).map(|j| 400.0 + 5.0 * f64::from(j)).collect();
    let noise = cube(folder.path(), &nm, "", |at| {
        0.05 + 0.9 * ((at * 7919 + at * at % 613) % 1009) as f32 / 1009.0
    });
    let args = ["picture", &noise, "--kind", "reflectance", "--bound", "0.5"];
    let (code, out, err) = tell(&args);
    assert_eq!(code, 0, "{err}");
    assert!(
        err.contains("the bound is not reached: the nearest, "),
        "{err}"
    );
    assert!(
        err.contains("(95 %) where 0.5 is asked for and a relative rms of "),
        "{err}"
    );
    // Rounding takes nothing from the own colour, which 40 numbers keep.
    let own = json(&[&args[..], &["--json"]].concat());
    let p95 = own["error"]["own"]["p95"].as_f64().expect("a figure");
    assert!(p95 <= 0.5, "{p95} {out} {err}");
}
