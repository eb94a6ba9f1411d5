//! What titles, header lines and a file's name tell of the values, and of a column's name.

use crate::told::{assert_told, first, names, read};
use spectral_explorer::spectrum::Kind;

/// The kind of a column under a title, in a file of this name.
fn kind(file: &str, title: &str) -> Kind {
    first(file, format!("nm;{title}\n380;0.1\n390;0.5\n400;0.2\n")).kind
}

#[test]
fn titles_tell_the_kind_by_whole_words() {
    for (title, of) in [
        ("R(adaxial)", Kind::Reflectance),
        ("T(abaxial)", Kind::Transmittance),
        ("Reflect. [1.0]", Kind::Reflectance),
        ("TotalReflectance", Kind::Reflectance),
        ("Rpc", Kind::Reflectance),
        ("Tfr", Kind::Transmittance),
        ("%T", Kind::Transmittance),
        ("%TR #1", Kind::Transmittance),
        ("irradiance [W m-2 nm-1]", Kind::Light),
        ("tropical lamp (W/m2/nm)", Kind::Light),
        ("Bestrahlungsstärke in W/(m²·nm)", Kind::Light),
        ("s.e.irrad", Kind::Light),
        ("Dark Subtracted #1", Kind::Light),
        ("x_bar", Kind::Weighting),
        ("s.e.response", Kind::Weighting),
        ("melanopic", Kind::Weighting),
        ("s-cone-opic", Kind::Weighting),
        ("V(lambda)", Kind::Weighting),
        ("Absorbanz", Kind::Absorbance),
        ("n", Kind::Other),
        ("Logarithm epsilon", Kind::Other),
    ] {
        assert_eq!(kind("a.csv", title), of, "{title}");
        assert!(
            !read("a.csv", format!("nm;{title}\n380;5\n390;7\n"))
                .spectra
                .is_empty()
        );
    }
    // Inside of other words they tell nothing: a light is a guess then.
    for title in [
        "Spectroscopic",
        "topic LED",
        "isotropic",
        "mV(lamp)",
        "TL01",
        "red",
    ] {
        let reading = read("a.csv", format!("nm;{title}\n380;5\n390;7\n"));
        assert_eq!(reading.spectra[0].kind, Kind::Light, "{title}");
        assert_told(&reading.spectra[0].notes, "nothing states it");
    }
}

#[test]
fn a_file_s_name_tells_the_kind_by_whole_words_of_several_by_the_last() {
    for name in [
        "tropical_fruit.csv",
        "peeled.csv",
        "delight.csv",
        "unfiltered.csv",
        "k.csv",
    ] {
        let spectrum = first(name, "nm;a\n380;5\n390;7\n");
        assert_told(&spectrum.notes, "nothing states it");
    }
    for (name, of) in [
        ("red_led_5.csv", Kind::Light),
        ("LEDWhitesPlusCanaryYellow.txt", Kind::Light),
        ("unfiltered_lamp.csv", Kind::Light),
        ("xyz_lamp.csv", Kind::Light),
        ("lampFilter.csv", Kind::Transmittance),
        ("ciexyz31.csv", Kind::Weighting),
        ("lin2012xyz2e_1_7sf.csv", Kind::Weighting),
        ("macbeth-1.txt", Kind::Reflectance),
        ("FMNH6834.Master.Transmission", Kind::Transmittance),
    ] {
        assert_eq!(kind(name, "a"), of, "{name}");
    }
    assert_eq!(kind("x.txt", "a.asd"), Kind::Reflectance);
    assert_eq!(kind("irrad.txt", "a.asd"), Kind::Light);
}

#[test]
fn the_line_of_the_y_axis_and_the_technique_outweigh_the_rest_of_the_header() {
    for (lines, of) in [
        (
            "Y Units: Reflectance (percent)\nirradiance of the sample",
            Kind::Reflectance,
        ),
        (
            "Raman Intensity Corrected,False\nTechnique,Transmission",
            Kind::Transmittance,
        ),
        (
            "Technique,Transmission\nRaman Intensity Corrected,False",
            Kind::Transmittance,
        ),
    ] {
        let spectrum = first("a.txt", format!("{lines}\n380 50\n390 60\n400 70\n"));
        assert_eq!(spectrum.kind, of, "{lines}");
    }
}

#[test]
fn titles_stand_above_a_line_of_units_and_settings_are_none() {
    // Several columns have their titles.
    for (text, called) in [
        (
            "Wave ;Lamp ;Sun \n[nm] ;[counts] ;[counts] \n\n300;3;4\n301;2;5\n302;2;6\n",
            ["Lamp", "Sun"],
        ),
        (
            "Wave length   Value of it   Value of that\n380 0.5 0.7\n385 0.6 0.8\n",
            ["Value of it", "Value of that"],
        ),
    ] {
        assert_eq!(names(&read("a.csv", text)), called, "{text}");
    }
    // The only one is called after the file.
    for (text, called) in [
        ("Wave ;Lamp \n[nm] ;[counts] \n\n300;3\n301;2\n302;2\n", "a"),
        ("nm lamp\n1 380 0.5\n2 385 0.6\n3 390 0.7\n", "a"),
        ("Wave length   Value of it\n380 0.5\n385 0.6\n", "a"),
        ("I-Time,92.0\n380nm,1\n381nm,2\n", "a"),
        ("Remarks:, none\n380nm,1\n381nm,2\n", "a"),
        ("\"Time: 130msec\"\n380 1\n381 2\n", "a"),
        ("Serial: X1\n380 1\n381 2\n", "a"),
    ] {
        assert_eq!(names(&read("a.csv", text)), [called], "{text}");
    }
    let text = "Irradiance [uW],\nIndex,13,14,\nName,,,\n[nm],\n327.1,3.7,3.8\n329,3.5,3.6\n";
    assert_eq!(names(&read("a.csv", text)), ["Index 13", "Index 14"]);
    let unit = first(
        "a.csv",
        "Wavelength;Irradiance\nnm;W/m^2/nm\n300;3\n301;2\n",
    )
    .unit;
    assert_eq!(unit, "W/m^2/nm");
}
