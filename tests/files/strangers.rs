//! Forms that files of other people have: what each must be read as, by small files of that form.

use spectral_explorer::{
    io::{Reading, read_bytes},
    spectrum::Kind,
};

fn read(name: &str, text: &str) -> Reading {
    read_bytes(name, text.as_bytes()).unwrap_or_else(|why| panic!("{name}: {why}"))
}

/// Name, kind, first and last wavelength and number of points of each spectrum.
fn told(reading: &Reading) -> Vec<(&str, Kind, [f64; 2], usize)> {
    let spectra = reading.spectra.iter();
    spectra
        .map(|s| {
            let ends = [s.samples.first_nm(), s.samples.last_nm()];
            (&*s.name, s.kind, ends, s.samples.len())
        })
        .collect()
}

fn has(reading: &Reading, note: &str) -> bool {
    reading.notes.iter().any(|n| n == note)
}

#[test]
fn a_short_row_near_the_top_costs_neither_rows_nor_titles() {
    for short in ["401,1.01", "401,1.01,", "401"] {
        let text = format!(
            "Wavelength (nm),Irradiance (W/m2/nm),Reflectance (%)\n400,1.00,50\n{short}\n\
             402,1.02,52\n403,1.03,53\n404,1.04,54\n"
        );
        let reading = read("a.csv", &text);
        let [light, surface] = &told(&reading)[..] else {
            panic!("{reading:?}");
        };
        assert_eq!((light.1, light.2), (Kind::Light, [400.0, 404.0]), "{short}");
        assert_eq!(
            (surface.1, surface.2, surface.3),
            (Kind::Reflectance, [400.0, 404.0], 4),
            "{short}"
        );
        assert_eq!(reading.spectra[1].samples.values()[0], 0.5);
    }
}

#[test]
fn a_row_with_a_cell_too_many_near_the_top_is_left_out_alone() {
    let reading = read(
        "a.csv",
        "Wavelength (nm),Irradiance\n400,1\n410,2,bad\n420,3\n430,4\n",
    );
    assert_eq!(told(&reading)[0].2, [400.0, 430.0]);
    assert!(has(
        &reading,
        "line 3 is no row of the table and was left out"
    ));
    // A range above the titles is no row, though it would carry on.
    let reading = read("a.csv", "399,450\nnm,W\n400,1\n401,2\n402,3\n");
    assert_eq!(told(&reading)[0].2, [400.0, 402.0]);
}

#[test]
fn a_row_that_was_taken_out_by_a_mark_is_no_row_wherever_it_stands() {
    for (text, ends, count) in [
        (
            "nm,W\n# 370,9\n380,1\n390,2\n400,3\n410,4\n# 420,9\n",
            [380.0, 410.0],
            4,
        ),
        (
            "nm,W\n#400,9\n401\n402,1\n403,2\n404,3\n",
            [402.0, 404.0],
            3,
        ),
        ("nm,W\n# 370,bad\n380,1\n390,2\n400,3\n", [380.0, 400.0], 3),
        (
            "nm,W\n380,1\n390,2\n400,3\n410,4\n# 420,9\nnext\n430,5\n440,6\n450,7\n",
            [380.0, 450.0],
            7,
        ),
        (
            "nm,W\n400,1\n# a remark\n401\n402,3\n403,4\n",
            [400.0, 403.0],
            3,
        ),
    ] {
        let reading = read("a.csv", text);
        assert_eq!(
            (told(&reading)[0].2, told(&reading)[0].3),
            (ends, count),
            "{text}"
        );
    }
}

#[test]
fn two_columns_of_words_tell_spectra_apart_together() {
    let reading = read(
        "a.csv",
        "tissue,source,wavelength,absorbance\nblood A,X,400,0.1\nblood A,X,500,0.2\n\
         blood B,X,450,0.9\nblood B,X,550,0.8\nfat,Y,400,0.5\nfat,Y,500,0.5\nfat,Z,450,0.6\n\
         fat,Z,550,0.7\n",
    );
    let names: Vec<&str> = told(&reading).iter().map(|one| one.0).collect();
    assert_eq!(names, ["blood A, X", "blood B, X", "fat, Y", "fat, Z"]);
    let note = "column 1 (tissue) and column 2 (source) tell the spectra apart";
    assert!(has(&reading, note), "{:?}", reading.notes);
}

#[test]
fn a_list_of_single_points_is_no_spectrum() {
    let text = "Name,Wavelength,Cross_Section\ndye A,1050,200\ndye B,800,200\ndye C,1100,150\n\
                dye D,900,100\ndye E,1050,90\n";
    let why = read_bytes("a.csv", text.as_bytes())
        .unwrap_err()
        .to_string();
    assert!(
        why.contains("another name in every row (column 1 (Name))"),
        "{why}"
    );
}

#[test]
fn what_is_titled_a_time_or_a_current_is_no_wavelength() {
    let lines = |value: &dyn Fn(i32) -> String| (0..4).map(|i| value(i) + "\n").collect::<String>();
    let text = "hour,wavelength_nm,value\n".to_owned()
        + &lines(&|i| format!("{},450,{}", 8 + i, 0.8 * f64::from(i + 1)));
    let why = read_bytes("a.csv", text.as_bytes())
        .unwrap_err()
        .to_string();
    assert!(why.contains("numbers with no wavelengths"), "{why}");
    let text = "current_mA,peak_wavelength_nm,flux\n".to_owned()
        + &lines(&|i| format!("{},{},0.{}", 350 + 100 * i, 450 + i, 8 - i));
    let reading = read("a.csv", &text);
    assert!(
        told(&reading).iter().all(|one| one.2 == [450.0, 453.0]),
        "{reading:?}"
    );
}

#[test]
fn what_was_noted_beside_the_values_is_no_spectrum_and_moves_no_scale() {
    for beside in ["temperature", "Time (s)", "timestamp", "humidity"] {
        let text = format!(
            "wavelength,transmittance,{beside}\n400,0.1,25.1\n410,0.2,25.2\n420,0.3,25.1\n"
        );
        let reading = read("a.csv", &text);
        assert_eq!(reading.spectra.len(), 1, "{beside}");
        assert_eq!(reading.spectra[0].samples.values(), [0.1, 0.2, 0.3]);
        let note = format!("column 3 ({beside}) is no spectrum by its title and was left out");
        assert!(has(&reading, &note), "{:?}", reading.notes);
    }
    // Several days are what spectra are called by, and alone a value is a value.
    let days = read("a.csv", "nm,day A,day B\n400,1,2\n410,2,3\n420,3,4\n");
    assert_eq!(days.spectra.len(), 2);
    let alone = read("a.csv", "nm,integration time\n400,1\n410,2\n420,3\n");
    assert_eq!(alone.spectra.len(), 1);
}

#[test]
fn titles_that_are_one_too_few_name_no_column() {
    for text in [
        "nm   riboflavin folic acid   retinol\n700  0.769  0.007  0.068\n720  0.667  0.006  0.042\n",
        "nm,A B,C\n700,0.769,0.007,0.068\n720,0.667,0.006,0.042\n",
    ] {
        let reading = read("a.txt", text);
        let names: Vec<&str> = told(&reading).iter().map(|one| one.0).collect();
        assert_eq!(names, ["a, column 2", "a, column 3", "a, column 4"]);
    }
}

#[test]
fn pairs_of_columns_keep_the_names_above_them_whatever_was_measured() {
    let reading = read(
        "a.csv",
        "S1,,S2,\nWavelength (nm),Abs,Wavelength (nm),%T\n500,0.10,400,80\n510,0.20,410,70\n",
    );
    let told = told(&reading);
    assert_eq!((told[0].0, told[0].1), ("S1", Kind::Absorbance));
    assert_eq!((told[1].0, told[1].1), ("S2", Kind::Transmittance));
}

#[test]
fn keys_that_tell_of_each_column_tell_of_that_one_alone() {
    let rows = "300\t0.10\t301\n299\t0.11\t302\n298\t0.12\t303\n";
    let head = "XUNITS\tNANOMETERS\nYUNITS\tABSORBANCE\nY2UNITS\tHT[V]\nXYDATA\n";
    let reading = read("a.txt", &(head.to_owned() + rows));
    let told = told(&reading);
    assert_eq!((told[0].0, told[0].1), ("ABSORBANCE", Kind::Absorbance));
    assert_eq!((told[1].0, told[1].1), ("HT[V]", Kind::Light));
    assert!(reading.is_doubtful(), "what a voltage is has to be asked");
}

#[test]
fn kelvin_in_a_files_name_are_no_extinction() {
    let rows = "380\t0.1\n580\t0.4\n780\t0.2\n";
    for name in ["LED_4000K.txt", "halogen-3200k.txt"] {
        assert_eq!(told(&read(name, rows))[0].1, Kind::Light, "{name}");
    }
    assert_eq!(told(&read("Au.k.txt", rows))[0].1, Kind::Other);
}

#[test]
fn instruments_words_for_absorbance_are_known() {
    for (units, kind) in [("A", Kind::Absorbance), ("T", Kind::Transmittance)] {
        let text = format!(
            "##TITLE=x\n##JCAMP-DX=4.24\n##DATA TYPE=UV/VIS SPECTRUM\n##XUNITS=NANOMETERS\n\
             ##YUNITS={units}\n##FIRSTX=400\n##LASTX=430\n##NPOINTS=4\n##XFACTOR=1\n##YFACTOR=1\n\
             ##XYDATA=(X++(Y..Y))\n400 0.1 0.2 0.3 0.4\n##END=\n"
        );
        assert_eq!(told(&read("a.jdx", &text))[0].1, kind, "{units}");
    }
}

#[test]
fn one_bad_object_of_a_cxf_file_is_left_out_and_said() {
    let object = |name: &str, inner: &str| {
        format!("<Object Name=\"{name}\"><ColorValues>{inner}</ColorValues></Object>")
    };
    let good =
        "<ReflectanceSpectrum StartWL=\"400\" Increment=\"10\">0.1 0.2 0.3</ReflectanceSpectrum>";
    let one = "<ReflectanceSpectrum StartWL=\"400\" Increment=\"10\">0.5</ReflectanceSpectrum>";
    let own = "<CustomSpectrum><SpectralPoint WL=\"400\">.4</SpectralPoint></CustomSpectrum>";
    let text = format!(
        "<CxF xmlns=\"http://colorexchangeformat.com/CxF3-core\">{}{}{}</CxF>",
        object("a", good),
        object("b", one),
        object("c", own)
    );
    let reading = read("a.cxf", &text);
    assert_eq!(told(&reading).len(), 1);
    assert!(has(
        &reading,
        "b: 1 value, too few for a spectrum: left out"
    ));
    assert!(
        reading
            .notes
            .iter()
            .any(|note| note.starts_with("c: a CustomSpectrum"))
    );
}

#[test]
fn a_models_name_alone_makes_no_meter_of_a_known_maker() {
    let text = "Model Name, AS7265x\nDUT, a phone\n410nm,8.4\n435nm,3.2\n460nm,22.1\n485nm,4.5\n";
    let sensor = read("a.csv", text);
    assert_eq!(
        (
            sensor.spectra[0].unit.as_str(),
            sensor.spectra[0].samples.len()
        ),
        ("", 4)
    );
    let why = read_bytes("a.csv", (text.to_owned() + "510nm,abc\n").as_bytes()).unwrap_err();
    assert!(why.to_string().contains("line 7: found \"abc\""), "{why}");
    // Values over the largest are in no unit, though the meter's own is known.
    let text = "Model Name,GS1160\nLambdaP,460\nLambdaPValue,4.165\n440nm,0.5\n450nm,0.8\n460nm,1\n\
                470nm,0.7\n";
    let relative = read("a.csv", text);
    assert_eq!(relative.spectra[0].unit, "");
}

#[test]
fn points_of_several_samples_in_json_are_several_spectra() {
    let point = |of: &str, nm: u32, value: f64| {
        format!("{{{of},\"wavelength_nm\":{nm},\"absorbance\":{value}}}")
    };
    for (a, b, names) in [
        ("\"sample\":\"A\"", "\"sample\":\"B\"", ["A", "B"]),
        ("\"time\":0", "\"time\":1", ["time 0", "time 1"]),
    ] {
        let points = [
            point(a, 400, 0.1),
            point(a, 410, 0.2),
            point(b, 400, 0.5),
            point(b, 410, 0.6),
        ];
        let reading = read("a.json", &format!("[{}]", points.join(",")));
        let told = told(&reading);
        let found: Vec<&str> = told.iter().map(|one| one.0).collect();
        assert_eq!(found, names);
        assert!(
            told.iter()
                .all(|one| one.1 == Kind::Absorbance && one.3 == 2)
        );
        assert_eq!(reading.spectra[1].samples.values(), [0.5, 0.6]);
    }
}

#[test]
fn the_key_over_wavelengths_as_keys_says_what_was_measured() {
    let text = "{\"unit\":\"%\",\"reflectance\":{\"400\":12,\"500\":13,\"600\":14}}";
    let reading = read("a.json", text);
    assert_eq!(told(&reading)[0].1, Kind::Reflectance);
    assert_eq!(reading.spectra[0].samples.values()[0], 0.12);
}

#[test]
fn two_bands_of_the_standards_name_are_a_spectrum() {
    let text = "SPECT\n\nDESCRIPTOR \"Spectral Power\"\nSPECTRAL_BANDS \"2\"\n\
                SPECTRAL_START_NM \"350\"\nSPECTRAL_END_NM \"740\"\nNUMBER_OF_FIELDS 2\n\
                BEGIN_DATA_FORMAT\nSPEC_350 SPEC_740\nEND_DATA_FORMAT\nNUMBER_OF_SETS 1\nBEGIN_DATA\n\
                0.01 1.00\nEND_DATA\n";
    assert_eq!(told(&read("a.sp", text))[0].2, [350.0, 740.0]);
}

#[test]
fn factors_of_tm_27_are_reflectance_and_transmittance() {
    for (word, kind) in [
        ("R-Factor", Kind::Reflectance),
        ("T-Factor", Kind::Transmittance),
    ] {
        let text = format!(
            "<IESTM2714 xmlns=\"http://www.ies.org/iestm2714\"><Header><Description>d</Description>\
             </Header><SpectralDistribution><SpectralQuantity>{word}</SpectralQuantity>\
             <SpectralData wavelength=\"400\">0.1</SpectralData>\
             <SpectralData wavelength=\"410\">0.2</SpectralData></SpectralDistribution></IESTM2714>"
        );
        assert_eq!(told(&read("a.spdx", &text))[0].1, kind, "{word}");
    }
}

#[test]
fn a_spectrometer_s_counts_do_not_take_the_unit_of_the_column_beside_them() {
    // Header and first rows of `Ne_532nm_x50_25ms.txt` of ramanchada2 (PyPI, MIT).
    let reading = read(
        "Ne_532nm_x50_25ms.txt",
        "File Version;BWSpec4.11_1\nintigration times(ms);25\nirradiance_unit;0\n\
         Pixel;Wavelength;Wavenumber;Raman Shift;Dark;Reference;Raw data #1;Dark Subtracted #1;\
         %TR #1;Absorbance #1;Irradiance (W/cm^2/nm) #1;\n\
         0;530,77;18840,39;-48,35;980,0000;65535,0000;929,0000;-51,0000;0,0000;0,0000;0,0000;\n\
         1;530,86;18837,33;-45,28;1006,0000;65535,0000;974,0000;-32,0000;0,0000;0,0000;0,0000;\n\
         2;530,95;18834,27;-42,22;981,0000;65535,0000;994,0000;13,0000;0,0000;0,0000;0,0000;\n\
         3;531,03;18831,20;-39,16;1036,0000;65535,0000;986,0000;-50,0000;0,0000;0,0000;0,0000;\n",
    );
    let found = reading.spectra.iter().map(|s| (s.kind, &*s.unit));
    assert_eq!(
        found.collect::<Vec<_>>(),
        [
            (Kind::Light, "counts"),
            (Kind::Transmittance, "fraction"),
            (Kind::Absorbance, ""),
            (Kind::Light, "W/cm^2/nm")
        ]
    );
    assert_eq!(
        reading.spectra[0].samples.values(),
        [-51.0, -32.0, 13.0, -50.0]
    );
}

#[test]
fn a_wasatch_text_says_its_technique_and_a_filter_s_two_readings_are_two() {
    // Header and first rows of `wasatch-enlighten-transmission.csv` of photobiologyInOut (GPL).
    let reading = read(
        "wasatch-enlighten-transmission.csv",
        "ENLIGHTEN Version,2.2.7\nModel,WP-UV-VIS-C-S-25\nTechnique,Transmission\n\
         Raman Intensity Corrected,False\nLaser Wavelength,0.0\nLaser Enable,False\n\
         Pixel Count,1024\n\nPixel,Wavelength,Processed,Raw,Dark,Reference\n\
         0,247.94,24.00000,835.00000,823.00000,50.00000\n\
         1,248.45,54.00000,850.00000,823.00000,50.00000\n\
         2,248.96,76.08696,858.00000,823.00000,46.00000\n",
    );
    assert_eq!(
        told(&reading),
        [(
            "wasatch-enlighten-transmission",
            Kind::Transmittance,
            [247.94, 248.96],
            3
        )]
    );
    assert_eq!(reading.spectra[0].samples.values()[0], 0.24);
    // Titles of `Canary_Supergel312.txt`, a gel of Rosco measured twice.
    let reading = read(
        "Canary_Supergel312.txt",
        "w.length.1\ttransmittance.1\tw.length.2\ttransmittance.2\n\
         190\t0.4\t190\t0.5\n191\t30\t191\t31\n192\t87.1\t192\t88\n",
    );
    let ends = [190.0, 192.0];
    assert_eq!(
        told(&reading),
        [
            ("transmittance.1", Kind::Transmittance, ends, 3),
            ("transmittance.2", Kind::Transmittance, ends, 3)
        ]
    );
    assert_eq!(reading.spectra[1].samples.values()[2], 0.88);
}

#[test]
fn json_says_what_is_noted_beside_the_points_and_reads_the_rest() {
    let reading = read(
        "a.json",
        r#"{"wavelengths":[380,390,400],"irradiance":[1,2,3],"uncertainty":[0.1,0.1,0.2],
            "temperature":[25,25,26]}"#,
    );
    assert_eq!(told(&reading), [("a", Kind::Light, [380.0, 400.0], 3)]);
    assert!(has(
        &reading,
        "\"uncertainty\" is a spread and was left out"
    ));
    assert!(has(
        &reading,
        "\"temperature\" is no spectrum by its title and was left out"
    ));
    // In whatever order the keys stand.
    for beside in [
        r#""temperature":[25,25,26],"irradiance":[1,2,3],"uncertainty":[0.1,0.1,0.2]"#,
        r#""temperature":[25,25,26],"uncertainty":[0.1,0.1,0.2],"irradiance":[1,2,3]"#,
        r#""uncertainty":[0.1,0.1,0.2],"temperature":[25,25,26],"irradiance":[1,2,3]"#,
        r#""irradiance":[1,2,3],"temperature":[25,25,26],"uncertainty":[0.1,0.1,0.2]"#,
    ] {
        let reading = read(
            "a.json",
            &format!(r#"{{"wavelengths":[380,390,400],{beside}}}"#),
        );
        assert_eq!(
            told(&reading),
            [("a", Kind::Light, [380.0, 400.0], 3)],
            "{beside}"
        );
        assert_eq!(
            reading.spectra[0].samples.values(),
            [1.0, 2.0, 3.0],
            "{beside}"
        );
        let said = |note: &&String| note.ends_with("was left out");
        assert_eq!(reading.notes.iter().filter(said).count(), 2, "{beside}");
    }
    // Alone it is what the file is about.
    let reading = read(
        "a.json",
        r#"[{"wavelength":380,"temperature":1},{"wavelength":390,"temperature":2}]"#,
    );
    assert_eq!(reading.spectra[0].samples.values(), [1.0, 2.0]);
}

#[test]
fn a_second_table_of_two_bands_goes_on_with_the_bands_that_the_first_states() {
    let table = |head: &str, first: f64| {
        format!(
            "{head}BEGIN_DATA_FORMAT\nSAMPLE_ID SPEC_400 SPEC_700\nEND_DATA_FORMAT\n\
             BEGIN_DATA\n1 {first} 0.5\nEND_DATA\n"
        )
    };
    let stated = "CGATS.17\nSPECTRAL_BANDS \"2\"\nSPECTRAL_START_NM \"400\"\n\
                  SPECTRAL_END_NM \"700\"\n";
    let reading = read(
        "a.txt",
        &format!("{}{}", table(stated, 0.25), table("CGATS.17\n", 0.75)),
    );
    let firsts: Vec<f64> = reading
        .spectra
        .iter()
        .map(|s| s.samples.values()[0])
        .collect();
    assert_eq!(firsts, [0.25, 0.75]);
}
