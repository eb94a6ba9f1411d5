//! PerkinElmer PEDS ASCII: `#HDR`, `#GR` and `#DATA` behind some fixed header lines.

use crate::told::{first, refusal};
use spectral_explorer::spectrum::Kind;

#[test]
fn kind_and_scale_are_told_by_the_graphs_units() {
    let file = |first: &str, y: &str| {
        format!(
            "PE {first}   SPECTRUM    ASCII       PEDS   1.60\r\n -1\r\nx\r\n#HDR\r\n-1\r\n#GR\r\nNM\r\n{y}\r\n1.0\r\n#DATA\r\n500.0\t20.5  \r\n499.0\t10.5\r\n"
        )
    };
    for (instrument, y, kind, scale) in [
        ("FL", "", Kind::Light, 1.0),
        ("UV", "%T", Kind::Transmittance, 0.01),
        ("UV", "A", Kind::Absorbance, 1.0),
    ] {
        let spectrum = first("a.sp", file(instrument, y));
        assert_eq!((spectrum.kind, spectrum.scale), (kind, scale));
        assert_eq!(spectrum.samples.nm(), [499.0, 500.0]);
    }
    assert_eq!(
        refusal("a.sp", file("FL", "").replace("10.5", "x")),
        "a.sp, line 12: found \"x\", expected a wavelength and a value"
    );
}
