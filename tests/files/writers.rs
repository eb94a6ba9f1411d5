//! What is written is read back: every format, to the bit where the format allows.
//!
//! Stated limits: text formats take numbers of 1e30 and more for "not measured"; Argyll `.sp` and
//! its even steps keep wavelengths to 1e-9 nm.

use crate::root::root;
use spectral_explorer::{
    app::{
        App, Command, Scale,
        chart::Theme,
        export::{Export, composite_file},
    },
    io::{
        Columns, Provenance, WRITABLE, composite_json, composite_line, encode, losses,
        parse_composite_line, read_bytes, read_path,
    },
    spectrum::{Kind, NamedSpectrum, Sampled},
};

fn spectrum(name: &str, kind: Kind, nm: Vec<f64>, values: Vec<f64>) -> NamedSpectrum {
    NamedSpectrum {
        name: name.to_owned(),
        kind,
        unit: if kind.is_factor() {
            "fraction"
        } else {
            "W m-2 nm-1"
        }
        .to_owned(),
        scale: 1.0,
        samples: Sampled::new(nm, values).expect("finite values, rising grid"),
        notes: Vec::new(),
        source: "a test, 2024".to_owned(),
    }
}

fn even(first: f64, step: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| first + step * i as f64).collect()
}

fn cases() -> Vec<NamedSpectrum> {
    let wave = |count: usize| -> Vec<f64> {
        (0..count)
            .map(|i| 0.5 + 0.4 * (i as f64 / 7.0).sin())
            .collect()
    };
    let signs = |i: usize| {
        if i.is_multiple_of(3) {
            -1e-3
        } else {
            0.7 / (i + 1) as f64
        }
    };
    vec![
        spectrum("a light", Kind::Light, even(380.0, 5.0, 81), wave(81)),
        spectrum(
            "a paint, 50 %",
            Kind::Reflectance,
            even(400.0, 10.0, 31),
            wave(31),
        ),
        spectrum(
            "a filter [W]",
            Kind::Transmittance,
            even(300.0, 1.0, 601),
            wave(601),
        ),
        spectrum(
            "irregular",
            Kind::Light,
            vec![360.0, 380.1, 404.656, 1e3 / 3.0 + 100.0, 780.0, 2500.25],
            vec![0.1 + 0.2, 0.5, 1.0 / 3.0, 2.0 / 7.0, 0.25, 1.25],
        ),
        spectrum(
            "finer than 1 nm",
            Kind::Light,
            even(500.0, 0.1, 200),
            wave(200),
        ),
        spectrum(
            "negative values",
            Kind::Light,
            even(380.0, 2.0, 100),
            (0..100).map(signs).collect(),
        ),
        spectrum(
            "not measured elsewhere",
            Kind::Light,
            even(380.0, 10.0, 5),
            vec![-9999.0, -9999.0, 1.0, 2.0, 3.0],
        ),
        spectrum(
            "tiny and huge",
            Kind::Light,
            even(400.0, 10.0, 7),
            vec![5e-324, 1e-300, -1e-308, 9.9e29, -9.9e29, 1.797e-100, -0.0],
        ),
    ]
}

fn provenance() -> Provenance {
    Provenance {
        program: "Spectral Explorer 0.0.0".to_owned(),
        source: String::new(),
        scale_words: "as measured".to_owned(),
        settings: String::new(),
    }
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|v| v.to_bits()).collect()
}

#[test]
fn every_format_gives_every_spectrum_back() {
    for spectrum in cases() {
        for (extension, _) in WRITABLE {
            let place = format!("{} as .{extension}", spectrum.name);
            let columns = Columns::measured(&spectrum);
            let text = encode(extension, &spectrum, &columns, &provenance()).expect(&place);
            let reading = read_bytes(&format!("x.{extension}"), text.as_bytes()).expect(&place);
            let back = &reading.spectra[0];
            assert_eq!((back.kind, back.scale), (spectrum.kind, 1.0), "{place}");
            assert_eq!(back.unit, spectrum.unit, "{place}");
            assert!(!reading.is_doubtful(), "{place}: {:?}", reading.guesses);
            for words in ["as measured", "Spectral Explorer 0.0.0", "a test, 2024"] {
                assert!(text.contains(words), "{place}: {words} is not in it");
            }
            let lost = losses(extension, &spectrum);
            let (was, is) = (&spectrum.samples, &back.samples);
            if lost.iter().any(|words| words.contains("resampled")) {
                assert_eq!(extension, "sp");
                // The area between the first and the last value is that of the straight lines
                // between the old ones, whatever was between the new ones.
                let area = |at: &[f64], value: &dyn Fn(usize) -> f64| -> f64 {
                    let pieces = at.windows(2).enumerate();
                    pieces
                        .map(|(i, w)| 0.5 * (w[1] - w[0]) * (value(i) + value(i + 1)))
                        .sum()
                };
                let outside = spectrum.kind.outside();
                let mut old = was.nm().to_vec();
                old.retain(|nm| *nm > is.first_nm() && *nm < is.last_nm());
                old.insert(0, is.first_nm().max(was.first_nm()));
                old.push(is.last_nm().min(was.last_nm()));
                let before = area(&old, &|i| was.at(old[i], outside));
                let after = area(is.nm(), &|i| is.values()[i]);
                let most = was.values().iter().fold(0.0_f64, |a, b| a.max(b.abs()));
                let length = is.last_nm() - is.first_nm();
                assert!(
                    (before - after).abs() <= 1e-12 * most * length,
                    "{place}: {before} became {after}"
                );
                continue;
            }
            assert_eq!(bits(is.values()), bits(was.values()), "{place}");
            if extension == "sp" {
                let off = is.nm().iter().zip(was.nm()).map(|(a, b)| (a - b).abs());
                assert!(off.fold(0.0, f64::max) <= 1e-9, "{place}");
            } else {
                assert_eq!(bits(is.nm()), bits(was.nm()), "{place}");
            }
        }
    }
}

#[test]
fn several_spectra_go_into_one_table_and_come_back() {
    let mut all = cases();
    all[0].name = "380".to_owned();
    let mut told = 0;
    for kind in Kind::ALL {
        let of_kind: Vec<_> = all.iter().filter(|s| s.kind == kind).cloned().collect();
        let Some(first) = of_kind.first() else {
            continue;
        };
        let columns = Columns::together(&of_kind).expect("one kind and unit");
        let text = encode("csv", first, &columns, &provenance()).expect("a table");
        let reading = read_bytes("all.csv", text.as_bytes()).expect("a table");
        assert_eq!(reading.spectra.len(), of_kind.len());
        for (back, was) in reading.spectra.iter().zip(&of_kind) {
            let name = match was.name.as_str() {
                "380" => "spectrum 380",
                name => name,
            };
            assert_eq!(back.name, name);
            assert_eq!(bits(back.samples.nm()), bits(was.samples.nm()), "{name}");
            let same = bits(back.samples.values()) == bits(was.samples.values());
            assert!(same, "{name}");
            assert_eq!((back.kind, &back.unit), (was.kind, &was.unit), "{name}");
            told += 1;
        }
    }
    assert_eq!(told, all.len());
    let mixed = Columns::together(&cases()).unwrap_err();
    assert!(mixed.contains("expected one kind and unit"), "{mixed}");
}

#[test]
fn every_export_of_the_window_says_scale_and_version_and_is_read_back() {
    let mut app = App::new();
    app.apply(Command::Scale(Scale::PeakOne));
    let version = format!("Spectral Explorer {}", env!("CARGO_PKG_VERSION"));
    for export in Export::ALL {
        let text = export.text(&app, Theme::Light).expect("a text");
        let title = export.title();
        // One line to paste into a message, and a project, which keeps the switch itself.
        if matches!(export, Export::CompositeLine | Export::Project) {
            continue;
        }
        assert!(text.contains(&version), "{title} names no version");
        let scale = match export {
            // A model stays in its file's own numbers.
            Export::CompositeJson => "as measured",
            _ => app.document().scale.words(),
        };
        let words = text.to_lowercase();
        assert!(
            words.contains(&scale.to_lowercase()),
            "{title} names no scale"
        );
    }
    for (export, name) in [
        (Export::Csv, "x.csv"),
        (Export::Spd, "x.spd"),
        (Export::Spdx, "x.spdx"),
        (Export::ArgyllSp, "x.sp"),
        (Export::SpectrumJson, "x.json"),
    ] {
        let text = export.text(&app, Theme::Light).expect("a text");
        let reading = read_bytes(name, text.as_bytes()).expect(name);
        let peak = reading.spectra[0].samples.values().iter().copied();
        let peak = peak.fold(0.0, f64::max);
        // The model's spikes stand in one nanometre each.
        let most = if export == Export::Spd { 10.0 } else { 1.0 };
        assert!((0.5..=most).contains(&peak), "{name}: {peak}");
    }
    let file = composite_file(&app);
    let json = composite_json(&file).expect("finite numbers");
    let back = read_bytes("x.json", json.as_bytes()).expect("a composite");
    assert_eq!(back.composites[0].composite, file.composite);
    let line = composite_line(&file.composite);
    assert_eq!(parse_composite_line(&line).expect("a line"), file.composite);
}

#[test]
fn real_files_are_converted_into_every_format_and_read_again() {
    let folder = root().join("../shared/data/real_files");
    let Ok(items) = std::fs::read_dir(&folder) else {
        eprintln!("skipped: {} is not there", folder.display());
        return;
    };
    let mut written = 0;
    for item in items {
        let path = item.expect("an entry").path();
        let Ok(reading) = read_path(&path) else {
            continue;
        };
        let probes = reading.images.iter().flat_map(|image| image.probes());
        let Some(spectrum) = reading.spectra.into_iter().chain(probes).next() else {
            continue;
        };
        for (extension, _) in WRITABLE {
            let place = format!("{} as .{extension}", path.display());
            let columns = Columns::measured(&spectrum);
            let text = match encode(extension, &spectrum, &columns, &provenance()) {
                Ok(text) => text,
                Err(why) => {
                    assert!(why.contains("expected"), "{place}: {why}");
                    println!("{place}: {why}");
                    continue;
                }
            };
            let back = read_bytes(&format!("x.{extension}"), text.as_bytes()).expect(&place);
            let back = &back.spectra[0];
            written += 1;
            let lost = losses(extension, &spectrum);
            if !lost.iter().any(|words| words.contains("resampled")) {
                let same = bits(back.samples.values()) == bits(spectrum.samples.values());
                assert!(same, "{place}: {:?}", back.notes);
            }
            if lost.is_empty() {
                assert_eq!(back.kind, spectrum.kind, "{place}");
            }
        }
    }
    println!("{written} files written and read again");
    assert!(written > 300);
}
