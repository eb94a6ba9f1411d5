//! UPRtek spectrometers (MK350, CV600, PG100N, ...): TAB text, often named `.xls`.

use crate::told::{assert_told, first, read, refusal};
use spectral_explorer::io::Quantity;
use spectral_explorer::io::Reading;
use spectral_explorer::spectrum::Kind;

const SMALL: &str = "Model Name\tMK350\nMemo\t\nLUX\t12.5\nCCT\t3000.0\nx\t0.44\nI-Time\t100\n\
                     CRI\t92.0\nR9\t50.5\nRf\t90\nIRR\t0.03\n380nm\t1.0\n390nm\t2.0\n400nm\t-0.5\n";

#[test]
fn photons_are_told_by_their_flux_in_the_range_of_photosynthesis() {
    let row = |i| format!("{}nm\t0.5\n", 380 + 10 * i);
    let rows: String = (0..=40).map(row).collect();
    let text = format!("Model Name\tMK350\nPPFD\t150.0\n{rows}");
    assert_eq!(first("a.xls", text).unit, "µmol m-2 s-1 nm-1");
}

#[test]
fn spectrum_unit_and_results_are_read() {
    let reading = read("a.xls", SMALL);
    assert_eq!(reading.format, "UPRtek");
    let spectrum = &reading.spectra[0];
    assert_eq!(spectrum.samples.values(), [1.0, 2.0, -0.5]);
    let told = (spectrum.kind, &*spectrum.unit);
    assert_eq!(told, (Kind::Light, "mW m-2 nm-1"));
    for (quantity, value) in [
        (Quantity::Cct, 3000.0),
        (Quantity::Ra, 92.0),
        (Quantity::R(9), 50.5),
        (Quantity::ChromaticityX, 0.44),
        (Quantity::Illuminance, 12.5),
    ] {
        let found = reading.results.iter().find(|r| r.quantity == quantity);
        assert_eq!(found.map(|r| r.value), Some(value), "{quantity}");
    }
    let mut written = reading.results.iter().map(|r| &r.as_written);
    assert!(!written.any(|result| result.starts_with("I-Time")));
}

#[test]
fn line_ends_marks_and_separators_do_not_matter() {
    let values = |r: &Reading| r.results.iter().map(|r| r.value).collect::<Vec<_>>();
    let want = read("a", SMALL);
    for text in [
        SMALL.replace('\n', "\r\n"),
        format!("\u{feff}{SMALL}"),
        SMALL.replace('.', ","),
        SMALL.replace('\t', ","),
        SMALL.replace('.', ",").replace('\t', ";"),
        SMALL.replace("nm\t", " nm\t"),
    ] {
        let reading = read("a", &text);
        assert_eq!(reading.format, "UPRtek", "{text}");
        let (is, was) = (&reading.spectra[0].samples, &want.spectra[0].samples);
        assert_eq!(is, was, "{text}");
        assert_eq!(values(&reading), values(&want));
    }
}

#[test]
fn the_total_tells_photons_from_energy() {
    let text = "Model Name\tPG100N\nPPFD\t30\n400nm\t1\n410nm\t2\n420nm\t1\nIRR\t99\n";
    let spectrum = first("a", text);
    assert_eq!(spectrum.unit, "µmol m-2 s-1 nm-1");
    assert_told(&spectrum.notes, "photons, not energy");
}

#[test]
fn a_file_without_points_and_a_word_in_one_are_refused() {
    assert_eq!(
        refusal("a.xls", "Model Name\tCV600\nI-Time\t5\nCCT\t5000\n"),
        "a.xls: found UPRtek's results and no spectrum, expected lines such as \"380nm\", TAB and a value"
    );
    assert_eq!(
        refusal(
            "a.xls",
            "Model Name\tCV600\nCCT\t5000\n380nm\t5\n381nm\t6\n382nm\tabc\n"
        ),
        "a.xls, line 5: found \"abc\", expected a number behind the wavelength"
    );
}
