//! A spectral picture in few numbers a pixel, under any light: what is looked at, what is kept of
//! it, how it looks then, what it takes, and all of that in sentences.

mod difference;
mod fit;
mod look;
mod shown;
mod store;
mod words;

pub use difference::{NAMED, difference_colours, place_of};
pub use fit::{Fit, FitAsk, TurnAsk, Turned};
pub use look::{LookAsk, Looked, Subject};
pub use shown::{RelitShown, relit_shown};
pub use store::{Form, PeersAsk, PictureWish, StoreAsk, Stored, bytes_words};
pub use words::{
    Rows, byte_rows, fewer, headline, negative_words, peer_rows, speed_line, trust_line,
};

use std::sync::Arc;

use crate::{app::memo::ByAddress, io::many::capitalised, pictures::PictureError};

/// What was found, shared, or why there is nothing, a sentence.
pub type Outcome<T> = Result<ByAddress<T>, String>;

/// What a job answers; `None` where it was cancelled.
fn told<T>(found: Result<T, PictureError>) -> Option<Outcome<T>> {
    match found {
        Ok(found) => Some(Ok(ByAddress(Arc::new(found)))),
        Err(PictureError::Cancelled) => None,
        Err(why) => Some(Err(format!("{}.", capitalised(&why.to_string())))),
    }
}

#[cfg(test)]
mod tests;
