//! What lines at free places are found to reach at best: the trade between efficacy and colour
//! rendering, as a job.

use super::{
    mix::{FULL, Mix, MixChannel},
    wish::MixWish,
};
use crate::{
    app::{
        document::Document,
        studies::{Crossing, Question},
    },
    design::{
        SampleTables,
        mixture::Source,
        solve::{Against, FrontPoint, FrontProblem, front},
    },
    languages::fixed,
    study::Progress,
};

/// Points of the front.
const POINTS: usize = 12;

/// The front that a wish asks for; `None` without a colour.
pub fn front_ask(wish: &MixWish, document: &Document) -> Option<FrontProblem> {
    Some(FrontProblem {
        target: wish.target(document).ok()?,
        against: wish.against,
        lines: wish.lines,
        points: POINTS,
        floors: None,
    })
}

impl Question for FrontProblem {
    type Answer = Result<Vec<FrontPoint>, String>;

    /// The front, or why there is none; `None` when it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Self::Answer> {
        match front(self, SampleTables::shipped(), progress) {
            Ok(found) => Some(Ok(found?)),
            Err(why) => Some(Err(tr!("There is no front: {why}.", why))),
        }
    }

    fn crossing() -> Option<Crossing<Self, Self::Answer>> {
        Some(Crossing::of("front"))
    }
}

/// The name of the figure that efficacy is traded for.
pub fn figure_name(against: Against) -> &'static str {
    match against {
        Against::Rf => "Rf",
        Against::Ra => "Ra",
    }
}

/// A light of the front on the desk.
pub fn on_desk(point: &FrontPoint) -> Mix {
    let greatest = point.lines.iter().map(|line| line.share_of_power);
    let greatest = greatest.fold(0.0, f64::max);
    let lines = point.lines.iter().map(|line| MixChannel {
        level: FULL * line.share_of_power / greatest,
        ..MixChannel::new(Source::Line { at_nm: line.at_nm })
    });
    Mix {
        channels: lines.collect(),
        gels: Vec::new(),
    }
}

/// The lines of a point in words.
pub fn lines_words(point: &FrontPoint) -> String {
    let lines = point.lines.iter();
    let lines =
        lines.map(|l| format!("{} nm {:.0} %", fixed(l.at_nm, 1), 100.0 * l.share_of_power));
    lines.collect::<Vec<_>>().join(", ")
}

/// The front in a sentence.
pub fn sentence(points: &[FrontPoint], ask: &FrontProblem) -> String {
    let name = figure_name(ask.against);
    let told = |point: &FrontPoint| {
        let value = ask.against.of(&point.figures);
        let value = value.map_or_else(|| "-".to_owned(), |value| format!("{value:.0}"));
        tr!(
            "{figure} {value} at {efficacy} lm/W",
            figure = name,
            value,
            efficacy = fixed(point.figures.ler, 0)
        )
    };
    match (points.first(), points.last()) {
        (Some(first), Some(last)) => tr!(
            "The best found with {count} lines of this colour: {first} ({lines}) to {last}.",
            count = ask.lines,
            first = told(first),
            lines = lines_words(first),
            last = told(last)
        ),
        _ => said!("No lines make this colour.").to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{App, design::desk};

    #[test]
    fn a_point_of_the_front_on_the_desk_has_the_figures_of_the_point() {
        let mut app = App::new();
        let ask = front_ask(&MixWish::default(), app.document()).expect("a colour");
        let ask = FrontProblem { points: 2, ..ask };
        let found = ask.answer(&Progress::default()).expect("not cancelled");
        let points = found.expect("a front");
        assert!(sentence(&points, &ask).contains("3 lines"));
        for point in &points {
            let shown = desk::put_on_desk(&mut app, on_desk(point));
            let figures = shown.figures.expect("it shines");
            // The same sums in another order and scale.
            assert!((figures.ler - point.figures.ler).abs() < 1e-6);
            let [a, b] = [figures.rf, point.figures.rf].map(|rf| rf.expect("near white"));
            assert!((a - b).abs() < 1e-6);
        }
    }
}
