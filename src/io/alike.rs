//! Per cent or fraction is one answer for all spectra of a kind in a file: of a white and a black
//! patch in per cent, the black one alone would look like a fraction.

use crate::spectrum::Kind;

use super::{Counted, Guessed, Reading};

/// Takes what was guessed to be a fraction for per cent where others of its kind in the file were
/// guessed to be per cent. What the file states, or a person decided, stays.
pub fn settle(reading: &mut Reading) {
    for kind in [Kind::Reflectance, Kind::Transmittance] {
        let chosen = |reading: &Reading, word: Counted| -> Vec<usize> {
            let guesses = reading.guesses.iter();
            let of_word = guesses.filter(|g| g.what == Guessed::Percent && g.chosen == word.word());
            of_word
                .map(|guess| guess.spectrum)
                .filter(|at| reading.spectra.get(*at).is_some_and(|s| s.kind == kind))
                .collect()
        };
        let percent = chosen(reading, Counted::Percent);
        let highest = percent
            .iter()
            .map(|at| highest(reading.spectra[*at].samples.values()) * 100.0)
            .fold(0.0, f64::max);
        if percent.is_empty() || highest <= 0.0 {
            continue;
        }
        let mut turned = vec![false; reading.spectra.len()];
        for at in chosen(reading, Counted::Fraction) {
            turn_into_percent(reading, at, highest);
            turned[at] = true;
        }
        let because = because(highest);
        let guesses = reading.guesses.iter_mut();
        for guess in
            guesses.filter(|g| g.what == Guessed::Percent && turned.get(g.spectrum) == Some(&true))
        {
            Counted::Percent.word().clone_into(&mut guess.chosen);
            guess.because.clone_from(&because);
            guess.plain = true;
        }
    }
}

fn because(highest: f64) -> String {
    format!("others in the file reach {highest:.3}")
}

fn highest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

/// `highest` is the largest value of the others in the file's own number.
fn turn_into_percent(reading: &mut Reading, at: usize, highest: f64) {
    const FACTOR: f64 = 0.01;
    let because = because(highest);
    let told = format!("taken as {}: ", Counted::Fraction.word());
    let spectrum = &mut reading.spectra[at];
    spectrum.samples = spectrum.samples.scaled(FACTOR);
    spectrum.scale *= FACTOR;
    for note in &mut spectrum.notes {
        if note.starts_with(&told) {
            *note = format!("taken as {}: {because}", Counted::Percent.word());
        }
    }
    if let Some(line) = spectrum.notes.first_mut() {
        let before = line.clone();
        *line = line.replacen("fraction", "fraction, from per cent", 1);
        if reading.notes.first() == Some(&before) {
            reading.notes[0].clone_from(line);
        }
    }
    let understood = reading.understood.get_mut(at);
    if let Some(told) = understood.and_then(|u| u.counted.as_mut()) {
        told.is = Counted::Percent;
        told.because = because;
        told.plain = true;
    }
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;

    #[test]
    fn a_dark_patch_beside_a_bright_one_is_counted_alike() {
        let text = "nm,Reflectance black,Reflectance white\n400,0.6,91\n410,0.7,92\n420,0.7,91.5\n";
        let reading = read_bytes("patches.csv", text.as_bytes()).unwrap();
        let [black, white] = &reading.spectra[..] else {
            panic!("{reading:?}");
        };
        assert_eq!((black.scale, white.scale), (0.01, 0.01));
        assert!((black.samples.values()[1] - 0.007).abs() < 1e-12);
        assert!(black.notes[0].contains("fraction, from per cent"));
        assert!(
            black
                .notes
                .iter()
                .any(|n| n.ends_with("others in the file reach 92.000"))
        );
        assert!(!reading.is_doubtful(), "{:?}", reading.guesses);
    }

    #[test]
    fn fractions_alone_and_what_a_title_states_stay() {
        let text = "nm,Reflectance a,Reflectance b (%)\n400,0.6,91\n410,0.7,92\n420,0.7,91.5\n";
        let reading = read_bytes("patches.csv", text.as_bytes()).unwrap();
        assert_eq!(reading.spectra[0].scale, 1.0);
        let alone = "nm,Reflectance a,Reflectance b\n400,0.6,0.1\n410,0.7,0.1\n";
        let reading = read_bytes("patches.csv", alone.as_bytes()).unwrap();
        assert!(reading.spectra.iter().all(|s| s.scale == 1.0));
    }
}
