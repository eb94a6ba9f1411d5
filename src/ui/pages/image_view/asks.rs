//! What the page asks to be computed on a thread of its own.

use std::sync::Arc;

use super::{PageContext, Shown};
use crate::app::{
    ByAddress,
    picture::{MOST_SIDE, Raster, RasterAsk, RegionAsk, RegionSpectrum, Source},
    studies::Stage,
};

/// The picture of what is shown, no side longer than `most_side`; `None` until it is there.
pub(super) fn raster(
    context: &mut PageContext<'_>,
    shown: &Shown,
    most_side: usize,
) -> Option<Arc<Raster>> {
    let source = match &shown.weights {
        Some(weights) if shown.bands.is_empty() => Source::TrueColour(weights.clone()),
        _ => Source::Bands(shown.bands.clone()),
    };
    let ask = RasterAsk {
        image: ByAddress(shown.entry.image.clone()),
        source,
        most_side: most_side.min(MOST_SIDE),
    };
    let job = context.put(&ask);
    // The picture of another image is none of this one.
    let (key, raster) = job.answer()?;
    (key.image == ask.image).then(|| raster.clone())
}

/// The spectrum of the chosen pixels; `None` until it is there.
pub(super) fn region(context: &mut PageContext<'_>, shown: &Shown) -> Option<Arc<RegionSpectrum>> {
    let document = context.app.document();
    let ask = RegionAsk {
        image: ByAddress(shown.entry.image.clone()),
        rect: shown.rect,
        settings: document.settings,
        light: ByAddress(document.light.clone()),
    };
    let job = context.put(&ask);
    let (key, region) = job.answer()?;
    let impossible = job.stage() == Stage::Impossible;
    (key.image == ask.image && !impossible).then(|| region.clone())
}
