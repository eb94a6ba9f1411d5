//! Sekonic spectrometers (C-700, C-800, C-7000): CSV of one key and one value a line.

use crate::told::{assert_told, first, read, refusal};
use spectral_explorer::io::Quantity;

fn text() -> String {
    let mut text = "Date Saved,1/1/2020\nTitle,Desk 2°\n\nMeasuring Mode,Ambient\nTcp [K],3262\n\
                    Illuminance [lx],30.1\nCRI Ra,87.5\nTM-30 Rf,87\nSSI1,---\n\n"
        .to_owned();
    for step in [5, 1] {
        for nm in (380..=400).step_by(step) {
            text += &format!("Spectral Data {nm}[nm],{}.25\n", nm - 380);
        }
        text.push('\n');
    }
    text + "bin1,0.1,0.2,0.3,0.4\n"
}

#[test]
fn the_finer_of_two_blocks_is_taken_and_said() {
    let reading = read("a.csv", text());
    assert_eq!(reading.format, "Sekonic CSV");
    let spectrum = &reading.spectra[0];
    assert_eq!((spectrum.samples.len(), &*spectrum.name), (21, "Desk 2°"));
    assert_eq!(spectrum.samples.values()[20], 20.25);
    assert_eq!(spectrum.unit, "W m-2 nm-1");
    assert_told(&spectrum.notes, "5 points every 5 nm");
    let ra = reading.results.iter().find(|r| r.quantity == Quantity::Ra);
    assert_eq!(ra.map(|r| r.value), Some(87.5));
}

#[test]
fn the_order_of_the_blocks_and_the_marks_do_not_matter() {
    let text = text();
    let want = first("a", &text).samples;
    let head = text.find("\n\nSpectral").unwrap();
    let (head, blocks) = (&text[..head], &text[head + 2..]);
    let (five, one) = blocks.split_once("\n\n").unwrap();
    for text in [
        format!("{head}\n{one}\n{five}\n"),
        text.replace('\n', "\r\n"),
        format!("\u{feff}{text}"),
        text.replace(',', ";").replace('.', ","),
        text.replace(".25", ",25"),
        format!("{head}\n{one}"),
    ] {
        assert_eq!(first("a", &text).samples, want, "{text}");
    }
}

#[test]
fn a_summary_is_refused_as_one() {
    let text = "\u{feff}Date Saved,1/1/2020\r\nTitle,X\r\n\r\nMeasuring Mode,Ambient\r\n\
                CCT [K],5392\r\nCRI Ra,99.3\r\n";
    let why = refusal("a.csv", text);
    let found = "a.csv: found a Sekonic summary (CCT, CRI, filters) without a spectrum";
    assert!(why.starts_with(found), "{why}");
}
