//! Photographs of spectra on the command line: a strip that the test draws itself, its axis, its
//! table, and what is refused.

use std::{fs, path::Path};

use crate::tell::{json, refusal, tell};

/// The lines of a fluorescent lamp: nm, strength, width in nm.
const LINES: [(f64, f64, f64); 12] = [
    (404.66, 0.25, 1.9),
    (435.83, 0.8, 1.9),
    (487.7, 0.25, 4.5),
    (542.4, 0.75, 2.6),
    (546.07, 0.75, 1.9),
    (576.96, 0.10, 1.9),
    (579.07, 0.10, 1.9),
    (587.6, 0.16, 3.0),
    (593.0, 0.12, 2.2),
    (599.6, 0.10, 2.2),
    (611.3, 1.0, 2.2),
    (631.0, 0.13, 2.6),
];
/// Centres and widths of the camera's red, green and blue, nm.
const CAMERA: [(f64, f64); 3] = [(605.0, 36.0), (535.0, 38.0), (455.0, 34.0)];

/// A strip of 700 x 200 px, leaning and turned a little.
pub(crate) struct Drawn {
    lines: &'static [(f64, f64, f64)],
    smooth: f64,
}

impl Drawn {
    pub(crate) const LAMP: Self = Self {
        lines: &LINES,
        smooth: 0.004,
    };
    /// The same lines on a glow that is seen beyond them: its strip reaches over all wavelengths
    /// that colour figures need.
    pub(crate) const GLOWING: Self = Self {
        lines: &LINES,
        smooth: 0.04,
    };
    pub(crate) const BULB: Self = Self {
        lines: &[],
        smooth: 0.3,
    };

    /// The wavelength at a pixel.
    fn nm(x: f64, y: f64) -> f64 {
        let u = x - 350.0 + 0.02 * (y - 100.0) - 0.04 * (y - 100.0);
        let t = u / 700.0;
        530.0 + 390.0 * t - 14.0 * t * t
    }

    /// The light at a pixel.
    fn light(&self, x: f64, y: f64) -> [f64; 3] {
        let away = (y - 100.0 - 0.02 * (x - 350.0)).abs();
        let row = 1.0 / (1.0 + ((away - 30.0) / 1.2).exp());
        let nm = Self::nm(x, y);
        let of_line = |&(at, strength, fwhm): &(f64, f64, f64)| {
            strength * (-4.0 * 2_f64.ln() * ((nm - at) / fwhm).powi(2)).exp()
        };
        let light = self.smooth + self.lines.iter().map(of_line).sum::<f64>();
        CAMERA.map(|(centre, width)| {
            0.002 + 0.8 * row * light * (-0.5 * ((nm - centre) / width).powi(2)).exp()
        })
    }

    /// The picture as PNG, codes of sRGB with some noise.
    pub(crate) fn png(&self) -> Vec<u8> {
        self.exposed(1.0, 1.0)
    }

    /// The same exposed so much longer, by a camera whose values go with a power of the light.
    pub(crate) fn exposed(&self, longer: f64, power: f64) -> Vec<u8> {
        let mut state = 1_u32;
        let mut data = Vec::new();
        for y in 0..200 {
            for x in 0..700 {
                for light in self.light(f64::from(x), f64::from(y)) {
                    let light = (longer * light).powf(power);
                    let code = if light <= 0.003_130_8 {
                        12.92 * light
                    } else {
                        1.055 * light.powf(1.0 / 2.4) - 0.055
                    };
                    state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    let noise = f64::from(state >> 16) / 65_536.0 - 0.5;
                    data.push((255.0 * code + 2.0 * noise).round().clamp(0.0, 255.0) as u8);
                }
            }
        }
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 700, 200);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header().expect("a header");
        writer.write_image_data(&data).expect("pixels");
        writer.finish().expect("an end");
        bytes
    }
}

/// A file in a folder, and its path in words.
fn put(folder: &Path, name: &str, bytes: &[u8]) -> String {
    let path = folder.join(name);
    fs::write(&path, bytes).expect(name);
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn the_lines_of_a_lamp_make_the_axis_and_pixels_have_their_wavelengths() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamp = put(folder.path(), "lamp.png", &Drawn::LAMP.png());
    let told = json(&[
        "photo", &lamp, "--at", "200,95", "--at", "400,110", "--json",
    ]);
    assert_eq!(
        (&told["state"], &told["lamp"]),
        (&"found".into(), &"fluorescent".into())
    );
    assert_eq!(told["strip"]["vertical"], false);
    for at in told["at"].as_array().expect("places") {
        let number = |key: &str| at[key].as_f64().expect("a figure");
        let off = number("nm") - Drawn::nm(number("x"), number("y"));
        assert!(off.abs() < 0.6, "{at}: off by {off}");
    }
    let lines = told["lines"].as_array().expect("lines");
    assert!(lines.len() >= 7, "{lines:?}");
}

#[test]
fn the_spectrum_is_written_with_its_axis_and_its_unit() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamp = put(folder.path(), "lamp.png", &Drawn::LAMP.png());
    let out = folder.path().join("lamp.csv");
    let out = out.to_str().expect("UTF-8");
    let (code, words, err) = tell(&["photo", &lamp, "--out", out]);
    assert_eq!(code, 0, "{err}");
    assert!(words.contains("Looks like a fluorescent lamp"), "{words}");
    let text = fs::read_to_string(out).expect("a table");
    assert!(text.contains("# unit: relative") && text.contains("# lamp: fluorescent"));
    let rows: Vec<Vec<f64>> = (text.lines())
        .filter_map(|line| line.split(',').map(|cell| cell.parse().ok()).collect())
        .collect();
    assert!(rows.len() > 200, "{} rows", rows.len());
    let top = rows
        .iter()
        .max_by(|a, b| a[1].total_cmp(&b[1]))
        .expect("rows");
    assert_eq!(top[1], 1.0);
    assert!([611.0, 612.0, 542.0, 543.0].contains(&top[0]), "{top:?}");
    assert!(
        refusal(&["photo", &lamp, "--out", out])
            .0
            .contains("--force")
    );
}

#[test]
fn smooth_light_has_no_axis_by_itself_and_one_by_pins() {
    let folder = tempfile::tempdir().expect("a folder");
    let bulb = put(folder.path(), "bulb.png", &Drawn::BULB.png());
    let (code, out, _) = tell(&["photo", &bulb, "--json"]);
    assert_eq!(code, 4, "{out}");
    assert!(out.contains("\"state\": \"none\""), "{out}");
    let pinned = json(&[
        "photo", &bulb, "--pin", "40:420", "--pin", "300:610", "--json",
    ]);
    assert_eq!(pinned["state"], "pins");
    let warnings = pinned["warnings"].to_string();
    assert!(warnings.contains("two points"), "{warnings}");
    let zigzag = [
        "photo", &bulb, "--pin", "40:420", "--pin", "90:500", "--pin", "99:430",
    ];
    let (words, code) = refusal(&zigzag);
    assert!(words.contains("out of order") && code == 2, "{words}");
}

#[test]
fn what_is_no_picture_or_no_strip_is_refused_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let whole = Drawn::LAMP.png();
    let cut = put(folder.path(), "cut.png", &whole[..whole.len() / 2]);
    let (words, code) = refusal(&["photo", &cut]);
    assert!(words.contains("broken") && code == 2, "{words}");
    let text = put(folder.path(), "text.jpg", b"nm,value");
    assert!(
        refusal(&["photo", &text])
            .0
            .contains("expected a JPEG or PNG picture")
    );
    let lamp = put(folder.path(), "lamp.png", &whole);
    assert!(
        refusal(&["photo", &lamp, "--strip", "3"])
            .0
            .contains("strips")
    );
    assert!(
        refusal(&["photo", &lamp, "--box", "0,0,900,40"])
            .0
            .contains("inside the picture")
    );
    assert!(
        refusal(&["photo", &lamp, "--lamp", "candle"])
            .0
            .contains("fluorescent")
    );
}

#[test]
fn colour_figures_need_a_response_and_come_with_their_bands() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamp = put(folder.path(), "lamp.png", &Drawn::GLOWING.png());
    let flat = put(folder.path(), "flat.png", &Drawn::BULB.png());
    let kept = folder.path().join("bench.json");
    let kept = kept.to_str().expect("UTF-8");
    // Equal energy as daylight of 5500 K: what is asked is that figures follow, not which.
    let told = json(&[
        "photo",
        &lamp,
        "--response-from",
        &flat,
        "--as",
        "daylight:5500",
        "--save-instrument",
        kept,
        "--json",
    ]);
    let (figures, response) = (&told["figures"], &told["response"]);
    let [low, best, high] = [0, 1, 2].map(|k| figures["cct"][k].as_f64().unwrap_or(f64::NAN));
    assert!(
        low < best && best < high && low > 1500.0,
        "{figures}, {response}"
    );
    assert_eq!(response["tone_p"], 1.0);
    // The flat light itself, read with the instrument that it taught.
    let again = json(&["photo", &flat, "--instrument", kept, "--yes", "--json"]);
    let [low, best, high] =
        [0, 1, 2].map(|k| again["figures"]["cct"][k].as_f64().unwrap_or(f64::NAN));
    assert!(
        low <= 5500.0 && high >= 5500.0 && (best - 5500.0).abs() < 300.0,
        "{again}"
    );
    // Without a response nothing is said of colours.
    let plain = json(&["photo", &lamp, "--json"]);
    assert_eq!(plain["figures"], serde_json::Value::Null);
}

#[test]
fn sizes_beyond_the_limits_and_other_formats_are_refused_in_words() {
    let folder = tempfile::tempdir().expect("a folder");
    // A header that lies: 12,000 x 12,000 px in a few bytes.
    let mut lying = Drawn::LAMP.png();
    lying[16..24].copy_from_slice(&[0, 0, 0x2e, 0xe0, 0, 0, 0x2e, 0xe0]);
    let lying = put(folder.path(), "lying.png", &lying);
    assert_eq!(refusal(&["photo", &lying]).1, 2);
    for (name, bytes, word) in [
        ("a.heic", &b"\0\0\0\x18ftypheic\0\0\0\0mif1heic"[..], "HEIC"),
        ("a.avif", &b"\0\0\0\x18ftypavif\0\0\0\0mif1avif"[..], "AVIF"),
        ("a.gif", &b"GIF89a\x01\0\x01\0"[..], "GIF"),
        ("a.dng", &b"II*\0\x08\0\0\0"[..], "raw"),
    ] {
        let path = put(folder.path(), name, bytes);
        let (words, code) = refusal(&["photo", &path]);
        assert!(words.contains(word) && code == 2, "{name}: {words}");
    }
}

#[test]
fn the_strip_is_set_by_hand_where_a_person_knows_better() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamp = put(folder.path(), "lamp.png", &Drawn::LAMP.png());
    let found = json(&["photo", &lamp, "--json"]);
    assert_eq!(
        (&found["strip"]["flip"], &found["strip"]["by_hand"]),
        (&false.into(), &false.into())
    );
    let by_hand = json(&[
        "photo",
        &lamp,
        "--shear",
        "0.03",
        "--smile",
        "-0.0001",
        "--no-flip",
        "--json",
    ]);
    let strip = &by_hand["strip"];
    assert_eq!(
        (&strip["shear"], &strip["smile"], &strip["by_hand"]),
        (&0.03.into(), &(-0.0001).into(), &true.into())
    );
    assert_eq!(by_hand["state"], "found");
    // One row of thirty has the same lines, with more noise.
    let row = json(&["photo", &lamp, "--one-row", "--at", "400,100", "--json"]);
    assert_eq!(
        (&row["strip"]["rows"], &row["state"]),
        (&1.into(), &"found".into())
    );
    let off = row["at"][0]["nm"].as_f64().expect("a place") - Drawn::nm(400.0, 100.0);
    assert!(off.abs() < 0.6, "{off}");
    // Read from the wrong end it is no lamp.
    let (code, out, _) = tell(&["photo", &lamp, "--flip", "--json"]);
    assert!(code == 4 || code == 3, "{out}");
    assert!(out.contains("\"flip\": true"), "{out}");
    assert!(
        refusal(&["photo", &lamp, "--shear", "9"])
            .0
            .contains("-5 to 5")
    );
}

#[test]
fn one_of_several_pictures_that_cannot_be_read_hides_no_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamp = put(folder.path(), "lamp.png", &Drawn::LAMP.png());
    let text = put(folder.path(), "text.png", b"nm,value");
    let (code, out, err) = tell(&["photo", &text, &lamp, "--json"]);
    assert_eq!(code, 2, "{err}");
    let all: serde_json::Value = serde_json::from_str(&out).expect("a list");
    assert!(
        all[0]["refused"]
            .as_str()
            .expect("why")
            .contains("JPEG or PNG")
    );
    assert_eq!(all[1]["state"], "found");
}

#[test]
fn two_exposures_tell_the_power_of_the_light_and_fill_what_is_over_exposed() {
    let folder = tempfile::tempdir().expect("a folder");
    let power = 1.3;
    let long = put(
        folder.path(),
        "long.png",
        &Drawn::GLOWING.exposed(2.4, power),
    );
    let short = put(
        folder.path(),
        "short.png",
        &Drawn::GLOWING.exposed(0.6, power),
    );
    let exposures = [format!("{long}:1/10"), format!("{short}:1/40")];
    let told = json(&[
        "photo",
        &long,
        "--exposures",
        &exposures[0],
        &exposures[1],
        "--json",
    ]);
    let found = told["exposures"]["light_power"].as_f64().expect("a power");
    // A code is half a code sure: at a twentieth of the brightest column that is 2 % of its light.
    assert!((found - power).abs() < 0.05, "{found}");
    let joined = told["exposures"]["joined_columns"]
        .as_u64()
        .expect("columns");
    assert!(joined > 0 && told["clipped_columns"] == 0, "{joined}");
    let (_, alone, _) = tell(&["photo", &long, "--json"]);
    let alone: serde_json::Value = serde_json::from_str(&alone).expect("JSON");
    assert!(alone["clipped_columns"].as_u64() > Some(0) && alone["exposures"].is_null());
    // A straight camera is left alone.
    let plain = put(
        folder.path(),
        "plain.png",
        &Drawn::GLOWING.exposed(1.0, 1.0),
    );
    let dark = put(folder.path(), "dark.png", &Drawn::GLOWING.exposed(0.5, 1.0));
    let exposures = [format!("{plain}:0.02"), format!("{dark}:0.01")];
    let told = json(&[
        "photo",
        &plain,
        "--exposures",
        &exposures[0],
        &exposures[1],
        "--json",
    ]);
    assert_eq!(told["exposures"]["light_power"], 1.0);
    // Pictures of two lights are no exposures of one.
    let bulb = put(folder.path(), "bulb.png", &Drawn::BULB.png());
    let both = [format!("{bulb}:1"), format!("{dark}:0.01")];
    let (words, code) = refusal(&["photo", &plain, "--exposures", &both[0], &both[1]]);
    assert!(words.contains("exposures") && code == 2, "{words}");
}

/// Photographs by others, where they are at hand.
fn real_photographs() -> Option<std::path::PathBuf> {
    let folders = ["../shared", "../../shared"].map(|up| crate::root::root().join(up));
    let mut folders = folders.iter().map(|f| f.join("data/real_photographs"));
    folders.find(|folder| folder.join("INDEX.json").is_file())
}

#[test]
fn no_real_photograph_is_taken_for_a_lamp_that_it_does_not_show() {
    let Some(folder) = real_photographs() else {
        println!("skipped: the photographs of others are not at hand");
        return;
    };
    let index = fs::read_to_string(folder.join("INDEX.json")).expect("an index");
    let index: serde_json::Value = serde_json::from_str(&index).expect("an index");
    let photographs = index["photographs"].as_array().expect("photographs");
    let (mut found, mut told) = (0, 0);
    for photograph in photographs {
        let text = |key: &str| photograph[key].as_str().expect("a word").to_owned();
        let path = folder.join(text("file"));
        let mut words = vec!["photo".to_owned(), path.to_str().expect("UTF-8").to_owned()];
        if let Some(area) = photograph["box_x0y0x1y1"].as_array() {
            let edges: Vec<f64> = area.iter().filter_map(serde_json::Value::as_f64).collect();
            let [x0, y0, x1, y1] = edges[..] else {
                panic!("four edges")
            };
            words.extend([
                "--box".to_owned(),
                format!("{x0},{y0},{},{}", x1 - 1.0, y1 - 1.0),
            ]);
        }
        let pins: Vec<[f64; 3]> =
            serde_json::from_value(photograph["pins_nm_x_y"].clone()).unwrap_or_default();
        for [_, x, y] in &pins {
            words.extend(["--at".to_owned(), format!("{x},{y}")]);
        }
        words.push("--json".to_owned());
        let expected = text("expect");
        for lamp in ["auto", &expected] {
            if lamp == "refuse" {
                continue;
            }
            let mut words = words.clone();
            words.extend(["--lamp".to_owned(), lamp.to_owned()]);
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            let (_, out, err) = tell(&words);
            let answer: serde_json::Value = serde_json::from_str(&out).expect(&err);
            println!(
                "{} {lamp}: {} {}",
                text("name"),
                answer["state"],
                answer["lamp"]
            );
            if answer["state"] != "found" {
                continue;
            }
            assert_eq!(answer["lamp"], *expected, "{}", text("name"));
            found += usize::from(lamp == "auto");
            told += usize::from(lamp != "auto");
            let axis = &answer["axis"];
            let number = |of: &serde_json::Value| of.as_f64().expect("a figure");
            let step = (number(&axis["c"][1]) / number(&axis["scale_px"])).abs();
            let most = photograph["pin_tolerance_px"].as_f64().unwrap_or(5.0) * step;
            let valid = [0, 1].map(|k| number(&axis["valid_nm"][k]));
            for ([nm, ..], at) in pins.iter().zip(answer["at"].as_array().expect("places")) {
                // Beyond its lines the axis itself says that it does not hold.
                if !(valid[0] + 15.0..=valid[1] - 15.0).contains(nm) {
                    continue;
                }
                let off = number(&at["nm"]) - nm;
                assert!(off.abs() <= most, "{} at {nm}: {off:.2} nm", text("name"));
            }
        }
    }
    assert!(found >= 3 && told >= 4, "{found}, {told}");
}
