//! Any bytes for the readers of pictures in few numbers; the first byte chooses which.
#![no_main]

use libfuzzer_sys::{Corpus, fuzz_target};

#[path = "../pictures.rs"]
mod attacked;
#[path = "../harness.rs"]
#[allow(dead_code, reason = "the other target's half")]
mod harness;

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let Some((first, file)) = bytes.split_first() else {
        return Corpus::Reject;
    };
    let all = attacked::Reader::ALL;
    attacked::attack(all[usize::from(*first) % all.len()], file);
    Corpus::Keep
});
