//! The golden figures of slits and of cut tops.

use super::{
    FlatTop, Kernel, Measurement, Quantity, Slit, flat_tops,
    golden::{cases, grid, light, numbers},
    slit_of,
    study::{colour, difference, noise_of_colour},
    unslit,
};
use crate::spectrum::Sampled;

#[test]
fn slits_are_told_to_a_third_of_a_nm_and_taken_off_to_a_third_of_the_colour_or_the_noise() {
    let (mut told, mut near, mut corrected, mut all) = (0, 0, 0, 0);
    for case in cases("bandwidth") {
        let name = case["name"].as_str().expect("a name");
        let fwhm = case["fwhm"].as_f64().expect("a width");
        let snr = case["snr"].as_f64().expect("a ratio");
        let mut seen = light(grid(&case["nm"]), numbers(&case["seen"]));
        let top = seen.samples.values().iter().copied().fold(0.0, f64::max);
        let noise = top / snr;
        match slit_of(&seen, Kernel::Gauss) {
            Ok(found) => {
                told += 1;
                let off = (found.slit.fwhm_nm - fwhm).abs();
                near += i32::from(off <= 0.3 || fwhm > 10.0);
                println!(
                    "{name}: {fwhm} found {:.2} u {:.2}",
                    found.slit.fwhm_nm, found.u
                );
            }
            Err(why) => println!("{name}: {fwhm} {why}"),
        }
        let slit = Slit {
            shape: Kernel::Gauss,
            fwhm_nm: fwhm,
        };
        let found = unslit(&seen, slit).expect(name);
        seen.sigma = Some(vec![noise; seen.samples.len()]);
        let [x, y] = numbers(&case["true_xy"])[..] else {
            panic!("x and y");
        };
        let (before, after) = (
            difference(colour(&seen.samples), [x, y]),
            difference(colour(&found.result.samples), [x, y]),
        );
        let of_noise = noise_of_colour(&seen);
        let bar = (before / 3.0).max(1.5 * of_noise + 0.01);
        println!(
            "{name}: before {before:.3} after {after:.3} noise {of_noise:.3} made {} lines {}",
            found.is_made,
            found.lines.len()
        );
        all += 1;
        corrected += i32::from(after <= bar);
        // Nothing is made darker than the reading or nothing by more than three of its noises.
        let pairs = found
            .result
            .samples
            .values()
            .iter()
            .zip(seen.samples.values());
        for (after, before) in pairs {
            assert!(*after >= before.min(0.0) - 3.0 * noise, "{name}");
        }
    }
    assert!(told >= 3 && near == told, "{near} of {told}");
    assert!(corrected >= all - 1, "{corrected} of {all}");
}

#[test]
fn cut_tops_of_counts_are_told_and_whole_ones_are_not() {
    let (mut cut, mut found) = (0, 0);
    for case in cases("clipped") {
        let name = case["name"].as_str().expect("a name");
        let number = |key: &str| case[key].as_f64();
        let (first, step) = (
            number("first_nm").expect("nm"),
            number("step_nm").expect("nm"),
        );
        let samples = Sampled::even(first, step, numbers(&case["values"])).expect("counts");
        let counts = Measurement::new(name, Quantity::Counts, "counts", samples);
        let tops: Vec<FlatTop> = flat_tops(&counts);
        match number("clipped_at") {
            None => assert_eq!(tops, [], "{name}"),
            Some(at) => {
                cut += 1;
                found += i32::from(!tops.is_empty() && tops.iter().all(|top| top.is_sure));
                if tops.is_empty() {
                    println!("{name} cut at {at}: not found");
                }
            }
        }
    }
    assert!(
        f64::from(found) >= 0.85 * f64::from(cut),
        "{found} of {cut}"
    );
}
