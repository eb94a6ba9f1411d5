//! GDTF, the General Device Type Format of stage lights.

use crate::containers::zipped;
use crate::told::{read, refusal};
use spectral_explorer::spectrum::Kind;
use zip::CompressionMethod;

const XML: &str = "<?xml version=\"1.0\"?>\n<GDTF DataVersion=\"1.1\">\n\
    <FixtureType Name=\"Spot\">\n<Wheels><Wheel><Slot Name=\"Warm\" Filter=\"CTO\"/></Wheel></Wheels>\n\
    <Emitters><Emitter Name=\"Red\">\n<Measurement Physical=\"100\">\n\
    <MeasurementPoint WaveLength=\"600\" Energy=\"0.5\"/>\n\
    <MeasurementPoint WaveLength=\"610.5\" Energy=\"1\"/></Measurement>\n\
    <Measurement Physical=\"50\"><MeasurementPoint WaveLength=\"600\" Energy=\"0.2\"/>\n\
    <MeasurementPoint WaveLength=\"610\" Energy=\"0.4\"/></Measurement></Emitter>\n\
    <Emitter Name=\"Blue\"/></Emitters>\n<Filters><Filter Name=\"CTO\"><Measurement Physical=\"1\">\n\
    <MeasurementPoint WaveLength=\"500\" Energy=\"20\"/>\n\
    <MeasurementPoint WaveLength=\"600\" Energy=\"80\"/></Measurement></Filter></Filters>\n\
    </FixtureType></GDTF>";

fn fixture(xml: &str) -> Vec<u8> {
    zipped(
        &[("thumbnail.png", b"x"), ("description.xml", xml.as_bytes())],
        CompressionMethod::Deflated,
    )
}

#[test]
fn emitters_and_filters_give_a_spectrum_a_measurement() {
    let reading = read("a.gdtf", fixture(XML));
    let names: Vec<_> = reading.spectra.iter().map(|s| &*s.name).collect();
    assert_eq!(
        names,
        ["Spot Red, dimmer 100", "Spot Red, dimmer 50", "Spot CTO"]
    );
    assert_eq!(reading.spectra[0].samples.nm(), [600.0, 610.5]);
    let filter = &reading.spectra[2];
    assert_eq!((filter.kind, filter.scale), (Kind::Transmittance, 0.01));
    assert!(filter.notes.iter().any(|n| n == "in the wheel as Warm"));
    assert!(reading.notes.iter().any(|n| n.starts_with("1 emitters")));
}

#[test]
fn a_fixture_without_spectra_and_a_wrong_number_are_said() {
    let said = |xml: &str| refusal("a.gdtf", fixture(xml));
    assert!(said("<GDTF/>").contains("without measurements"));
    let wrong = said(&XML.replace("\"0.5\"", "\"much\""));
    assert_eq!(
        wrong,
        "a.gdtf, line 7: found \"much\", expected a number as Energy=\"...\""
    );
    assert!(said("<!DOCTYPE a [<!ENTITY b \"b\">]><GDTF>&b;</GDTF>").contains("with a DTD"));
}

#[test]
fn a_bomb_is_refused_by_what_comes_out_of_it() {
    // A fifth of 512 MiB may come out of it.
    let bomb = fixture(&" ".repeat(128 << 20));
    assert!(bomb.len() < 1 << 20);
    let said = refusal("a.gdtf", bomb);
    assert!(said.contains("unfolds to far more than its size"), "{said}");
}
