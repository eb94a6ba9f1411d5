//! The file of an instrument, read.

use serde_json::Value;

use super::{FORMAT, Instrument, VERSION};

impl Instrument {
    /// Reads the file of an instrument.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn read(text: &str) -> Result<Self, String> {
        let value: Value = serde_json::from_str(text)
            .map_err(|_| said!("found no JSON, expected the file of an instrument").to_owned())?;
        if value["format"] != FORMAT {
            return Err(
                said!("found another format, expected the file of an instrument").to_owned(),
            );
        }
        match value["version"].as_u64() {
            Some(VERSION) => {}
            found => {
                return Err(match found {
                    Some(found) => tr!(
                        "found version {found}, expected {expected}: a newer program may read it",
                        found,
                        expected = VERSION
                    ),
                    None => tr!(
                        "found no version, expected {expected}: a newer program may read it",
                        expected = VERSION
                    ),
                });
            }
        }
        let instrument: Self = serde_json::from_value(value).map_err(|why| {
            tr!(
                "found a damaged instrument ({why}), expected a whole one",
                why
            )
        })?;
        let axis = instrument.curve();
        let numbers = axis.c.iter().chain(axis.covariance.iter().flatten());
        let is_whole = numbers.chain([&axis.centre_px]).all(|n| n.is_finite())
            && axis.scale_px >= 1.0
            && axis.is_monotone()
            && instrument.axis.valid_nm[0] < instrument.axis.valid_nm[1]
            && (1..=100_000).contains(&instrument.picture.width)
            && (1..=100_000).contains(&instrument.picture.height)
            && (1..=100_000).contains(&instrument.strip.columns)
            && (1.0..=100_000.0).contains(&instrument.strip.half);
        if is_whole {
            Ok(instrument)
        } else {
            Err(
                said!("found an axis or a strip that cannot be, expected those of an instrument")
                    .to_owned(),
            )
        }
    }
}
