//! Writing IES TM-27 `.spdx`.

use super::every::awkward_spectrum;
use crate::told::first;
use spectral_explorer::{
    io::{Columns, Provenance, encode},
    spectrum::Kind,
};

#[test]
fn markup_in_names_is_escaped_and_what_xml_forbids_left_out() {
    let mut spectrum = awkward_spectrum(Kind::Light);
    spectrum.name = "a<b>&\u{1}\"c".to_owned();
    let text = encode(
        "spdx",
        &spectrum,
        &Columns::measured(&spectrum),
        &Provenance::default(),
    )
    .unwrap();
    let back = first("a.spdx", text);
    assert_eq!(back.name, "a<b>& \"c");
    assert_eq!(back.unit, "W m-2 nm-1");
}
