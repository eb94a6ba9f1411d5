//! What the page asks to be computed on a thread of its own.

use std::sync::Arc;

use super::{PageContext, Shown};
use crate::{
    app::{
        picture::{Held, MOST_SIDE, ProbeAsk, Probed, Raster, RasterAsk, Source},
        studies::{Same, Stage},
    },
    study::Progress,
};

/// The picture of what is shown, no side longer than `most_side`; `None` until it is there.
pub(super) fn raster(
    context: &mut PageContext<'_>,
    shown: &Shown,
    most_side: usize,
) -> Option<Arc<Raster>> {
    let source = match &shown.eye {
        Some(eye) if shown.bands.is_empty() => Source::Eye(eye.clone()),
        _ => Source::Bands(shown.bands.clone()),
    };
    let ask = RasterAsk {
        image: Held(shown.entry.image.clone()),
        source,
        most_side: most_side.min(MOST_SIDE),
    };
    let job = &mut context.studies.raster;
    job.ask(&ask, context.wake, || {
        let ask = ask.clone();
        move |progress: &Progress| ask.answer(progress)
    });
    // The picture of another image is none of this one.
    let (key, raster) = job.answer()?;
    (key.image == ask.image).then(|| raster.clone())
}

/// The spectrum of the chosen pixels; `None` until it is there.
pub(super) fn probe(context: &mut PageContext<'_>, shown: &Shown) -> Option<Arc<Probed>> {
    let document = context.app.document();
    let ask = ProbeAsk {
        image: Held(shown.entry.image.clone()),
        rect: shown.rect,
        settings: document.settings,
        light: Same(document.light.clone()),
    };
    let job = &mut context.studies.probe;
    job.ask(&ask, context.wake, || {
        let ask = ask.clone();
        move |progress: &Progress| ask.answer(progress)
    });
    let (key, probed) = job.answer()?;
    let impossible = job.stage() == Stage::Impossible;
    (key.image == ask.image && !impossible).then(|| probed.clone())
}
