//! CxF3, the Color Exchange Format (ISO 17972): XML with measured colours.

use crate::told::{read, refusal};
use spectral_explorer::spectrum::Kind;

const XML: &str = "<?xml version=\"1.0\"?>\n<cc:CxF xmlns:cc=\"http://colorexchangeformat.com/CxF3-core\">\n\
    <cc:Resources><cc:ObjectCollection>\n<cc:Object Name=\"Sky\" Id=\"c1\"><cc:ColorValues>\n\
    <cc:ReflectanceSpectrum ColorSpecification=\"CS1\" StartWL=\"400\">0.1 0.2\n0.3</cc:ReflectanceSpectrum>\n\
    </cc:ColorValues></cc:Object>\n<cc:Object Name=\"Lamp\"><cc:ColorValues>\n\
    <cc:EmissiveSpectrum ColorSpecification=\"CS2\">5 6</cc:EmissiveSpectrum>\n\
    </cc:ColorValues></cc:Object></cc:ObjectCollection>\n<cc:ColorSpecificationCollection>\n\
    <cc:ColorSpecification Id=\"CS2\"><cc:MeasurementSpec><cc:WavelengthRange StartWL=\"380\" Increment=\"5\"/>\n\
    </cc:MeasurementSpec></cc:ColorSpecification></cc:ColorSpecificationCollection></cc:Resources></cc:CxF>";

#[test]
fn spectra_take_their_grid_from_themselves_or_their_specification() {
    let [sky, lamp] = &read("a.cxf", XML).spectra[..] else {
        panic!("two spectra");
    };
    assert_eq!(sky.samples.nm(), [400.0, 410.0, 420.0]);
    assert_eq!(sky.kind, Kind::Reflectance);
    assert_eq!(lamp.samples.nm(), [380.0, 385.0]);
    assert_eq!((&*lamp.name, lamp.kind), ("Lamp", Kind::Light));
}

#[test]
fn what_is_missing_or_wrong_is_said_by_its_line() {
    let said = |text: &str| refusal("a.cxf", text);
    let without = said(&XML.replace(" StartWL=\"400\"", ""));
    assert!(without.contains("line 5: found <ReflectanceSpectrum> without"));
    assert!(said(&XML.replace("0.2", "much")).contains("line 5: found \"much\""));
    assert!(said(&XML.replace("Spectrum", "Lab")).contains("a CxF file without spectra"));
    let crowded = format!("<CxF {}/>", "a='1' ".repeat(300));
    assert!(said(&crowded).contains("hundreds of attributes"));
}
