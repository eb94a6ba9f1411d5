//! Spectra Vista (and GER) `.sig`: reference, target and their ratio in per cent.

use crate::told::{assert_told, names, read, refusal};
use spectral_explorer::spectrum::Kind;

const SMALL: &str = "/*** Spectra Vista SIG Data ***/\nname= leaf.sig\ninstrument= HI: 1\nunits= Radiance, Radiance\ndata= \n\
    400.0  100.0  10.0  10.00\n401.5  200.0  30.0  15.00\n403.0  200.0  40.0  20.00\n404.5 1 2 3\n406 1 2 3\n407 1 2 3\n408 1 2 3\n409 1 2 3\n410 1 2 3\n411 1 2 3\n412 1 2 3\n411.5 1 2 4\n413 1 2 3\n";

#[test]
fn the_reflectance_comes_first_and_the_others_follow() {
    for text in [
        SMALL.to_owned(),
        SMALL.replace('\n', "\r\n"),
        SMALL.replace("0  10", "0\t10"),
    ] {
        let reading = read("x.sig", text);
        assert_eq!(reading.format, "SVC .sig");
        let all = ["leaf", "leaf, reference", "leaf, target"];
        assert_eq!(names(&reading), all);
        let first = &reading.spectra[0];
        assert_eq!((first.kind, first.scale), (Kind::Reflectance, 0.01));
        assert_eq!(first.samples.values()[0], 0.1);
        assert_told(&first.notes, "step back");
    }
}

#[test]
fn rows_that_are_none_are_refused() {
    assert_eq!(
        refusal("x.sig", SMALL.replace("30.0", "abc")),
        "x.sig, line 7: found \"abc\", expected a number in column 3"
    );
    let short = refusal("x.sig", SMALL.replace("404.5 1 2 3", "404.5 1 2"));
    assert!(short.starts_with("x.sig, line 9: found 3 numbers"));
    let none = refusal("x.sig", "/*** Spectra Vista SIG Data ***/\ndata=\n");
    assert!(none.contains("no rows"));
}
