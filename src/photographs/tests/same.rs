//! One picture in another form: doubled, with loss, read in part, without colours.

use super::{
    super::{
        axis::{State, Wanted},
        picture::{Codes, Picture},
        strip::{self, ByHand},
    },
    axis_of, strip_of,
};
use crate::core_tests::photographs::{Dice, Kind, Light, Setup, drawn_profile, jpeg_of, picture};

/// A picture of a fluorescent lamp, without loss.
fn plain_picture(seed: u64) -> ([usize; 2], Vec<u8>, Vec<[f64; 3]>) {
    let mut dice = Dice::new(seed);
    let light = Light::of(Kind::Cfl, &mut dice);
    let mut setup = Setup::of([640, 360], &mut dice);
    setup.quality = None;
    setup.slit_nm = 2.0;
    let drawn = picture(&setup, &light, 0.9, 0.0, &mut dice);
    (drawn.size, drawn.codes, drawn.points)
}

/// The wavelengths of the axis of a picture at some of its pixels, and how many lines made it.
fn nm_at(size: [usize; 2], codes: Vec<u8>, pixels: &[[f64; 2]]) -> (Vec<f64>, usize) {
    let found = strip_of(size, codes).expect("a strip");
    let (answer, _) = axis_of(&found.profile, &Wanted::default());
    assert_eq!(answer.state, State::Found, "{:?}", answer.why);
    let best = answer.best.expect("an axis");
    let nm = |[x, y]: &[f64; 2]| best.curve.nm(found.strip.column_of(*x, *y).0);
    (pixels.iter().map(nm).collect(), best.matches.len())
}

#[test]
fn a_doubled_picture_and_a_jpeg_of_quality_100_have_the_same_axis() {
    let mut compared = 0;
    for seed in 5..=9 {
        let ([width, height], codes, points) = plain_picture(seed);
        let inside = |p: &&[f64; 3]| (440.0..=620.0).contains(&p[0]);
        let points = points.iter().filter(inside);
        let pixels: Vec<[f64; 2]> = points.map(|[_, x, y]| [*x, *y]).collect();
        let (plain, lines) = nm_at([width, height], codes.clone(), &pixels);
        let most = |other: &[f64]| {
            let off = plain.iter().zip(other).map(|(a, b)| (a - b).abs());
            off.fold(0.0, f64::max)
        };
        // A faint line that the loss hides is no other place of those that stay.
        let jpeg = jpeg_of(&codes, [width, height], 100);
        let (jpeg, same) = nm_at([width, height], jpeg, &pixels);
        if lines == same {
            compared += 1;
            assert!(most(&jpeg) < 0.1, "{seed}: {} nm as JPEG", most(&jpeg));
        }
        if seed > 6 {
            continue;
        }
        let pixel = |x: usize, y: usize| {
            let at = 3 * (y * width + x);
            [codes[at], codes[at + 1], codes[at + 2]]
        };
        let places = 0..4 * width * height;
        let doubled = places.flat_map(|i| pixel(i % (2 * width) / 2, i / (4 * width)));
        let large: Vec<[f64; 2]> = pixels.iter().map(|p| p.map(|v| 2.0 * v + 0.5)).collect();
        let (large, _) = nm_at([2 * width, 2 * height], doubled.collect(), &large);
        assert!(most(&large) < 0.3, "{seed}: {} nm doubled", most(&large));
    }
    assert!(compared >= 3, "{compared}");
}

#[test]
fn three_lines_without_colours_are_never_found() {
    for seed in 0..40 {
        let mut dice = Dice::new(8_000_000 + seed);
        let lines = (0..3)
            .map(|_| [dice.between(400.0, 690.0), 1.0, 0.1])
            .collect();
        let (mut profile, _) = drawn_profile(&Light::made(lines, Vec::new()), &mut dice);
        let grey = profile.sum();
        profile.channels = [grey.clone(), grey.clone(), grey];
        profile.is_grey = true;
        let (answer, _) = axis_of(&profile, &Wanted::default());
        assert_ne!(answer.state, State::Found, "{seed}: {:?}", answer.best);
    }
}

#[test]
fn a_band_within_a_strip_and_words_beside_it_have_the_same_axis() {
    for seed in [5, 6, 9] {
        let mut dice = Dice::new(seed);
        let light = Light::of(Kind::Cfl, &mut dice);
        let mut setup = Setup::of([640, 360], &mut dice);
        (setup.quality, setup.slit_nm) = (None, 2.0);
        (setup.tilt_deg, setup.is_vertical) = (0.0, false);
        let drawn = picture(&setup, &light, 0.9, 0.0, &mut dice);
        let inside = |p: &&[f64; 3]| (440.0..=620.0).contains(&p[0]);
        let points = drawn.points.iter().filter(inside);
        let pixels: Vec<[f64; 2]> = points.map(|[_, x, y]| [*x, *y]).collect();
        let (plain, _) = nm_at(drawn.size, drawn.codes.clone(), &pixels);
        let strip = strip_of(drawn.size, drawn.codes.clone())
            .expect("a strip")
            .strip;
        let (middle, half) = (strip.centre_y, strip.half);
        // White letters where the black beside the band is looked for.
        let mut worded = drawn.codes.clone();
        for y in 0..drawn.size[1] {
            let off = (y as f64 - middle).abs() / half;
            for x in (60..500).filter(|x| (1.15..2.2).contains(&off) && x % 20 < 10) {
                worded[3 * (y * drawn.size[0] + x)..][..3].fill(255);
            }
        }
        for (codes, share) in [(drawn.codes, 0.4), (worded, 0.9)] {
            let band = [middle - share * half, middle + share * half];
            let by_hand = ByHand {
                is_vertical: Some(false),
                area: Some([0.0, band[0], 639.0, band[1]]),
                ..ByHand::default()
            };
            let picture = Picture::new(drawn.size, Codes::Eight(codes), false).expect("a picture");
            let found = strip::find(&picture, &by_hand).expect("a strip");
            assert!(
                found.profile.rows > 10,
                "{seed}: {} rows",
                found.profile.rows
            );
            let (answer, _) = axis_of(&found.profile, &Wanted::default());
            let best = answer.best.expect("an axis");
            assert_eq!(
                answer.state,
                State::Found,
                "{seed}, {share}: {:?}",
                answer.why
            );
            for (nm, [x, y]) in plain.iter().zip(&pixels) {
                let off = best.curve.nm(found.strip.column_of(*x, *y).0) - nm;
                assert!(off.abs() < 0.5, "{seed}, {share}: {off:.2} at {nm:.0} nm");
            }
        }
    }
}
