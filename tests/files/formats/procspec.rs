//! Ocean Optics ProcSpec: a zip archive of `ps_0.xml`, ... written by SpectraSuite's XML streams.

use crate::containers;
use crate::told::{first, refusal};
use zip::CompressionMethod;

fn zipped(members: &[(&str, &[u8])]) -> Vec<u8> {
    containers::zipped(members, CompressionMethod::Deflated)
}

const XML: &str = "<com.oceanoptics.omnidriver.spectra.OmniSpectrum>\n<sourceSpectra><pixelValues>\
    <double>10</double><double>20</double><double>30</double></pixelValues>\n\
    <channelWavelengths><double>400.1</double><double>400.5</double><double>400.9</double>\
    </channelWavelengths></sourceSpectra>\n<processedPixels><double>50.5</double>\
    <double>NaN</double><double>60.5</double></processedPixels>\n\
    </com.oceanoptics.omnidriver.spectra.OmniSpectrum>";

#[test]
fn processed_pixels_go_before_raw_ones() {
    let archive = zipped(&[("OOISignatures.xml", b"<a/>"), ("ps_0.xml", XML.as_bytes())]);
    assert_eq!(first("a.ProcSpec", archive).samples.nm(), [400.1, 400.9]);
    let raw = XML.replace("processedPixels", "other");
    let archive = zipped(&[("ps_0.xml", raw.as_bytes())]);
    let samples = first("a.zip", archive).samples;
    assert_eq!(samples.values(), [10.0, 20.0, 30.0]);
}

#[test]
fn what_does_not_fit_is_said() {
    let short = XML.replace("<double>60.5</double>", "");
    let said = refusal("a.ProcSpec", zipped(&[("ps_0.xml", short.as_bytes())]));
    assert!(said.contains("2 pixels for 3 wavelengths"), "{said}");
    let said = refusal("a.ProcSpec", zipped(&[("x", b"")]));
    assert!(said.contains("without ps_0.xml"), "{said}");
}
