//! The definition's bars of slits on the shipped lamps, once and by hand, as `study`.

use super::{
    Kernel, Measurement, Slit, slit_of,
    study::{colour, difference, lamps, of, top},
    unslit,
};
use crate::{
    measurements::draws::normal,
    spectrum::{Band, Outside, Sampled, SpikeSettings, detect},
};

/// A lamp as its smooth part and lines without width, and what a slit makes of it.
struct Seen {
    name: String,
    /// The lamp with its lines 2 nm wide.
    truth: Sampled,
    lines: Vec<(f64, f64)>,
    seen: Measurement,
    /// What its noise alone makes of its colour, CIEDE2000: no correction takes that away.
    noise: f64,
}

fn seen(name: &str, lamp: &Sampled, slit: Slit, snr: f64, seed: u64) -> Seen {
    let band = Band::VISIBLE;
    let parts = detect(
        band,
        &lamp.on_band(band, Outside::Zero),
        SpikeSettings::default(),
    );
    let smooth = of(lamp.sharing(parts.smooth.clone()).expect("finite"));
    let lines: Vec<(f64, f64)> = parts
        .spikes
        .iter()
        .map(|s| (s.spike.at_nm, s.spike.weight))
        .collect();
    let blurred = super::smoothed(&smooth, slit).expect("wider").samples;
    let drawn = |nm: f64, width: f64| -> f64 {
        let kernel = Slit {
            shape: Kernel::Gauss,
            fwhm_nm: width,
        };
        lines.iter().map(|(at, w)| w * kernel.height(nm - at)).sum()
    };
    let by_slit = |nm: f64| -> f64 { lines.iter().map(|(at, w)| w * slit.height(nm - at)).sum() };
    let nm = lamp.nm().iter();
    let clean: Vec<f64> = nm
        .clone()
        .zip(blurred.values())
        .map(|(nm, v)| v + by_slit(*nm))
        .collect();
    let truth = nm
        .zip(&parts.smooth)
        .map(|(nm, v)| v + drawn(*nm, 2.0))
        .collect();
    let clean = lamp.sharing(clean).expect("finite");
    let sigma = top(&clean) / snr;
    let values = clean
        .values()
        .iter()
        .zip(normal(seed))
        .map(|(v, e)| v + sigma * e);
    let noisy = lamp.sharing(values.collect()).expect("finite");
    Seen {
        name: name.to_owned(),
        truth: lamp.sharing(truth).expect("finite"),
        lines,
        noise: difference(colour(&noisy), colour(&clean)),
        seen: of(noisy),
    }
}

/// Root mean square of two tables seen through 5 nm, in the second one's.
fn rms(found: &Sampled, truth: &Sampled) -> f64 {
    let slit = Slit {
        shape: Kernel::Gauss,
        fwhm_nm: 5.0,
    };
    let through = |s: &Sampled| {
        super::smoothed(&of(s.clone()), slit)
            .expect("wider")
            .samples
    };
    let (a, b) = (through(found), through(truth));
    let square = |v: f64| v * v;
    let off: f64 = a
        .values()
        .iter()
        .zip(b.values())
        .map(|(a, b)| square(a - b))
        .sum();
    (off / b.values().iter().map(|v| square(*v)).sum::<f64>()).sqrt()
}

#[test]
#[ignore = "minutes: the bar of slits"]
fn slits_of_2_to_10_nm_are_told_to_a_third_and_taken_off() {
    let hg = [404.656, 435.833, 546.074];
    let all = lamps();
    for snr in [100.0, 1000.0] {
        for fwhm_nm in [2.0, 3.0, 5.0, 7.0, 10.0] {
            let slit = Slit {
                shape: Kernel::Gauss,
                fwhm_nm,
            };
            let (mut told, mut near, mut with_hg) = (0, 0, 0);
            let (mut right, mut corrected, mut false_lines, mut line_lamps) = (0, 0, 0, 0);
            let (mut before_rms, mut after_rms) = (Vec::new(), Vec::new());
            for (index, (name, lamp)) in all.iter().enumerate() {
                let case = seen(name, lamp, slit, snr, 300 + index as u64);
                let is_hg = |nm: f64| case.lines.iter().any(|line| (line.0 - nm).abs() < 1.0);
                if hg.iter().filter(|nm| is_hg(**nm)).count() >= 2 {
                    with_hg += 1;
                    if let Ok(found) = slit_of(&case.seen, Kernel::Gauss) {
                        told += 1;
                        let off = (found.slit.fwhm_nm - fwhm_nm).abs();
                        near += i32::from(off <= 0.3);
                        if off > 0.3 {
                            println!(
                                "  {}: {fwhm_nm} told as {:.2}",
                                case.name, found.slit.fwhm_nm
                            );
                        }
                    }
                }
                let found = unslit(&case.seen, slit).expect("a slit");
                let (was, is) = (
                    difference(colour(&case.seen.samples), colour(&case.truth)),
                    difference(colour(&found.result.samples), colour(&case.truth)),
                );
                corrected += 1;
                right += i32::from(is <= (was / 3.0).max(1.5 * case.noise + 0.01));
                if !case.lines.is_empty() {
                    line_lamps += 1;
                    before_rms.push(rms(&case.seen.samples, &case.truth));
                    after_rms.push(rms(&found.result.samples, &case.truth));
                    let again = detect(
                        Band::VISIBLE,
                        &found.result.samples.on_band(Band::VISIBLE, Outside::Zero),
                        SpikeSettings::default(),
                    );
                    let is_known =
                        |at: f64| case.lines.iter().any(|line| (line.0 - at).abs() <= 4.0);
                    false_lines += again
                        .spikes
                        .iter()
                        .filter(|s| !is_known(s.spike.at_nm))
                        .count();
                }
            }
            for list in [&mut before_rms, &mut after_rms] {
                list.sort_by(f64::total_cmp);
            }
            println!(
                "{fwhm_nm} nm, SNR {snr}: told {told} of {with_hg}, near {near}; dE right {right} of {corrected}; \
                 rms {:.3} to {:.3}; false lines {:.2} a lamp",
                before_rms[before_rms.len() / 2],
                after_rms[after_rms.len() / 2],
                false_lines as f64 / f64::from(line_lamps)
            );
        }
    }
}
