//! The few lines of EXIF that are read.

/// The EXIF data kept of a picture: never the place where it was taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Exif {
    /// The orientation for showing the stored picture, 1 to 8.
    pub orientation: u8,
    /// Seconds.
    pub exposure_s: Option<f64>,
    /// Sensitivity.
    pub iso: Option<u32>,
    /// `2026:11:23 12:00:00`.
    pub date: Option<String>,
}

impl Default for Exif {
    fn default() -> Self {
        Self {
            orientation: 1,
            exposure_s: None,
            iso: None,
            date: None,
        }
    }
}

/// Most entries of a directory that are looked at.
const MOST_ENTRIES: usize = 512;

const ORIENTATION: u16 = 0x0112;
const DETAILS: u16 = 0x8769;
const EXPOSURE: u16 = 0x829a;
const ISO: u16 = 0x8827;
const DATE: u16 = 0x9003;

/// A TIFF in memory.
struct Tiff<'b> {
    bytes: &'b [u8],
    is_little: bool,
}

impl Tiff<'_> {
    fn word(&self, at: usize) -> Option<u16> {
        let bytes = self.bytes.get(at..at.checked_add(2)?)?.try_into().ok()?;
        Some(if self.is_little {
            u16::from_le_bytes(bytes)
        } else {
            u16::from_be_bytes(bytes)
        })
    }

    fn long(&self, at: usize) -> Option<u32> {
        let bytes = self.bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
        Some(if self.is_little {
            u32::from_le_bytes(bytes)
        } else {
            u32::from_be_bytes(bytes)
        })
    }

    /// The offset of a tag's entry in a directory.
    fn entry(&self, directory: usize, tag: u16) -> Option<usize> {
        let count = usize::from(self.word(directory)?).min(MOST_ENTRIES);
        let mut entries = (0..count).map(|i| directory + 2 + 12 * i);
        entries.find(|at| self.word(*at) == Some(tag))
    }
}

impl Exif {
    /// Parses the bytes of an EXIF segment; missing or bad entries are left out.
    pub(super) fn of(bytes: &[u8]) -> Self {
        let bytes = bytes.strip_prefix(b"Exif\0\0").unwrap_or(bytes);
        let tiff = Tiff {
            bytes,
            is_little: bytes.starts_with(b"II"),
        };
        let mut exif = Self::default();
        let Some(first) = tiff.long(4).map(|at| at as usize) else {
            return exif;
        };
        let stated = tiff
            .entry(first, ORIENTATION)
            .and_then(|at| tiff.word(at + 8));
        if let Some(turn @ 1..=8) = stated {
            exif.orientation = turn as u8;
        }
        let details = tiff.entry(first, DETAILS).and_then(|at| tiff.long(at + 8));
        let Some(details) = details.map(|at| at as usize) else {
            return exif;
        };
        let place = |tag| tiff.entry(details, tag).and_then(|at| tiff.long(at + 8));
        exif.exposure_s = place(EXPOSURE)
            .map(|at| at as usize)
            .and_then(|at| Some(f64::from(tiff.long(at)?) / f64::from(tiff.long(at + 4)?)))
            .filter(|s| s.is_finite() && *s > 0.0);
        exif.iso = tiff
            .entry(details, ISO)
            .and_then(|at| tiff.word(at + 8))
            .map(u32::from);
        exif.date = place(DATE)
            .map(|at| at as usize)
            .and_then(|at| bytes.get(at..at.checked_add(19)?))
            .filter(|date| date.iter().all(|c| c.is_ascii_digit() || b": ".contains(c)))
            .map(|date| String::from_utf8_lossy(date).into_owned());
        exif
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(tag: u16, kind: u16, value: u32) -> Vec<u8> {
        let mut bytes = Vec::new();
        bytes.extend(tag.to_le_bytes());
        bytes.extend(kind.to_le_bytes());
        bytes.extend(1_u32.to_le_bytes());
        bytes.extend(value.to_le_bytes());
        bytes
    }

    #[test]
    fn turn_exposure_and_date_are_read_and_lies_are_not() {
        let mut bytes = b"Exif\0\0II*\0\x08\0\0\0\x02\0".to_vec();
        bytes.extend(entry(ORIENTATION, 3, 6));
        bytes.extend(entry(DETAILS, 4, 38));
        bytes.extend([0; 4]);
        bytes.extend(3_u16.to_le_bytes());
        bytes.extend(entry(EXPOSURE, 5, 80));
        bytes.extend(entry(ISO, 3, 200));
        bytes.extend(entry(DATE, 2, 88));
        bytes.extend([0; 4]);
        bytes.extend(1_u32.to_le_bytes());
        bytes.extend(50_u32.to_le_bytes());
        bytes.extend(b"2026:11:23 12:00:00\0");
        let exif = Exif::of(&bytes);
        assert_eq!((exif.orientation, exif.iso), (6, Some(200)));
        assert_eq!(exif.exposure_s, Some(0.02));
        assert_eq!(exif.date.as_deref(), Some("2026:11:23 12:00:00"));
        for cut in 0..bytes.len() {
            let part = Exif::of(&bytes[..cut]);
            assert!((1..=8).contains(&part.orientation));
        }
        bytes[24] = 77;
        assert_eq!(Exif::of(&bytes).orientation, 1);
    }
}
