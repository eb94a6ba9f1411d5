//! zlib streams of a known largest size.

use std::io::{Read, Write};

use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;

use super::super::PictureError;

/// Bytes as a zlib stream, as small as it gets.
pub(super) fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    // Writing to memory does not fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}

/// A zlib stream of at most `most` bytes.
pub(super) fn unpacked(bytes: &[u8], most: usize) -> Result<Vec<u8>, PictureError> {
    let mut out = Vec::new();
    let read = ZlibDecoder::new(bytes)
        .take(most as u64 + 1)
        .read_to_end(&mut out);
    match read {
        Err(error) => Err(PictureError::broken(
            tr!("broken zlib data ({error})", error),
            said!("whole data"),
        )),
        Ok(size) if size > most => Err(PictureError::broken(
            tr!("more than {most} bytes of zlib data", most),
            said!("fewer"),
        )),
        Ok(_) => Ok(out),
    }
}
