//! What a wavelength axis counts.

use crate::told::{has, read};
use spectral_explorer::io::{Reading, WavelengthUnit};

fn of(title: &str, numbers: [f64; 3]) -> Reading {
    let [a, b, c] = numbers;
    read("a.csv", format!("{title};W\n{a};1\n{b};2\n{c};3\n"))
}

#[test]
fn titles_name_their_unit_by_whole_words() {
    use WavelengthUnit::*;
    for (title, unit) in [
        ("Wavelength (nm)", Nanometre),
        ("wavelength_nm", Nanometre),
        ("Wavelength(micron)", Micrometre),
        ("Wavelength (microns)", Micrometre),
        ("λ [µm]", Micrometre),
        ("Lambda / Å", Angstrom),
        ("Våglängd (Å)", Angstrom),
        ("Wavenumber", PerCentimetre),
        ("Energy (eV)", Electronvolt),
        ("Energy (meV)", Millielectronvolt),
        ("Frequency (THz)", Terahertz),
        ("f [GHz]", Gigahertz),
        ("Wavelength (pm)", Picometre),
        ("Длина волны (мкм)", Micrometre),
    ] {
        let numbers = [500.0, 510.0, 520.0].map(|nm| unit.of_nm(nm));
        let reading = of(title, numbers);
        let nm = reading.spectra[0].samples.nm();
        // In air a wavelength is shorter by .028 %.
        let low = if unit.is_length() { 499.99 } else { 499.8 };
        assert!(nm[0] > low && nm[0] < 500.001, "{title}: {}", nm[0]);
        assert!(
            !reading
                .guesses
                .iter()
                .any(|guess| guess.because.contains("range")),
            "{title}"
        );
    }
    let odd = [
        "Wavelength scan, 5:14 pm",
        "lambda (Micronix spectrometer)",
        "Våglängd",
    ];
    for title in odd {
        assert_eq!(
            of(title, [500.0, 510.0, 520.0]).spectra[0].samples.nm()[0],
            500.0
        );
    }
}

#[test]
fn a_unit_that_is_not_known_is_noticed() {
    for title in ["Frequency (PHz)", "Wavelength [furlong]", "Energy / keV"] {
        assert!(of(title, [500.0, 510.0, 520.0]).is_doubtful(), "{title}");
    }
}

#[test]
fn every_unit_goes_there_and_back() {
    for unit in WavelengthUnit::ALL {
        let nm = unit.to_nm(unit.of_nm(546.1));
        assert!((nm - 546.1).abs() < 1e-9, "{}", unit.word());
    }
    assert!((WavelengthUnit::Electronvolt.to_nm(2.0) - 619.92).abs() < 0.01);
    assert_eq!(WavelengthUnit::Terahertz.to_nm(500.0), 599.584_916);
    assert_eq!(WavelengthUnit::Picometre.to_nm(380_000.0), 380.0);
}

#[test]
fn a_title_tells_which_column_holds_the_wavelengths() {
    for title in [
        "wl",
        "w.length",
        "Wave",
        "Wvl",
        "LOWER WVL",
        "nm",
        "w.length.2",
        "波长",
        "Длина волны",
    ] {
        // By their numbers both might.
        let reading = read("a.csv", format!("a;{title}\n500;400\n510;410\n520;421\n"));
        assert_eq!(reading.spectra[0].samples.nm()[0], 400.0, "{title}");
    }
    for title in [
        "white",
        "watt",
        "E(lambda) [W/m2]",
        "S(lambda)",
        "R(wavelength)",
    ] {
        let reading = read("a.csv", format!("a;{title}\n500;400\n510;410\n520;421\n"));
        assert_eq!(reading.spectra[0].samples.nm()[0], 500.0, "{title}");
    }
}

#[test]
fn a_title_outweighs_the_header_and_the_header_the_range() {
    let of = |lines: &str, rows: &str| read("a.txt", format!("{lines}{rows}"));
    let header = "X Units: Wavelength (micrometers)\n";
    let visible = "350 1\n500 2\n2500 3\n";
    for lines in [format!("{header}Wavelength(nm) W\n"), header.to_owned()] {
        // 2500 um is nonsense.
        assert_eq!(
            of(&lines, visible).spectra[0].samples.last_nm(),
            2500.0,
            "{lines}"
        );
    }
    let micrometres = ".35 1\n.5 2\n2.5 3\n";
    let told = of(header, micrometres);
    assert_eq!(told.spectra[0].samples.last_nm(), 2500.0);
    let asks = |reading: &Reading| reading.guesses.iter().any(|g| g.chosen == "um");
    assert!(!asks(&told) && asks(&of("", micrometres)));
    let dpt = read("a.dpt", "800,1\n900,2\n2500,3\n");
    assert!(dpt.guesses.iter().any(|guess| guess.chosen == "1/cm"));
}

#[test]
fn a_unit_that_takes_nanometres_away_from_light_is_only_a_guess() {
    for (lines, chosen) in [
        (
            "Wavelength calibration lamp, Ångström Laboratory\n",
            "nm, not Å",
        ),
        ("Wavelength (Å);W\n", "nm, not Å"),
        ("Frequency (PHz);W\n", "nm, not PHz"),
    ] {
        let reading = read("a.csv", format!("{lines}380;1\n500;2\n780;3\n"));
        let words: Vec<&String> = reading.guesses.iter().map(|guess| &guess.chosen).collect();
        assert!(
            words.iter().any(|word| **word == chosen),
            "{lines}: {words:?}"
        );
    }
}

#[test]
fn units_of_values_stand_in_brackets_or_behind_the_word_or_alone() {
    let of = |text: &str| read("a.csv", text).spectra[0].unit.clone();
    let rows = "380;1\n385;2\n390;1\n";
    for (titles, unit) in [
        ("nm;mW/m2/nm\n", "mW/m2/nm"),
        ("nm;W m-2 nm-1\n", "W m-2 nm-1"),
        ("nm;Irradiance [µW/cm2/nm]\n", "µW/cm2/nm"),
        ("nm;E(lambda) [W/(m²·nm)]\n", "W/(m²·nm)"),
        ("nm;Strahlung in W/(m²·nm)\n", "W/(m²·nm)"),
        ("nm;Global tilt  W*m-2*nm-1\n", "W*m-2*nm-1"),
        ("nm;Photon flux [photons/s/cm2/nm]\n", "photons/s/cm2/nm"),
        ("nm;PFD µmol m-2 s-1 nm-1\n", "µmol m-2 s-1 nm-1"),
        ("nm;Photon flux\n", "photons"),
        ("nm;TL01\n", ""),
        ("nm;LED 1/2\n", ""),
        ("nm;W 10/12\n", ""),
        ("unit: W m-2 nm-1\n", "W m-2 nm-1"),
        ("Units\t(W/m^2nm)\n", "W/m^2nm"),
        ("Units\tW/(cm^2 nm)\n", "W/(cm^2 nm)"),
    ] {
        assert_eq!(of(&format!("{titles}{rows}")), unit, "{titles}");
    }
}

#[test]
fn per_cent_is_told_from_noisy_fractions_and_whole_numbers_and_from_other_shares() {
    let scale = |header: &str, value: &dyn Fn(usize) -> f64| {
        let rows: String = (0..200)
            .map(|i| format!("{};{}\n", 400 + i, value(i)))
            .collect();
        read("a.csv", format!("{header}nm;Reflectance\n{rows}")).spectra[0].scale
    };
    let noisy = |i: usize| if (5..15).contains(&i) { 20.0 } else { 0.9 };
    let filter = |i: usize| if (90..100).contains(&i) { 80.0 } else { 0.01 };
    let bright = |i: usize| 40.0 + 0.1 * i as f64;
    assert_eq!(scale("", &noisy), 1.0);
    assert_eq!(scale("", &filter), 0.01);
    assert_eq!(scale("", &bright), 0.01);
    assert_eq!(scale("", &|i| 10.0 * (100 + i) as f64), 1e-4);
    assert_eq!(scale("", &|i| 300.0 * (1 + i) as f64), 1.0 / 65_535.0);
    for (header, percent) in [
        ("Measurement humidity: 45 %\n", false),
        ("Unit serial 50%\n", false),
        ("unit: fraction\n", false),
        ("Y Units: %\n", true),
        ("Unit: %\n", true),
        ("Measurement: % Reflectance\n", true),
    ] {
        let found = scale(header, &|i| 0.2 + 0.001 * i as f64);
        assert_eq!(found, if percent { 0.01 } else { 1.0 }, "{header}");
    }
}

#[test]
fn a_line_says_that_wavelengths_are_in_vacuum_or_speaks_of_something_else() {
    let is_vacuum = |line: &str| {
        let text = format!("{line}\n\nnm\tW\n400\t1\n400.1\t2\n400.2\t3\n");
        has(&read("a.txt", text).spectra[0].notes, "in vacuum")
    };
    for line in [
        "Vacuum wavelengths",
        "All wavelengths are in vacuum.",
        "Wavelength (nm) in vacuum, measured in a chamber",
        "wavelength medium: vacuum",
        "Wavelength_vac (nm);Flux",
        "Wavelength (vacuum) nm\tFlux",
        "Wavelengths measured in vacuum",
        "Wellenlängen im Vakuum",
        "Vakuumwellenlänge",
    ] {
        assert!(is_vacuum(line), "{line}");
    }
    for line in [
        "Wavelength calibrated, lamp in a vacuum chamber",
        "wavelength scan measured in a vacuum chamber",
        "Wavelengths of a vacuum fluorescent display",
        "Wavelength (nm),Vacuum level",
        "Wavelength (nm),Vacuum",
        "Wavelength (nm),Vacuum wavelength (nm),Flux",
        "wavelengths in air, not in vacuum",
        "wavelengths in vacuum chamber",
        "Vacuum UV monochromator, wavelength 120 nm",
    ] {
        assert!(!is_vacuum(line), "{line}");
    }
}
