//! Zip archives: members by name, unpacked in memory and never onto the disk.
//!
//! Every byte that comes out is counted: an archive that unfolds to more than its size allows is
//! refused, regardless of its directory. Names are only compared, never used as paths.

use std::io::{Cursor, Read};

use zip::ZipArchive;

use super::guarded::guarded;
use crate::io::{Input, ReadError, budget};
use crate::languages::said;

/// Most members that are examined.
const MOST_MEMBERS: usize = 10_000;

/// True if bytes start like a zip archive.
pub(crate) fn is_zip(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04")
}

/// True if an archive names a member in its first or last part; a quick check, not a search.
pub(crate) fn seems_to_hold(bytes: &[u8], name: &str) -> bool {
    is_zip(bytes) && names(bytes, name)
}

/// The same of bytes that are no archive or an empty one, too.
pub(crate) fn names(bytes: &[u8], name: &str) -> bool {
    let head = &bytes[..bytes.len().min(1 << 16)];
    let tail = &bytes[bytes.len().saturating_sub(1 << 16)..];
    let holds = |part: &[u8]| part.windows(name.len()).any(|w| w == name.as_bytes());
    holds(head) || holds(tail)
}

/// An archive in memory and the bytes that may still be unpacked.
pub(crate) struct Archive<'a, 'b> {
    input: &'a Input<'b>,
    zip: ZipArchive<Cursor<&'a [u8]>>,
    /// Names of the members, in the archive's order.
    pub names: Vec<String>,
    left: usize,
}

impl<'a, 'b> Archive<'a, 'b> {
    /// Opens an archive from which at most `share` of the memory that its size allows may come.
    ///
    /// # Errors
    /// [`ReadError`] when it is broken or has too many members.
    pub(crate) fn open(input: &'a Input<'b>, share: f64) -> Result<Self, ReadError> {
        let zip = guarded(|| ZipArchive::new(Cursor::new(input.bytes)))
            .ok_or_else(|| broken(input, "unreadable"))?
            .map_err(|error| broken(input, &error.to_string()))?;
        if zip.len() > MOST_MEMBERS {
            let found = tr!("an archive of {n} member" | "an archive of {n} members" % zip.len());
            let most = tr!("at most {most}", most = MOST_MEMBERS);
            return Err(input.error(found, most));
        }
        let names = zip
            .file_names()
            .map(|name| name.map_or_else(|_| String::new(), |name| name.into_owned()))
            .collect();
        Ok(Self {
            input,
            zip,
            names,
            left: (budget::of(input.bytes.len()) as f64 * share) as usize,
        })
    }

    /// The content of a member.
    ///
    /// # Errors
    /// [`ReadError`] when it is broken, or too much comes out of the archive.
    pub(crate) fn member(&mut self, index: usize) -> Result<Vec<u8>, ReadError> {
        let mut content = Vec::new();
        self.unpack(index, |piece| content.extend_from_slice(piece))?;
        Ok(content)
    }

    /// Unpacks the members selected by name and keeps nothing: for archives that another
    /// parser opens.
    pub(crate) fn count(&mut self, is_told: impl Fn(&str) -> bool) -> Result<(), ReadError> {
        for index in 0..self.names.len() {
            if is_told(&self.names[index]) {
                self.unpack(index, |_| {})?;
            }
        }
        Ok(())
    }

    fn unpack(&mut self, index: usize, mut take: impl FnMut(&[u8])) -> Result<(), ReadError> {
        let Self {
            input, zip, left, ..
        } = self;
        let outcome = guarded(|| {
            let mut member = zip.by_index(index).map_err(|e| e.to_string())?;
            let mut piece = [0; 16 * 1024];
            loop {
                match member.read(&mut piece).map_err(|e| e.to_string())? {
                    0 => return Ok(true),
                    n if n > *left => return Ok(false),
                    n => {
                        *left -= n;
                        take(&piece[..n]);
                    }
                }
            }
        });
        match outcome.unwrap_or_else(|| Err("unreadable".to_owned())) {
            Ok(true) => Ok(()),
            Ok(false) => {
                let found = said!("an archive that unfolds to far more than its size");
                Err(input.error(found, said(budget::WORDS)))
            }
            Err(why) => Err(broken(input, &why)),
        }
    }
}

fn broken(input: &Input, why: &str) -> ReadError {
    input.error(
        tr!("a broken zip archive ({why})", why),
        said!("a whole one"),
    )
}
