//! JCAMP-DX, by files of our own.

use crate::told::{self, has};
use spectral_explorer::{
    io::{Guessed, Reading},
    spectrum::Kind,
};

fn file(head: &str, data: &str) -> String {
    format!(
        "##TITLE= a lamp\n##JCAMP-DX= 4.24 $$ by hand\n##DATA TYPE= UV/VIS SPECTRUM\n\
         ##XUNITS= NANOMETERS\n##YUNITS= ABSORBANCE\n{head}\n{data}\n##END=\n"
    )
}

fn read(text: &str) -> Reading {
    told::read("a.jdx", text)
}

fn refusal(text: &str) -> String {
    told::refusal("a.jdx", text)
}

fn values(text: &str) -> Vec<f64> {
    read(text).spectra[0].samples.values().to_vec()
}

const HEAD: &str = "##FIRSTX= 400\n##LASTX= 414\n##NPOINTS= 8\n##XFACTOR= 1\n##YFACTOR= 1";
const Y: [f64; 8] = [0.0, 10.0, 10.0, 10.0, 28.0, -3.0, 3.0, 3.0];

#[test]
fn plain_and_packed_forms_of_the_same_numbers_read_alike() {
    for data in [
        "400 0 10 10 10 28\n410 -3 3 3",
        "400+0+10+10+10+28\n410-3+3+3",
        "400@A0A0A0B8\n410cCC",
        "400@A0UB8\n410cCT",
        "400@J0%%J8\n408B8l1O%",
    ] {
        let text = file(HEAD, &format!("##XYDATA= (X++(Y..Y))\n{data}"));
        let spectrum = &read(&text).spectra[0];
        assert_eq!(spectrum.samples.values(), Y, "{data}");
        assert_eq!(spectrum.samples.nm()[7], 414.0);
        assert_eq!(spectrum.kind, Kind::Absorbance);
    }
}

#[test]
fn abscissas_beside_the_numbers_are_believed_before_the_labels() {
    let text = file(
        "##FIRSTX= 400\n##LASTX= 480\n##NPOINTS= 9\n##XFACTOR= 1\n##YFACTOR= 1",
        "##XYDATA= (X++(Y..Y))\n480 10 20 30\n450 40 50 60\n420 70 80 90",
    );
    let reading = read(&text);
    let samples = &reading.spectra[0].samples;
    assert_eq!((samples.first_nm(), samples.last_nm()), (400.0, 480.0));
    let turned = [90.0, 80.0, 70.0, 60.0, 50.0, 40.0, 30.0, 20.0, 10.0];
    assert_eq!(samples.values(), turned);
    let notes = &reading.spectra[0].notes;
    assert!(has(notes, "the wrong way round"), "{notes:?}");
}

#[test]
fn differences_are_checked_at_line_starts() {
    // 28 - 31 = -3, + 6 = 3, + 0.
    let good = file(HEAD, "##XYDATA= (X++(Y..Y))\n400@J0%TJ8\n408B8l1O%\n414C");
    assert_eq!(values(&good), Y);
    assert!(!has(&read(&good).spectra[0].notes, "checks"));
    let notes = &read(&good.replace("B8", "B9")).spectra[0].notes;
    let note = "checks at line starts are wrong, the first at line 13";
    assert!(has(notes, note), "{notes:?}");
}

#[test]
fn the_example_of_the_standard_unpacks() {
    let text = file(
        "##XFACTOR= 1\n##YFACTOR= 0.1\n##FIRSTX= 4\n##LASTX= 56\n##NPOINTS= 53\n##FIRSTY= 0",
        "##XYDATA= (X++(Y..Y)\n4@VKT%TLkj%J%KLJ%njKjL%kL%jJULJ%kLK1%lLMNPNPRLJ0QTOJ1P\n56A28",
    );
    let text = text.replace("##XUNITS= NANOMETERS\n", "##XUNITS= MICROMETERS\n");
    let spectrum = &read(&text).spectra[0];
    assert_eq!(spectrum.samples.len(), 53);
    assert_eq!(spectrum.samples.nm()[52], 56_000.0);
    // The check at the end of the standard's own example: 128 tenths.
    assert!((spectrum.samples.values()[52] - 12.8).abs() < 1e-12);
    let seconds = text.replace("MICROMETERS", "MILLISECONDS");
    assert_eq!(
        refusal(&seconds),
        "a.jdx, line 4: found \"MILLISECONDS\" on the x axis, expected NANOMETERS, MICROMETERS or 1/CM"
    );
}

#[test]
fn pairs_may_have_decimal_commas_and_any_number_on_a_line() {
    let points = ("##NPOINTS= 3", [400.5, 401.0, 401.5], [0.1, 0.2, 0.3]);
    let head = "##XFACTOR= 1.0\n##YFACTOR= 1.0\n##FIRSTX= 400,5\n##LASTX= 402,25\n##FIRSTY= 12,75";
    let commas = (head, [400.5, 401.0, 402.25], [12.75, -3.0, 0.01]);
    for ((head, nm, values), data) in [
        (points, "400.5, 0.1\n401.0, 0.2\n401.5, 0.3"),
        (points, "400.5 0.1; 401 0.2; 401.5 0.3"),
        (points, "400,5 0,1\n401,0 0,2\n401,5 0,3"),
        (points, "400.5,0.1 401,0.2\n401.5 $$ broken\n0.3"),
        // A comma may part numbers whose decimals are commas too.
        (commas, "400,5, 12,75\n401, -3\n402,25, 1E-2"),
        (commas, "400,5,12,75\n401, -3,0\n402,25,0,01"),
        (commas, "400,5 12,75; 401 -3; 402,25 0,01"),
    ] {
        let text = file(head, &format!("##XYPOINTS= (XY..XY)\n{data}"));
        let samples = &read(&text).spectra[0].samples;
        assert_eq!(samples.nm(), nm, "{data}");
        assert_eq!(samples.values(), values, "{data}");
    }
}

#[test]
fn every_block_of_a_link_gives_a_spectrum_and_what_does_not_is_said() {
    let inner = file(HEAD, "##XYDATA= (X++(Y..Y))\n400 0 10 10 10 28\n410 -3 3 3");
    let peaks = file("", "##PEAK TABLE= (XY..XY)\n400, 1");
    let text = format!(
        "##TITLE= all\n## DATA TYPE = LINK\n##BLOCKS= 3\n{inner}{peaks}{}##END=\n",
        inner.replace("ABSORBANCE", "%T")
    );
    let reading = read(&text);
    assert_eq!(reading.spectra.len(), 2);
    assert_eq!(reading.spectra[1].kind, Kind::Transmittance);
    assert_eq!(reading.spectra[1].scale, 0.01);
    assert!(has(&reading.notes, "a table of peaks"));
}

#[test]
fn wave_numbers_become_wavelengths_unless_they_cannot_be_any() {
    let head = "##FIRSTX= 20000\n##LASTX= 25000\n##NPOINTS= 3";
    let text = file(head, "##XYDATA= (X++(Y..Y))\n20000 1 2 3");
    let text = text.replace("NANOMETERS", "1/CM");
    let samples = &read(&text).spectra[0].samples;
    // In air, whose index is 1.000 282 8 and 1.000 279 0 there.
    assert!((samples.first_nm() - 399.8869).abs() < 1e-4);
    assert!((samples.last_nm() - 499.8606).abs() < 1e-4);
    let head = "##FIRSTX= 210\n##LASTX= 650\n##NPOINTS= 3";
    let text = file(head, "##XYDATA= (X++(Y..Y))\n210 1 2 3").replace("NANOMETERS", "1/CM");
    let reading = read(&text);
    assert_eq!(reading.spectra[0].samples.last_nm(), 650.0);
    assert_eq!(reading.guesses[0].what, Guessed::WavelengthUnit);
}

#[test]
fn counts_are_no_transmittance_whatever_the_label_says() {
    let text = file("", "##XYPOINTS= (XY..XY)\n400, 3000\n500, 32822.795");
    let reading = read(&text.replace("ABSORBANCE", "Transmission (%)"));
    let spectrum = &reading.spectra[0];
    assert_eq!((spectrum.kind, spectrum.scale), (Kind::Light, 1.0));
    assert_eq!(reading.guesses.len(), 1);
}

#[test]
fn numbers_that_do_not_agree_are_noted() {
    let head = HEAD.replace("NPOINTS= 8", "NPOINTS= 15");
    let data = "##XYDATA= (X++(Y..Y))\n400 0 10 10 10 28\n405 -3 3 3";
    let spectrum = &read(&file(&head, data)).spectra[0];
    assert_eq!(spectrum.samples.nm()[1], 401.0);
    assert!(has(&spectrum.notes, "NPOINTS says 15, found 8 points"));
}

#[test]
fn what_is_no_spectrum_is_refused_in_words() {
    let raman = file(HEAD, "##XYDATA= (X++(Y..Y))\n400 1 2").replace("UV/VIS", "RAMAN");
    assert!(refusal(&raman).contains("Raman"));
    assert!(refusal(&file(HEAD, "")).contains("a block without data"));
    assert!(refusal("##TITLE= a\n##DATA TYPE= LINK\n##END=").contains("without data"));
    let word = refusal(&file(HEAD, "##XYDATA= (X++(Y..Y))\n400 1 !x 2"));
    assert!(word.contains("line 12: found \"!x 2\""), "{word}");
    let html = told::refusal("a.dx", "<br />\n<b>Warning</b>: fopen");
    assert!(html.contains("web page"));
    // A few letters do not unfold into millions of points.
    let text = file(HEAD, "##XYDATA= (X++(Y..Y))\n400A1S99999999999999999999");
    assert!(refusal(&text).contains("far more points than the file has text"));
}
