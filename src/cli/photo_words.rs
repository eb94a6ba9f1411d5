//! Words of `photo`.

use std::path::PathBuf;

use super::words::{listed, refused};
use crate::{
    app::photograph::{Exposure, Known, LampChoice},
    photographs::{Lamp, axis::Pin},
};

/// Numbers with commas between, as many as are wanted.
fn numbers<const N: usize>(word: &str) -> Option<[f64; N]> {
    let parts: Vec<f64> = (word.split(','))
        .map(|part| part.trim().parse().ok().filter(|v: &f64| v.is_finite()))
        .collect::<Option<_>>()?;
    parts.try_into().ok()
}

pub(super) fn pixel(word: &str) -> Result<[f64; 2], String> {
    numbers(word).ok_or_else(|| refused(word, "a pixel such as 320,200"))
}

/// `--box`.
pub(super) fn area(word: &str) -> Result<[f64; 4], String> {
    numbers::<4>(word)
        .filter(|[x0, y0, x1, y1]| x1 > x0 && y1 > y0)
        .ok_or_else(|| refused(word, "left, top, right and bottom such as 20,180,620,240"))
}

pub(super) fn turn(word: &str) -> Result<f64, String> {
    let degrees = word.trim().parse().ok();
    degrees
        .filter(|d| (-45.0..=45.0).contains(d))
        .ok_or_else(|| refused(word, "degrees from -45 to 45"))
}

/// `--shear` and `--smile`.
pub(super) fn lean(word: &str) -> Result<f64, String> {
    let columns = word.trim().parse().ok();
    columns
        .filter(|c| (-5.0..=5.0).contains(c))
        .ok_or_else(|| refused(word, "columns from -5 to 5"))
}

/// `--exposures`: a picture and its time, `1/30` or `0.033`.
pub(super) fn exposure(word: &str) -> Result<Exposure, String> {
    let parts = word.rsplit_once(':').and_then(|(path, time)| {
        let number = |word: &str| word.trim().parse::<f64>().ok();
        let seconds = match time.split_once('/') {
            Some((a, b)) => number(a)? / number(b)?,
            None => number(time)?,
        };
        let path = PathBuf::from(path);
        (seconds > 0.0 && seconds.is_finite()).then_some(Exposure { path, seconds })
    });
    parts.ok_or_else(|| refused(word, "a picture and its time such as lamp.jpg:1/30"))
}

pub(super) fn strip(word: &str) -> Result<usize, String> {
    super::words::whole(word, &(1..=100))
}

pub(super) fn lamp(word: &str) -> Result<LampChoice, String> {
    match (word, Lamp::named(word)) {
        ("auto", _) => Ok(LampChoice::Auto),
        ("none", _) => Ok(LampChoice::Nothing),
        (_, Some(lamp)) => Ok(LampChoice::Is(lamp)),
        _ => {
            let mut names: Vec<&str> = Lamp::ALL.iter().map(|lamp| lamp.name()).collect();
            names.extend(["auto", "none"]);
            Err(refused(word, listed(&names)))
        }
    }
}

/// `--as` with a temperature; `None` for another word.
pub(super) fn of_kelvin(word: &str) -> Option<Result<Known, String>> {
    let (kind, number) = word.split_once(':')?;
    let kelvin: Option<f64> = number.trim().parse().ok();
    let within = |least: f64, most: f64| {
        kelvin
            .filter(|k| (least..=most).contains(k))
            .ok_or_else(|| refused(word, format_args!("{kind} and {least} to {most} K")))
    };
    match kind {
        "blackbody" => Some(within(1000.0, 20_000.0).map(Known::Blackbody)),
        "daylight" => Some(within(4000.0, 25_000.0).map(Known::Daylight)),
        _ => None,
    }
}

pub(super) fn pin(word: &str) -> Result<Pin, String> {
    let parts = word.split_once(':').and_then(|(px, nm)| {
        let (px, nm): (f64, f64) = (px.trim().parse().ok()?, nm.trim().parse().ok()?);
        Some(Pin::near(px, nm))
    });
    let known = |pin: &Pin| (100.0..=5000.0).contains(&pin.nm) && pin.px.is_finite();
    parts
        .filter(known)
        .ok_or_else(|| refused(word, "a column and its nm such as 118.8:435.8"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read_or_refused_with_an_example() {
        assert_eq!(pixel("3, 4.5"), Ok([3.0, 4.5]));
        assert!(pixel("3").unwrap_err().contains("320,200"));
        assert_eq!(area("1,2,30,40"), Ok([1.0, 2.0, 30.0, 40.0]));
        assert!(area("30,2,1,40").is_err());
        assert_eq!(turn("-3"), Ok(-3.0));
        assert!(turn("46").is_err() && turn("NaN").is_err());
        assert_eq!(lean("-0.2"), Ok(-0.2));
        assert!(lean("9").is_err() && lean("NaN").is_err());
        let short = exposure("a:b.jpg:1/50").expect("a time");
        assert_eq!(
            (short.path.to_str(), short.seconds),
            (Some("a:b.jpg"), 0.02)
        );
        assert!(exposure("a.jpg:0").is_err() && exposure("a.jpg").is_err());
        assert_eq!(lamp("none"), Ok(LampChoice::Nothing));
        assert_eq!(lamp("neon"), Ok(LampChoice::Is(Lamp::Neon)));
        assert!(lamp("candle").unwrap_err().contains("helium"));
        assert_eq!(pin("118.8:435.8"), Ok(Pin::near(118.8, 435.8)));
        let bulb = of_kelvin("blackbody:2856");
        assert_eq!(bulb, Some(Ok(Known::Blackbody(2856.0))));
        assert!(of_kelvin("daylight:1").is_some_and(|d| d.is_err()));
        assert_eq!(of_kelvin("FL2"), None);
        assert!(pin("118.8").is_err() && pin("1:NaN").is_err());
    }
}
