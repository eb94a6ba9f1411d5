//! Pictures in few numbers, both forms, changed in the ways in which files break: refused in one
//! line or read, in time and within memory.

use std::io::Cursor;

use spectral_explorer::pictures::*;
use spectral_explorer::study::Progress;

use crate::{harness::within, mutate::Mutator, runs};

/// What the compact form promises: a flat picture unfolds to a thousand times its size.
const MEMORY_FLOOR: usize = 64 << 20;
const MEMORY_TIMES: usize = 400;

const WORDS: &[&str] = &[
    "composite-picture",
    "\"version\":",
    "\"width\":",
    "\"numbers\":",
    "\"series\":",
    "bands_nm",
    "values",
    "quantiser",
    "inverse",
    "\"tile\":",
    "\"mask\":true,",
    "csPH",
    "csPT",
    "CS.000",
    "null",
    "1e308",
];

/// A small wall in both forms, and the header of each.
struct Seeds {
    full: Vec<u8>,
    compact: Vec<u8>,
    header: String,
}

fn seeds() -> Seeds {
    let quiet = Progress::default();
    let nm = (0..12).map(|j| 400.0 + 25.0 * f64::from(j)).collect();
    let wall = InMemory::of(&Scene::reflectance(20, 14, nm).expect("bands")).expect("pixels");
    let survey = Survey::of(&wall, &quiet).expect("measured");
    let operator = Operator::new(wall.bands(), &Plan::new(wall.bands(), 5)).expect("solved");
    let about = About::default();
    let plan = compact_plan(&wall, &operator, &survey.sample, 0.5, 1.0, &quiet).expect("a plan");
    let mut compact = Vec::new();
    let coder = Coder::Fitted;
    write_compact(&mut compact, &wall, &operator, &plan, &about, coder, &quiet).expect("written");
    let sample: Vec<Vec<f64>> = survey
        .sample
        .iter()
        .map(|p| operator.numbers_of(p))
        .collect();
    let mut full = Cursor::new(Vec::new());
    let kept = (Precision::Half, Half::of(&sample));
    let said = (&about, plan.error);
    write_full(&mut full, &wall, &operator, kept, said, &quiet).expect("written");
    let header = CompactFile::open(compact.clone()).expect("it opens").header;
    Seeds {
        full: full.into_inner(),
        compact,
        header: header.to_json(),
    }
}

/// Every chunk's check sum made right again: what reads the chunk is to see the change.
fn mended(mut bytes: Vec<u8>) -> Vec<u8> {
    let mut at = 8;
    while let Some(head) = bytes.get(at..at + 8) {
        let length = u32::from_be_bytes(head[..4].try_into().expect("four bytes")) as usize;
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
fn judge(read: Result<Picture, PictureError>) {
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
        }
        Err(why) => is_line(&why),
    }
}

fn is_line(why: &PictureError) {
    let said = why.to_string();
    assert!(!said.is_empty() && !said.contains('\n'), "{said:?}");
    assert!(said.chars().count() < 1000, "{said:?} is long");
}

#[test]
fn changed_pictures_in_few_numbers_are_refused_or_read_whole() {
    let seeds = seeds();
    let quiet = Progress::default();
    let compact = |bytes: &[u8]| {
        let file = CompactFile::open(bytes.to_vec())?;
        file.picture(&quiet)
    };
    judge(read_full(&seeds.full));
    judge(compact(&seeds.compact));
    let allowed = |bytes: usize| MEMORY_FLOOR + MEMORY_TIMES * bytes;
    let mut mutator = Mutator::new(WORDS);
    let mut opened = 0;
    for _ in 0..runs() {
        let bytes = mutator.mutate(std::slice::from_ref(&seeds.full));
        let read = within(allowed(bytes.len()), bytes.len(), || read_full(&bytes));
        opened += usize::from(read.is_ok());
        judge(read);
        let changed = mutator.mutate(std::slice::from_ref(&seeds.compact));
        for bytes in [mended(changed.clone()), changed] {
            let read = within(allowed(bytes.len()), bytes.len(), || compact(&bytes));
            opened += usize::from(read.is_ok());
            judge(read);
        }
        // Packed, no change of the header's text would ever be read.
        let text = mutator.mutate(&[seeds.header.clone().into_bytes()]);
        let text = String::from_utf8_lossy(&text).into_owned();
        let led = within(allowed(text.len()), text.len(), || {
            Header::from_json(&text)?.operator()
        });
        opened += usize::from(led.is_ok());
        if let Err(why) = led {
            is_line(&why);
        }
    }
    assert!(opened > 0, "some changes do no harm, and are read");
}
