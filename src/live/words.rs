//! Rate, age and time in words.

use crate::languages::fixed;

/// Frames a second: `9.8 spectra a second`, `a spectrum every 2.5 s`.
pub fn rate(per_second: Option<f64>) -> String {
    match per_second {
        None => said!("no rate yet").to_owned(),
        Some(rate) if rate >= 9.95 => tr!("{rate} spectra a second", rate = fixed(rate, 0)),
        Some(rate) if rate >= 0.995 => tr!("{rate} spectra a second", rate = fixed(rate, 1)),
        Some(rate) => tr!("a spectrum every {span}", span = span(1.0 / rate)),
    }
}

/// Time since the last frame, s: `just now`, `4 s ago`, `2 min ago`.
pub fn age(seconds: Option<f64>) -> String {
    match seconds {
        None => said!("no spectrum yet").to_owned(),
        Some(seconds) if seconds < 1.0 => said!("just now").to_owned(),
        Some(seconds) => tr!("{span} ago", span = span(seconds.floor())),
    }
}

fn span(seconds: f64) -> String {
    match seconds {
        s if s < 9.95 && s.fract() != 0.0 => format!("{} s", fixed(s, 1)),
        s if s < 119.5 => format!("{s:.0} s"),
        s if s < 7170.0 => format!("{:.0} min", s / 60.0),
        s => format!("{:.0} h", s / 3600.0),
    }
}

/// A frame's time, ms, as `1:02:03.4`.
pub fn clock(time_ms: f64) -> String {
    // A time that no clock has is that of the beginning.
    let tenths = (time_ms / 100.0).round().max(0.0) as u64;
    let seconds = tenths / 10;
    format!(
        "{}:{:02}:{:02}.{}",
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60,
        tenths % 10
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_told_in_the_unit_that_suits_them() {
        assert_eq!(rate(Some(99.6)), "100 spectra a second");
        assert_eq!(rate(Some(2.04)), "2.0 spectra a second");
        assert_eq!(rate(Some(0.4)), "a spectrum every 2.5 s");
        assert_eq!(rate(Some(1.0 / 600.0)), "a spectrum every 10 min");
        assert_eq!(rate(None), "no rate yet");
        assert_eq!(age(Some(0.4)), "just now");
        assert_eq!(age(Some(4.9)), "4 s ago");
        assert_eq!(age(Some(600.0)), "10 min ago");
        assert_eq!(age(None), "no spectrum yet");
        assert_eq!(clock(3_723_449.0), "1:02:03.4");
        assert_eq!(clock(f64::NAN), "0:00:00.0");
    }
}
