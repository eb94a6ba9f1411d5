//! The kinds of table that a hostile review tried, a few lines each: a known curve written by a
//! rule, and how it must be read. Every row says the kind of each spectrum and its values at 500 and
//! 600 nm, by the curve's own formula.

use spectral_explorer::io::{Reading, read_bytes};
use spectral_explorer::spectrum::Kind;

/// A white LED in counts, 50 to 10,000.
fn light(nm: f64) -> f64 {
    let bell = |at: f64, width: f64| (-((nm - at) / width).powi(2)).exp();
    50.0 + 10_000.0 * bell(455.0, 12.0) + 6000.0 * bell(570.0, 60.0)
}

/// A red surface, 0.05 to 0.65.
fn red(nm: f64) -> f64 {
    0.05 + 0.6 / (1.0 + ((560.0 - nm) / 15.0).exp())
}

/// 380 to 780 nm in steps of 5 nm.
fn grid() -> impl DoubleEndedIterator<Item = f64> {
    (0..81).map(|i| 380.0 + 5.0 * f64::from(i))
}

/// A line of titles and a row for each wavelength.
fn table(titles: &str, row: impl Fn(f64) -> String) -> String {
    let rows: String = grid().map(|nm| row(nm) + "\n").collect();
    format!(
        "{titles}{}{rows}",
        if titles.is_empty() { "" } else { "\n" }
    )
}

/// Whole numbers with a mark between thousands.
fn thousands(value: f64, mark: &str) -> String {
    let whole = value.round() as u32;
    match whole {
        0..1000 => whole.to_string(),
        _ => format!("{}{mark}{:03}", whole / 1000, whole % 1000),
    }
}

fn comma(text: &str) -> String {
    text.replace('.', ",")
}

type Spectra = Vec<(Kind, f64, f64)>;

/// A kind of table: its name, its text and its spectra.
type Told = (&'static str, Vec<u8>, Spectra);

fn lights(count: usize) -> Spectra {
    vec![(Kind::Light, light(500.0), light(600.0)); count]
}

fn of_red(kind: Kind) -> Spectra {
    vec![(kind, red(500.0), red(600.0))]
}

/// Values at a wavelength between two points, on a straight line.
fn at(nm: &[f64], values: &[f64], wanted: f64) -> f64 {
    let behind = nm.partition_point(|nm| *nm < wanted).clamp(1, nm.len() - 1);
    let (a, b) = (nm[behind - 1], nm[behind]);
    let share = ((wanted - a) / (b - a)).clamp(0.0, 1.0);
    values[behind - 1] + share * (values[behind] - values[behind - 1])
}

/// What is wrong with how a table is read.
fn wrong(told: &Told) -> Option<String> {
    let (name, text, expected) = told;
    let reading: Reading = match read_bytes("a.csv", text) {
        Ok(reading) => reading,
        Err(why) => return Some(format!("{name}: {why}")),
    };
    let found: Spectra = reading
        .spectra
        .iter()
        .map(|spectrum| {
            let samples = &spectrum.samples;
            let value = |nm| at(samples.nm(), samples.values(), nm);
            (spectrum.kind, value(500.0), value(600.0))
        })
        .collect();
    // Tables are written in four figures and more; those in other units between two rows.
    let near = |a: f64, b: f64| (a - b).abs() <= 0.01 * b.abs();
    let same = |(a, b): (&(Kind, f64, f64), &(Kind, f64, f64))| {
        a.0 == b.0 && near(a.1, b.1) && near(a.2, b.2)
    };
    let is_right = found.len() == expected.len() && found.iter().zip(expected).all(same);
    let ends = reading
        .spectra
        .iter()
        .all(|s| s.samples.first_nm() > 379.0 && s.samples.last_nm() < 781.0);
    (!is_right || !ends)
        .then(|| format!("{name}: {found:?}, not {expected:?}; {:?}", reading.notes))
}

fn all_right(tables: &[Told]) {
    let wrong: Vec<String> = tables.iter().filter_map(wrong).collect();
    assert!(
        wrong.is_empty(),
        "{} of {}:\n{}",
        wrong.len(),
        tables.len(),
        wrong.join("\n")
    );
}

/// A kind of table in UTF-8.
fn told(name: &'static str, text: impl Into<Vec<u8>>, expected: Spectra) -> Told {
    (name, text.into(), expected)
}

#[test]
#[expect(clippy::too_many_lines, reason = "a list of tables")]
fn marks_in_numbers() {
    let l = |nm: f64| format!("{:.4}", light(nm));
    let scaled = |by: f64| vec![(Kind::Light, light(500.0) * by, light(600.0) * by)];
    let row = |by: &'static str, value: fn(f64) -> String| {
        move |nm: f64| format!("{nm}{by}{}", value(nm))
    };
    all_right(&[
        told(
            "german thousands",
            table("nm;Counts", row(";", |nm| thousands(light(nm), "."))),
            lights(1),
        ),
        told(
            "american thousands",
            table("nm;Counts", row(";", |nm| thousands(light(nm), ","))),
            lights(1),
        ),
        told(
            "thousands and tabs",
            table("nm\tCounts", row("\t", |nm| thousands(light(nm), "."))),
            lights(1),
        ),
        told(
            "quoted thousands",
            table("nm,Counts", |nm| {
                format!("{nm},\"{}\"", thousands(light(nm), ","))
            }),
            lights(1),
        ),
        told(
            "unquoted thousands",
            table("nm,Counts", row(",", |nm| thousands(light(nm), ","))),
            lights(1),
        ),
        told(
            "unquoted, no titles",
            table("", row(",", |nm| thousands(light(nm), ","))),
            lights(1),
        ),
        told(
            "blanks",
            table("nm;Counts", row(";", |nm| thousands(light(nm), " "))),
            lights(1),
        ),
        told(
            "fixed blanks",
            table("nm;Counts", row(";", |nm| thousands(light(nm), "\u{202f}"))),
            lights(1),
        ),
        told(
            "apostrophes",
            table("nm;Counts", row(";", |nm| thousands(light(nm), "'"))),
            lights(1),
        ),
        told(
            "thousands with decimals",
            table("nm;Counts", |nm| {
                format!("{nm};{},25", thousands(light(nm).floor(), "."))
            }),
            lights(1),
        ),
        told(
            "two columns",
            table("nm;A;B", |nm| {
                format!(
                    "{nm};{};{}",
                    thousands(light(nm), "."),
                    thousands(light(nm), ".")
                )
            }),
            lights(2),
        ),
        told(
            "decimal commas",
            table("nm;W", |nm| format!("{nm};{}", comma(&l(nm)))),
            lights(1),
        ),
        told(
            "quoted decimal commas",
            table("nm,W", |nm| format!("{nm},\"{}\"", comma(&l(nm)))),
            lights(1),
        ),
        told(
            "commas beside commas",
            table("nm,W", |nm| {
                format!("{nm},{}", comma(&format!("{:.4}", light(nm) / 1000.0)))
            }),
            scaled(1e-3),
        ),
        told(
            "commas beside commas in both",
            table("nm,W", |nm| {
                format!("{nm},0,{}", comma(&format!("{:.4}", light(nm) / 1000.0)))
            }),
            scaled(1e-3),
        ),
        told(
            "three columns of them",
            table("nm,A,B", |nm| {
                let value = comma(&format!("{:.4}", light(nm) / 1000.0));
                format!("{nm},{value},{value}")
            }),
            [scaled(1e-3), scaled(1e-3)].concat(),
        ),
        told(
            "a mark of its own each",
            table("nm;W", |nm| format!("{nm}.0;{}", comma(&l(nm)))),
            lights(1),
        ),
        told(
            "decimals of three figures",
            table("nm;W", |nm| format!("{nm};{:.3}", light(nm) / 1e3)),
            scaled(1e-3),
        ),
        told(
            "exponents",
            table("nm;W", |nm| {
                format!("{nm};{}", comma(&format!("{:.5e}", light(nm))))
            }),
            lights(1),
        ),
        told(
            "fortran",
            table("", |nm| {
                format!(
                    "  {nm}D0  {}",
                    format!("{:.6e}", light(nm)).replace('e', "D")
                )
            }),
            lights(1),
        ),
        told(
            "brackets are minus",
            table("nm,W", |nm| match nm {
                ..390.0 => format!("{nm},(0.503)"),
                _ => format!("{nm},{}", l(nm)),
            }),
            lights(1),
        ),
        told(
            "below a limit",
            table("nm,W", |nm| match light(nm) {
                ..60.0 => format!("{nm},<60"),
                value => format!("{nm},{value:.3}"),
            }),
            lights(1),
        ),
    ]);
}

#[test]
fn words_in_titles() {
    let percent = |title: &str| table(title, |nm| format!("{nm};{:.3}", 100.0 * red(nm)));
    let fraction = |title: &str| table(title, |nm| format!("{nm};{:.5}", red(nm)));
    let (reflectance, transmittance) = (Kind::Reflectance, Kind::Transmittance);
    let of = of_red;
    let mut all: Vec<Told> = Vec::new();
    for (title, kind) in [
        ("Wellenlänge;Remission (%)", reflectance),
        ("Wellenlänge [nm];Transmissionsgrad [%]", transmittance),
        ("Longueur d'onde;Réflectance (%)", reflectance),
        ("Longitud de onda;Reflectancia (%)", reflectance),
        ("Lunghezza d'onda;Trasmittanza %", transmittance),
        ("Comprimento de onda;Refletância (%)", reflectance),
        ("Våglängd;Reflektans (%)", reflectance),
        ("波长(nm);反射率(%)", reflectance),
        ("波长(nm);透射率(%)", transmittance),
        ("波長[nm];分光反射率[%]", reflectance),
        ("波長[nm];透過率[%]", transmittance),
        ("파장(nm);반사율(%)", reflectance),
        ("Длина волны (нм);Коэффициент отражения (%)", reflectance),
        ("Длина волны (нм);Пропускание (%)", transmittance),
        ("nm;Sample 1 (%)", reflectance),
        ("nm;%R", reflectance),
        ("nm;T\n;%", transmittance),
        ("nm;T\nnm;%", transmittance),
        ("nm;SCI", reflectance),
        ("nm;SCE", reflectance),
    ] {
        all.push(told(
            "per cent",
            title.to_owned() + &percent("").replace("380;", "\n380;"),
            of(kind),
        ));
    }
    for (title, kind) in [
        ("nm;Reflectance", reflectance),
        ("nm;R", reflectance),
        ("nm;T", transmittance),
        ("nm;Absorbance", Kind::Absorbance),
        ("nm;OD", Kind::Absorbance),
        ("nm;K/S", Kind::Other),
        ("nm;Attenuation (dB)", Kind::Other),
        ("nm;Power (dBm)", Kind::Other),
        ("波长(nm);光谱强度", Kind::Light),
        ("nm;Spectral irradiance (mW/m²/nm)", Kind::Light),
        ("nm;Rel. power (%)", Kind::Light),
    ] {
        all.push(told("fraction", fraction(title), of(kind)));
    }
    let tenth = |nm: f64| 0.01 * red(nm);
    let eighth = |nm: f64| (255.0 * red(nm)).round() / 255.0;
    all.push(told(
        "a dark sample in per cent",
        table("nm;R %", |nm| format!("{nm};{:.5}", red(nm))),
        vec![(reflectance, tenth(500.0), tenth(600.0))],
    ));
    all.push(told(
        "8 bits",
        table("Wavelength,Reflectance", |nm| {
            format!("{nm},{:.0}", 255.0 * red(nm))
        }),
        vec![(reflectance, eighth(500.0), eighth(600.0))],
    ));
    all.push(told(
        "10,000",
        table("Wavelength,Reflectance", |nm| {
            format!("{nm},{:.0}", 10_000.0 * red(nm))
        }),
        of(reflectance),
    ));
    all.push(told(
        "per cent signs",
        table("nm,R", |nm| format!("{nm},{:.2}%", 100.0 * red(nm))),
        of(reflectance),
    ));
    all_right(&all);
    // Values of 0 to 0.65 under a per cent sign may be fractions: that is told.
    let dark = read_bytes("a.csv", fraction("nm;Transmission %").as_bytes()).expect("a table");
    assert!(dark.is_doubtful());
}

#[test]
fn texts_in_other_encodings() {
    let rows = |title: &[u8]| {
        [
            title,
            b"\n",
            table("", |nm| format!("{nm},{:.3}", 100.0 * red(nm))).as_bytes(),
        ]
        .concat()
    };
    // 波长(nm),透过率(%) in GBK; 波長[nm],分光反射率[%] in Shift-JIS; Длина волны (нм),Отражение (%)
    // in windows-1251; Wellenlänge,Reflexionsgrad (%) in windows-1252.
    let gbk = b"\xb2\xa8\xb3\xa4(nm),\xcd\xb8\xb9\xfd\xc2\xca(%)";
    let sjis = b"\x94\x67\x92\xb7[nm],\x95\xaa\x8c\xf5\x94\xbd\x8e\xcb\x97\xa6[%]";
    let cyrillic = b"\xc4\xeb\xe8\xed\xe0 \xe2\xee\xeb\xed\xfb (\xed\xec),\xce\xf2\xf0\xe0\xe6\xe5\xed\xe8\xe5 (%)";
    let western = b"Wellenl\xe4nge,Reflexionsgrad (%)";
    all_right(&[
        told("GBK", rows(gbk), of_red(Kind::Transmittance)),
        told("Shift-JIS", rows(sjis), of_red(Kind::Reflectance)),
        told("windows-1251", rows(cyrillic), of_red(Kind::Reflectance)),
        told("windows-1252", rows(western), of_red(Kind::Reflectance)),
    ]);
    for (title, encoding) in [
        (&gbk[..], "GBK"),
        (sjis, "Shift_JIS"),
        (cyrillic, "windows-1251"),
        (western, "windows-1252"),
    ] {
        let notes = read_bytes("a.csv", &rows(title)).expect("a table").notes;
        assert!(
            notes.contains(&format!("text read as {encoding}")),
            "{notes:?}"
        );
    }
}

#[test]
#[expect(clippy::too_many_lines, reason = "a list of tables")]
fn rows_and_columns() {
    let l = |nm: f64| format!("{:.4}", light(nm));
    let plain = |titles: &str| table(titles, |nm| format!("{nm},{:.4}", light(nm)));
    let rows: Vec<String> = grid().map(|nm| format!("{nm},{}", l(nm))).collect();
    let shuffled: String = (0..81).map(|i| rows[37 * i % 81].clone() + "\n").collect();
    // Irregular wavelengths, as a plot digitiser writes them.
    let traced: Vec<f64> = (0..300u32)
        .map(|i| 380.0 + 1.337 * f64::from(i) + 0.4 * f64::from(i * 7 % 3))
        .collect();
    let traced = |step: usize| -> String {
        (0..300)
            .map(|i| traced[step * i % 300])
            .map(|nm| format!("{nm:.3},{:.4}\n", light(nm)))
            .collect()
    };
    let mistyped: String = grid()
        .map(|nm| {
            let typed = match nm {
                580.0 => 5800.0,
                430.0 => 4300.0,
                nm => nm,
            };
            format!("{typed},{}\n", l(nm))
        })
        .collect();
    let half = |from: usize| move |i: usize| rows_at(from + i);
    let blocks: String = (0..40)
        .map(|i| half(0)(i) + "," + &half(40)(i) + "\n")
        .collect();
    let fold = |head: &str| -> String {
        let row = |ten: u32| {
            let at = |one: u32| format!(",{:.4}", light(f64::from(380 + 10 * ten + one)));
            format!(
                "{}{}\n",
                380 + 10 * ten,
                (0..10).map(at).collect::<String>()
            )
        };
        head.to_owned() + &(0..40).map(row).collect::<String>()
    };
    let two_axes: String = grid()
        .map(|nm| format!("{nm}\t{:.5}\t{nm}\t{:.5}\n", red(nm), red(nm)))
        .collect();
    let beside = |titles: &str, cell: fn(f64) -> String| {
        table(titles, |nm| format!("{},{nm},{}", cell(nm), l(nm)))
    };
    all_right(&[
        told("any order", "nm,W\n".to_owned() + &shuffled, lights(1)),
        told("any order, no titles", shuffled, lights(1)),
        told(
            "traced in any order",
            "nm,W\n".to_owned() + &traced(67),
            lights(1),
        ),
        told("traced in any order, no titles", traced(127), lights(1)),
        told(
            "falling",
            "nm,W\n".to_owned()
                + &rows
                    .iter()
                    .rev()
                    .map(|r| r.clone() + "\n")
                    .collect::<String>(),
            lights(1),
        ),
        told("two mistyped", "nm,W\n".to_owned() + &mistyped, lights(1)),
        told(
            "numbers below",
            plain("nm,W") + "1,5800\n2,82\n3,1234.5\n",
            lights(1),
        ),
        told(
            "numbers below a line",
            plain("nm,W") + "\n100.3,0.5\n",
            lights(1),
        ),
        told(
            "named numbers below",
            plain("nm,W") + "CCT,5800\nLux,1234.5\n",
            lights(1),
        ),
        told(
            "numbers above",
            "1,2\n3,4\n100,10\n\n".to_owned() + &plain("nm,W"),
            lights(1),
        ),
        told(
            "numbers above, no titles",
            "1,2\n3,4\n100,10\n\n".to_owned() + &plain(""),
            lights(1),
        ),
        told(
            "three rows of zeros",
            plain("nm,W") + "0,0\n0,0\n0,0\n",
            lights(1),
        ),
        told(
            "titles again",
            plain("nm,W").replace("400,", "nm,W\n400,"),
            lights(1),
        ),
        told("two blocks", "nm,W,nm,W\n".to_owned() + &blocks, lights(1)),
        told(
            "tens down the side",
            fold("nm,0,1,2,3,4,5,6,7,8,9\n"),
            lights(1),
        ),
        told(
            "tens with a plus",
            fold("nm,+0,+1,+2,+3,+4,+5,+6,+7,+8,+9\n"),
            lights(1),
        ),
        told("tens, no titles", fold(""), lights(1)),
        told(
            "a second axis of the same",
            "spot 1\ttransmittance.1\tspot 2\ttransmittance.2\n".to_owned() + &two_axes,
            of_red(Kind::Transmittance).repeat(2),
        ),
        told(
            "elapsed first",
            beside("Elapsed (s),Wavelength (nm),Power", |nm| {
                format!("{}", nm / 10.0 - 38.0)
            }),
            lights(1),
        ),
        told(
            "integration first",
            beside("Integration (ms),Wavelength (nm),Power", |_| {
                "100".to_owned()
            }),
            lights(1),
        ),
        told(
            "gain first",
            beside("Gain,Wavelength (nm),Power", |_| "2".to_owned()),
            lights(1),
        ),
        told(
            "temperature first",
            beside("T (°C),Wavelength (nm),Power", |nm| {
                format!("{:.1}", 25.0 + nm / 1000.0)
            }),
            lights(1),
        ),
        told(
            "a count first",
            beside("Index,Wavelength (nm),Power", |nm| {
                format!("{}", (nm - 380.0) / 5.0)
            }),
            lights(1),
        ),
        told(
            "with matching functions",
            table("nm,S,xbar,ybar,zbar", |nm| {
                format!("{nm},{},0.1,0.2,0.3", l(nm))
            }),
            lights(1),
        ),
        told(
            "mean and spread",
            table("nm,mean,sd", |nm| format!("{nm},{},0.1", l(nm))),
            lights(1),
        ),
        told(
            "readings repeated",
            grid()
                .map(|nm| format!("{nm},{}\n{nm},{}\n", 0.99 * light(nm), 1.01 * light(nm)))
                .collect::<String>(),
            lights(1),
        ),
        told(
            "value first",
            table("Irradiance,Wavelength", |nm| format!("{},{nm}", l(nm))),
            lights(1),
        ),
        told(
            "empty cells behind",
            table("nm;W;;;", |nm| format!("{nm};{};;;", l(nm))),
            lights(1),
        ),
        told(
            "units in cells",
            table("nm,W", |nm| format!("{nm} nm,{} W", l(nm))),
            lights(1),
        ),
        told(
            "one below the other",
            format!("A\n{}\nB\n{}", plain("nm,W"), plain("nm,W")),
            lights(2),
        ),
        told(
            "repeated columns 0 to 9",
            table("nm,0,1,2,3,4", |nm| {
                format!("{nm}{}", format!(",{}", l(nm)).repeat(5))
            }),
            lights(5),
        ),
    ]);
}

/// A row of the table, by its place.
fn rows_at(at: usize) -> String {
    let nm = 380.0 + 5.0 * at as f64;
    format!("{nm},{:.4}", light(nm))
}

#[test]
fn wavelengths_in_other_units() {
    let by = |titles: &str, x: fn(f64) -> f64, places: usize| {
        table(titles, |nm| format!("{:.places$},{:.4}", x(nm), light(nm)))
    };
    let ev: fn(f64) -> f64 = |nm| 1_239.841_984 / nm;
    let thz: fn(f64) -> f64 = |nm| 299_792.458 / nm;
    let per_cm: fn(f64) -> f64 = |nm| 1e7 / nm;
    all_right(&[
        told(
            "um",
            by("Wavelength (um),W", |nm| nm / 1000.0, 4),
            lights(1),
        ),
        told("um, no titles", by("", |nm| nm / 1000.0, 4), lights(1)),
        told(
            "Å",
            by("Wavelength (Angstrom),W", |nm| 10.0 * nm, 0),
            lights(1),
        ),
        told("Å, no titles", by("", |nm| 10.0 * nm, 0), lights(1)),
        told("eV", by("Energy (eV),Counts", ev, 5), lights(1)),
        told("eV, no titles", by("", ev, 5), lights(1)),
        told("THz", by("Frequency (THz),Power", thz, 5), lights(1)),
        told("1/cm", by("Wavenumber (cm-1),Power", per_cm, 3), lights(1)),
        told("1/cm, no titles", by("", per_cm, 3), lights(1)),
        told("m", by("Wavelength (m),W", |nm| 1e-9 * nm, 12), lights(1)),
    ]);
}

#[test]
fn the_same_wavelength_with_two_values_is_refused_with_both_lines() {
    let text = table("nm,W", |nm| match nm {
        505.0 => "500,7".to_owned(),
        nm => format!("{nm},{:.1}", light(nm)),
    });
    let why = read_bytes("a.csv", text.as_bytes()).expect_err("two values at 500 nm");
    let said = format!(
        "a.csv, line 27: found 500 with {:.1} in line 26 and with 7 in line 27",
        light(500.0)
    );
    assert!(why.to_string().starts_with(&said), "{why}");
}

#[test]
fn commas_that_may_be_either_are_refused_and_many_mistyped_wavelengths_too() {
    // 380.0 nm with 5 to 5000, or 380 nm with 0.5 and 0.5000.
    let text = table("nm,W", |nm| {
        format!("{nm},0,{}", if nm < 500.0 { 5 } else { 1234 })
    });
    let why = read_bytes("a.csv", text.as_bytes())
        .expect_err("commas")
        .to_string();
    assert!(why.contains("3 whole numbers under 2 titles"), "{why}");
    let typed = |nm: f64| if nm % 50.0 == 0.0 { 10.0 * nm } else { nm };
    let text = table("nm,W", |nm| format!("{},{:.1}", typed(nm), light(nm)));
    let why = read_bytes("a.csv", text.as_bytes())
        .expect_err("eight mistyped")
        .to_string();
    assert!(why.contains("out of order"), "{why}");
}

#[test]
fn a_number_without_a_per_cent_sign_among_others_is_no_value() {
    let text = table("nm,R", |nm| match nm {
        500.0 => format!("{nm},0.31"),
        nm => format!("{nm},{:.2}%", 100.0 * red(nm)),
    });
    let reading = read_bytes("a.csv", text.as_bytes()).expect("a table");
    assert_eq!(reading.spectra[0].samples.len(), 80);
}

#[test]
fn lines_of_light_by_frequency_and_wave_number_stand_where_they_do_in_air() {
    // Vacuum and air wavelengths of sodium's D2 and mercury's green line by NIST's Atomic Spectra
    // Database: 589.1583 and 588.9951 nm, 546.2267 and 546.0750 nm.
    let line = |vacuum: f64, unit: fn(f64) -> f64, title: &str| {
        let rows: String = (-20..=20)
            .map(|i| {
                let nm = vacuum + 0.05 * f64::from(i);
                format!("{:.8},{}\n", unit(nm), 100 - 4 * i32::abs(i))
            })
            .collect();
        let reading =
            read_bytes("a.csv", format!("{title},W\n{rows}").as_bytes()).expect("a table");
        let samples = &reading.spectra[0].samples;
        let note = reading.spectra[0]
            .notes
            .iter()
            .any(|note| note.contains("in vacuum turned"));
        assert!(note, "{:?}", reading.spectra[0].notes);
        let values = samples.values().iter().enumerate();
        let top = values.max_by(|a, b| a.1.total_cmp(b.1)).expect("a value").0;
        samples.nm()[top]
    };
    for (vacuum, air) in [(589.1583, 588.9951), (546.2267, 546.0750)] {
        for (unit, title) in [
            ((|nm| 1e7 / nm) as fn(f64) -> f64, "Wavenumber (cm-1)"),
            (|nm| 299_792.458 / nm, "Frequency (THz)"),
            (|nm| 1_239.841_984_332 / nm, "Energy (eV)"),
            (|nm| nm, "Vacuum wavelength (nm)"),
        ] {
            let found = line(vacuum, unit, title);
            // Both printed to 1e-4 nm.
            assert!((found - air).abs() < 1.5e-4, "{title}: {found}");
        }
    }
}
