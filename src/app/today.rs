//! The day that it is.

/// The day, as `2026-11-23`.
pub fn today() -> String {
    let since = web_time::SystemTime::now().duration_since(web_time::UNIX_EPOCH);
    let days = since.map_or(0, |since| (since.as_secs() / 86_400) as i64);
    day(days)
}

/// The day so many days after 1970-01-01, in the Gregorian calendar.
fn day(days: i64) -> String {
    // Counted from a March, so that the day that leap years add is the last.
    let days = days + 719_468;
    let era = days.div_euclid(146_097);
    let of_era = days.rem_euclid(146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let march = (5 * of_year + 2) / 153;
    let date = of_year - (153 * march + 2) / 5 + 1;
    let month = if march < 10 { march + 3 } else { march - 9 };
    let year = year + 400 * era + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{date:02}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_have_their_dates() {
        assert_eq!(day(0), "1970-01-01");
        assert_eq!(day(11_016), "2000-02-29");
        assert_eq!(day(20_780), "2026-11-23");
    }
}
