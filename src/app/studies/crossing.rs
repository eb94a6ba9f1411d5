//! How a question crosses to another instance of the program, and its answer back: as bytes.

use serde::{Serialize, de::DeserializeOwned};

use crate::languages::spoken;

/// How a kind of question crosses, and its answer.
pub struct Crossing<Q, A> {
    /// The word by which the other side knows the kind.
    pub kind: &'static str,
    /// The bytes of the language that is spoken and of a question.
    pub asked: fn(&Q) -> Option<Vec<u8>>,
    /// What came back; `Some(None)` where there is no answer.
    pub found: fn(&[u8]) -> Option<Option<A>>,
}

impl<Q: Serialize, A: DeserializeOwned> Crossing<Q, A> {
    /// As JSON, whose numbers are read as the same bits that were written.
    pub fn of(kind: &'static str) -> Self {
        Self {
            kind,
            asked: |question| serde_json::to_vec(&(spoken(), question)).ok(),
            found: |bytes| serde_json::from_slice(bytes).ok(),
        }
    }
}
