//! Where the tips of the spikes stand, with the doubt of their weights.

use crate::{
    app::{
        App,
        chart::{Dash, Ink, Series, stroke},
    },
    measurements::{LineWithDoubt, OF_95},
    spectrum::Line,
};

/// Width of a whisker's ends, of the range, and how far its line may stand from the spike, nm.
const WHISKER: f64 = 0.004;
const SAME_NM: f64 = 2.0;

/// Where the tips of the spikes stand 95 times of 100; none where no line's doubt is known.
pub(super) fn whiskers(app: &App) -> Option<Series> {
    let (derived, doubted) = (app.derived(), &app.told()?.doubted);
    let (band, factor) = (derived.band, app.scale_factor());
    let half = WHISKER * (band.max_nm() - band.min_nm());
    let whisker = |spike: &Line| {
        let at = spike.at_nm;
        let away = |line: &&LineWithDoubt| (line.at_nm - at).abs();
        let near = doubted.iter().filter(|line| away(line) <= SAME_NM);
        let near = near.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        let [_, u, _] = near.u?;
        let base = factor * band.interpolate(&derived.smooth, at);
        let [low, high] = [-OF_95 * u, OF_95 * u].map(|off| {
            let line = Line::new(at, spike.weight + off, spike.fwhm_nm);
            base + factor * line.stem_height(derived.stem_width_at(at))
        });
        let gap = [at, f64::NAN];
        let end = |y: f64| [[at - half, y], [at + half, y], gap];
        Some([end(high), [[at, high], [at, low], gap], end(low)].concat())
    };
    let points: Vec<_> = derived.model.lines().iter().filter_map(whisker).collect();
    let points = points.concat();
    (!points.is_empty()).then(|| {
        stroke(
            said!("tips of the lines, 95 %"),
            Ink::Text,
            points,
            1.4,
            Dash::Solid,
        )
    })
}
