//! Raman spectrometers' text: the axis counts wave numbers from a laser line, not nanometres.

use crate::told::{read, refusal};
use spectral_explorer::io::{Choices, WavelengthUnit, read_bytes_as};

#[test]
fn shifts_from_a_known_laser_become_wavelengths() {
    let rows = "100.5\t10\n200.5\t20\n300.5\t30\n400.5\t40\n";
    let titles = "Raman shift (cm-1)\tIntensity\n";
    for (name, header) in [
        ("Neon_iR785_x.txt", ""),
        ("a.txt", &*format!("Laser wavelength: 785 nm\n{titles}")),
        (
            "a.txt",
            "#Laser=\t785.0\n#AxisType[1]=\tSpectr\n#AxisUnit[1]=\t1/cm\n",
        ),
        ("a.txt", "#Laser=\t785nm_edge\r\n#Raman shift\r\n"),
        // Its power is not its wavelength.
        (
            "a.txt",
            &format!("Laser power: 300 mW\nLaser wavelength: 785 nm\n{titles}"),
        ),
        ("a.txt", &format!("Laser: 300 mW, 785 nm\n{titles}")),
        ("a.txt", &format!("Laser power 300\nLaser 785\n{titles}")),
    ] {
        let ends = if header.contains('\r') { "\r\n" } else { "\n" };
        let text = format!("{header}{}", rows.replace('\n', ends));
        let reading = read(name, &text);
        assert_eq!(reading.format, "Raman text", "{text}");
        let want = 1e7 / (1e7 / 785.0 - 100.5);
        assert_eq!(reading.spectra[0].samples.first_nm(), want, "{text}");
        let mut chosen = reading.guesses.iter().map(|guess| &*guess.chosen);
        assert!(chosen.any(|chosen| chosen == "Raman shift from 785 nm"));
    }
}

#[test]
fn an_unknown_laser_is_refused_and_wavelengths_beside_are_taken() {
    assert_eq!(
        refusal("a.txt", "Raman shift\tCounts\n100\t1\n200\t2\n300\t3\n"),
        "a.txt: found Raman shifts (1/cm) from a laser that is not named, expected wavelengths, or the laser's wavelength in the header"
    );
    let both = "Wavelength (nm)\tRaman Shift\tCounts\n400\t1\t1\n500\t2\t2\n600\t3\t3\n";
    assert_eq!(read("a.txt", both).format, "plain columns");
}

#[test]
fn makers_headers_of_shifts_are_read_where_they_name_the_laser() {
    let rows = "200.5 10\n201.5 20\n202.5 15\n203.5 30\n";
    let rruff = "##NAMES=Stone\n##RRUFFID=R1\n";
    for (header, mark, laser) in [
        ("DATA TYPE,RAMAN SPECTRUM\nXUNITS,1/CM\nXYDATA\n", ",", None),
        (
            "[Data]\nXAxisUnit\tYAxisUnit\nrel. 1/cm\tCCD cts\n",
            "\t",
            None,
        ),
        (
            "#Acq. time (s):\t15\n#Range (cm-1):\t200 - 204\n",
            "\t",
            None,
        ),
        ("#Wave\t\t#Intensity\r\n", "\t", None),
        (rruff, ",", None),
        (
            &*format!("{rruff}##ORIENTATION=Laser parallel to c* (3 0 0)\n"),
            ",",
            None,
        ),
        (
            "#Range (cm-1):\t200 - 204\n#Laser:\t785\n",
            "\t",
            Some(785.0),
        ),
        (
            "#Range (cm-¹)=\t200...204\n#Laser=\t532nm\n",
            "\t",
            Some(532.0),
        ),
        (
            &format!(
                "{rruff}##ORIENTATION=Laser parallel to c* (300 0 0)\n\
                 ##FILETYPE=Raman Processed\n##RAMAN WAVELENGTH=514\n"
            ),
            ", ",
            Some(514.0),
        ),
        (
            "##NAME=Stone\n##RRUFFID=R1\n##LASER_WAVELENGTH=532\n",
            ",",
            Some(532.0),
        ),
    ] {
        let text = format!("{header}{}", rows.replace(' ', mark));
        let Some(laser) = laser else {
            let why = refusal("a.txt", &text);
            let unknown = "Raman shifts (1/cm) from a laser that is not named";
            assert!(why.contains(unknown), "{header}: {why}");
            continue;
        };
        let reading = read("a.txt", text);
        assert_eq!(reading.format, "Raman text", "{header}");
        let spectrum = &reading.spectra[0];
        let want: f64 = 1e7 / (1e7 / laser - 200.5);
        assert_eq!(spectrum.samples.first_nm(), want, "{header}");
        let is_rruff = header.starts_with("##");
        assert_eq!(spectrum.name, if is_rruff { "Stone" } else { "a" });
    }
    let named = "Stone__R1__Raman__532__0.txt";
    read(named, format!("{rruff}200.5, 1\n201.5, 3\n202.5, 2\n"));
}

#[test]
fn a_map_of_points_is_never_one_spectrum() {
    let text = "#X\t\t#Y\t\t#Wave\t\t#Intensity\n-1.5\t2\t302\t5\n-1.5\t2\t301\t6\n\
                -1.5\t2\t300\t7\n0\t2\t302\t8\n0\t2\t301\t8\n0\t2\t300\t7\n";
    let why = refusal("a.txt", text);
    assert!(why.contains("a Raman map or series of several points"));
}

#[test]
fn a_person_may_name_the_laser_or_say_that_they_are_wavelengths() {
    let text = b"#Wave\t\t#Intensity\n802.5\t5\n801.5\t6\n800.5\t7\n799.5\t9\n";
    let mut choices = Choices {
        laser_nm: Some(532.0),
        ..Choices::default()
    };
    let reading = read_bytes_as("a.txt", text, &choices).unwrap();
    let first = reading.spectra[0].samples.first_nm();
    assert_eq!(first, 1e7 / (1e7 / 532.0 - 799.5));
    choices.laser_nm = None;
    choices.wavelengths = Some(WavelengthUnit::Nanometre);
    let reading = read_bytes_as("a.txt", text, &choices).unwrap();
    assert_eq!(reading.spectra[0].samples.first_nm(), 799.5);
}

#[test]
fn light_on_the_other_side_of_the_laser_has_shifts_below_zero() {
    for first in [-200.5, 0.0] {
        let rows: String = (0..6_u8)
            .map(|i| format!("{}\t{}\n", first + 50.0 * f64::from(i), 10 + i % 3))
            .collect();
        let text = format!("Laser: 785 nm\nRaman shift (1/cm)\tCounts\n{rows}");
        let samples = &read("a.txt", text).spectra[0].samples;
        assert_eq!(samples.len(), 6);
        assert!((samples.first_nm() - 1e7 / (1e7 / 785.0 - first)).abs() < 1e-9);
    }
}
