//! What must hold whatever a picture in few numbers holds: one harness for the fuzz target and for
//! `tests/hostile`.
//!
//! [`attack`] hands bytes to the reader of either form, or to that of their header, and panics when
//! a promise is broken: an answer in time and within memory, a refusal of one line, and of what is
//! read all of its numbers.

use std::time::Duration;

use spectral_explorer::pictures::{CompactFile, Header, Picture, PictureError, read_full};
use spectral_explorer::study::Progress;

use crate::harness::{time_of, within};

/// Memory that any file may take, and each of its bytes besides: a flat picture unfolds to a
/// thousand times its size.
const MEMORY_FLOOR: usize = 64 << 20;
const MEMORY_TIMES: usize = 400;

/// Time that any file may take: a header may name 100 lights to weigh by, 45 ms of work, and the
/// fuzzer's checks make it twenty times as much.
const TIME_FLOOR: Duration = Duration::from_millis(if cfg!(debug_assertions) { 1000 } else { 250 });

/// What bytes are handed to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reader {
    /// OpenEXR.
    Full,
    /// PNG with the numbers in private chunks.
    Compact,
    /// The JSON of both: packed, no change of it would ever be read.
    Header,
}

impl Reader {
    /// All of them, in the order of the fuzzer's first byte.
    pub(crate) const ALL: [Self; 3] = [Self::Full, Self::Compact, Self::Header];
}

/// Hands bytes to a reader; whether it read them.
///
/// # Panics
/// When a promise is broken.
pub(crate) fn attack(reader: Reader, bytes: &[u8]) -> bool {
    let allowed = MEMORY_FLOOR + MEMORY_TIMES * bytes.len();
    let time = TIME_FLOOR + time_of(bytes.len());
    let bounded =
        |read: &dyn Fn() -> Result<Picture, PictureError>| judge(within(allowed, time, read));
    match reader {
        Reader::Full => bounded(&|| read_full(bytes)),
        Reader::Compact => {
            let opened = |bytes: Vec<u8>| {
                let file = CompactFile::open(bytes)?;
                file.picture(&Progress::default())
            };
            let as_it_is = bounded(&|| opened(bytes.to_vec()));
            bounded(&|| opened(mended(bytes.to_vec()))) || as_it_is
        }
        Reader::Header => {
            let text = String::from_utf8_lossy(bytes);
            let led = within(allowed, time, || {
                Header::from_json(&text).and_then(|header| header.operator())
            });
            led.map_err(|why| is_line(&why)).is_ok()
        }
    }
}

/// Every chunk's check sum made right again: what reads the chunk is to see the change.
fn mended(mut bytes: Vec<u8>) -> Vec<u8> {
    let mut at = 8;
    while let Some(head) = bytes.get(at..at + 8) {
        let length = u32::from_be_bytes(head[..4].try_into().unwrap_or_default()) as usize;
        let end = (at + 8).saturating_add(length);
        if end + 4 > bytes.len() {
            break;
        }
        let mut check = flate2::Crc::new();
        check.update(&bytes[at + 4..end]);
        bytes[end..end + 4].copy_from_slice(&check.sum().to_be_bytes());
        at = end + 4;
    }
    bytes
}

/// A refusal is one line that says what was expected; what is read has all of its numbers.
fn judge(read: Result<Picture, PictureError>) -> bool {
    match read {
        Ok(picture) => {
            assert_eq!(
                picture.planes.len(),
                picture.pixels() * picture.header.numbers
            );
            // The header alone leads to the bands, or says why not.
            if let Err(why) = picture.header.operator() {
                is_line(&why);
            }
            true
        }
        Err(why) => {
            is_line(&why);
            false
        }
    }
}

fn is_line(why: &PictureError) {
    let said = why.to_string();
    assert!(!said.is_empty() && !said.contains('\n'), "{said:?}");
    assert!(said.chars().count() < 1000, "{said:?} is long");
}
