//! Golden profiles and drawn ones: their axes, and what is never to be found.

mod drawn;
mod golden;
mod same;

use super::{
    Profile,
    axis::{Answer, Pin, Solution, Wanted, find},
    landmarks::Lamp,
    peaks::{Peaks, bright, dark},
    picture::{Codes, Picture},
    strip::{self, ByHand},
};

fn axis_of(profile: &Profile, wanted: &Wanted) -> (Answer, Peaks) {
    let bright = bright(profile);
    let dark = dark(profile, &bright);
    let answer = find(profile.columns(), &bright, dark.as_ref(), wanted);
    (answer, bright)
}

/// What an axis is off by at places whose wavelengths are known: root mean square within 15 nm of
/// its lines in 400-700 nm, and the worst among them.
fn off_at(best: &Solution, truth: &[[f64; 2]]) -> (f64, f64) {
    let (low, high) = best.span_nm();
    let inside = |from: f64, to: f64| {
        let counts = move |at: &&[f64; 2]| (from.max(400.0)..=to.min(700.0)).contains(&at[0]);
        let places = truth.iter().filter(counts);
        places
            .map(|[nm, px]| (best.curve.nm(*px) - nm).abs())
            .collect::<Vec<f64>>()
    };
    let near = inside(low - 15.0, high + 15.0);
    let rms = (near.iter().map(|o| o * o).sum::<f64>() / near.len().max(1) as f64).sqrt();
    (rms, inside(low, high).into_iter().fold(0.0, f64::max))
}

/// Pins on the outermost lines that a person may know for the lamp's: peaks whose true place is
/// near to a landmark, each so far off its peak as a hand sets it.
fn pins_by_hand(
    profile: &Profile,
    lamp: Lamp,
    truth: impl Fn(f64) -> f64,
    mut slip_px: impl FnMut() -> f64,
) -> Option<Vec<Pin>> {
    // A slit of 2 nm is one of the middle of a table.
    let landmarks = &lamp.tables()[2].landmarks;
    let known = landmarks.iter().filter(|l| !l.is_clipped && l.chance > 0.5);
    let mark_at = |at: f64| {
        let away = |nm: &f64| (nm - at).abs();
        let nearest = known.clone().map(|l| l.nm);
        let nearest = nearest.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        (away(&nearest) < 2.0).then_some(nearest)
    };
    let bright = bright(profile);
    let peaks = if lamp.is_dark() {
        dark(profile, &bright)?
    } else {
        bright
    };
    let places = peaks.peaks.iter().map(|peak| peak.px);
    let known: Vec<_> = places
        .filter_map(|px| Some((px, mark_at(truth(px))?)))
        .collect();
    let [first, .., last] = known[..] else {
        return None;
    };
    let pin = |(px, nm): (f64, f64)| Pin::near(px + slip_px(), nm);
    Some([first, last].map(pin).to_vec())
}

fn strip_of(size: [usize; 2], codes: Vec<u8>) -> Option<strip::Found> {
    let picture = Picture::new(size, Codes::Eight(codes), false).expect("a picture");
    strip::find(&picture, &ByHand::default()).ok()
}
