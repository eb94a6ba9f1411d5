//! LI-COR LI-180 text: the layout of [`uprtek`](super::uprtek), whose meters it is built from.
//!
//! ```text
//! Model Name<TAB>LI-180
//! PPFD<TAB>129.879440          the maker's own results, also behind the spectrum
//! 380nm<TAB>27.503876          mW m-2 nm-1 or µmol m-2 s-1 nm-1, told by the totals
//! ```

use super::uprtek::{is_li180, is_meter, read_meter};
use super::{Confidence, Format};
use crate::io::{Input, ReadError, Reading};

pub(crate) const FORMAT: Format = Format::new("LI-COR LI-180", &["txt", "xls"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    Confidence::certain_if(is_li180(input) && is_meter(input))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    read_meter(input, "the LI-180's")
}
