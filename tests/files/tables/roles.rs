//! Which columns of a table are spectra, and which are something beside them.

use crate::told::{assert_told, read};

/// The first value of each spectrum, as the file has it, in order.
fn firsts(text: &str) -> Vec<f64> {
    let spectra = read("a.csv", text).spectra;
    let first = |s: &spectral_explorer::spectrum::NamedSpectrum| {
        let value = s.samples.values()[0] / s.scale;
        (1e6 * value).round() / 1e6
    };
    spectra.iter().map(first).collect()
}

#[test]
fn columns_that_are_no_spectra_are_left_out() {
    for (text, values) in [
        // Raw counts beside a transmittance, and a dark reading beside a sample.
        (
            "Wave;Dark;Ref;Sample;Transmittance\n[nm];[counts];[counts];[counts];[%]\n300;1;9;5;50\n301;1;9;4;40\n",
            &[50.0][..],
        ),
        (
            "Wave;Dark;Reference;Sample\n[nm];[counts];[counts];[counts]\n300;1;9;5\n301;1;9;4\n",
            &[5.0],
        ),
        ("nm;Reference;Sample\n300;9;5\n301;9;4\n", &[9.0, 5.0]),
        // A ratio comes before the readings that it was made of.
        (
            "Wvl;Rad. (Ref.);Rad. (Target);Reflect. %\n350;1;9;50\n351;1;9;40\n",
            &[50.0, 1.0, 9.0],
        ),
        ("W;D;S;P\n300;1;5;4\n301;1;6;5\n", &[4.0]),
        ("W;S;P\n300;5;4\n301;6;5\n", &[4.0]),
        ("W;S\n300;5\n301;6\n", &[5.0]),
        (
            "Wavelength;Processed;Raw;Dark;Reference\n300;0.1;8;1;5\n301;0.2;9;1;5\n",
            &[0.1],
        ),
        ("Chan.#;Wvl;Refl\n0;350;0.5\n7;351;0.4\n", &[0.5]),
        ("Unit;nm\n300;1\n301;2\n", &[1.0]),
        ("250;0.51;-10\n251;0.52;-10\n252;0.6;-9\n", &[0.51]),
        ("250;1;-10\n251;2;-9\n252;3;-8\n", &[1.0, -10.0]),
        ("210;290;1\n210;291;2\n210;292;5\n", &[1.0]),
        // A letter in brackets is a sample's, but a unit behind the word for its quantity.
        (
            "nm;Illuminant (A);Illuminant (C)\n300;1;2\n301;2;3\n",
            &[1.0, 2.0],
        ),
        (
            "nm;Ink (c);Ink (y);Ink (k)\n300;1;2;3\n301;2;3;4\n",
            &[1.0, 2.0, 3.0],
        ),
        ("nm;Leaf (J);Leaf (K)\n300;1;2\n301;2;3\n", &[1.0, 2.0]),
        ("nm;A;Stage temp (C)\n300;1;20\n301;2;21\n", &[1.0]),
        ("nm;A;T (K)\n300;1;290\n301;2;291\n", &[1.0]),
        // Spreads, but not a name with their word in it.
        ("nm;T;Std.Dev.\n300;1;0.1\n301;2;0.1\n", &[1.0]),
        ("nm;leaf;FWHM;sd\n300;1;5;2\n301;2;5;1\n", &[1.0]),
        (
            "nm;Std A;Std D65;Other\n300;1;2;3\n301;2;3;4\n",
            &[1.0, 2.0, 3.0],
        ),
        ("nm;std\n300;1\n301;2\n", &[1.0]),
        ("nm;A;A std\n300;1;0.1\n301;2;0.1\n", &[1.0]),
        ("nm;A;Uncertainty (k=2)\n300;1;0.1\n301;2;0.1\n", &[1.0]),
        // Functions of the wavelength are no second axis, other units of it are.
        ("nm;V(lambda)\n300;1\n301;2\n", &[1.0]),
        ("nm;S(lambda);D65\n300;1;2\n301;2;3\n", &[1.0, 2.0]),
        ("nm;x;y\n300;.1;.2\n301;.2;.3\n", &[0.1, 0.2]),
        ("nm;A;cm-1\n300;1;33333\n301;2;33223\n", &[1.0]),
        (
            "nm;A;Wavenumber (cm-1);B\n400;1;25000;2\n500;2;20000;3\n",
            &[1.0, 2.0],
        ),
        ("nm;Wavenumber (cm-1);A\n400;900;1\n500;800;2\n", &[1.0]),
        ("nm;A;nm;B\n400;1;400;2\n500;2;500;3\n", &[1.0, 2.0]),
        (
            "nm;A;;nm;B\n380;1;;1000;2\n390;2;;1010;3\n400;3;;;\n",
            &[1.0, 2.0],
        ),
    ] {
        assert_eq!(firsts(text), values, "{text}");
    }
    let reading = read("a.csv", "250;0.51;-10\n251;0.52;-10\n252;0.6;-9\n");
    assert_told(
        &reading.notes,
        "column 3 holds whole numbers below zero throughout, a setting",
    );
}
