//! What is drawn of a stream: the newest spectrum, quantities over time, and the waterfall.

use super::units::value_label;
use crate::{
    app::{
        chart::{Chart, Dash, Ink, Rgb, Series, curve, stroke},
        live_figures::SUM_MEANS,
    },
    color::srgb_of_fill,
    languages::{fixed, said},
    live::{Course, Jump, Shown, Track, Tracks, clock},
    measurements::{Measurement, Quantity},
    spectrum::Line,
};

/// Tops of the axis within a decade: it stands still while the light flickers.
const TOPS: [f64; 8] = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0];

/// Slanted lines over what is clipped, of the axis each.
const HATCHES: usize = 6;

/// Spans of time of a curve.
const SPANS: usize = 500;

/// Width that a line is drawn with in the waterfall, nm: thinner ones could not be seen.
const LINE_NM: f64 = 5.0;

/// The newest spectrum, or the one that is held, with the highest values so far.
pub fn newest(shown: &Shown, peak: Option<&Measurement>, is_held: bool) -> Chart {
    let samples = &shown.of.samples;
    let points = |of: &Measurement| curve(of.samples.nm().iter().copied(), kept(of));
    let x_range = [samples.first_nm(), samples.last_nm()];
    let both = std::iter::once(&shown.of).chain(peak);
    let values: Vec<f64> = both.flat_map(kept).filter(|v| v.is_finite()).collect();
    let most = values.iter().copied().fold(0.0, f64::max);
    let least = values.iter().copied().fold(0.0, f64::min);
    let top = top_over(most);
    let is_light = shown.of.quantity == Quantity::Light;
    // Alone it is what the title says.
    let name = match (peak.is_none() && shown.clipped.is_empty(), is_held) {
        (true, _) => "",
        (false, true) => said!("held"),
        (false, false) => said!("newest"),
    };
    let mut series = vec![match is_light {
        true => Series::area(name, Ink::Measured, points(&shown.of), Vec::new()).coloured(),
        false => Series::line(name, Ink::Measured, points(&shown.of)),
    }];
    if let Some(peak) = peak {
        series.push(Series::line(
            said!("highest so far"),
            Ink::Second,
            points(peak),
        ));
    }
    let clipped = shown
        .clipped
        .iter()
        .flat_map(|at| hatched(*at, x_range, top));
    let clipped: Vec<[f64; 2]> = clipped.collect();
    if !clipped.is_empty() {
        series.push(stroke(
            said!("clipped"),
            Ink::Spikes,
            clipped,
            1.4,
            Dash::Solid,
        ));
    }
    let steps = (x_range[1] - x_range[0]).ceil().clamp(1.0, 2000.0);
    let nm = |i: usize| x_range[0] + (x_range[1] - x_range[0]) * i as f64 / steps;
    Chart {
        title: match is_held {
            true => tr!(
                "{name}, held at {time}",
                name = shown.of.name,
                time = clock(shown.time_ms)
            ),
            false => tr!("Spectrum of {name}", name = shown.of.name),
        },
        y_label: match shown.of.quantity {
            Quantity::Counts => said!("Counts").to_owned(),
            Quantity::Light => value_label(&shown.of.unit),
            quantity => super::units::kind_label(quantity.kind(), &shown.of.unit),
        },
        y_range: Some([least.min(0.0).max(-top), top]),
        series,
        colours: (0..=steps as usize)
            .map(|i| Ink::Own(srgb_of_fill(nm(i)).0))
            .collect(),
        ..Chart::over_nm(x_range)
    }
}

/// The values, those that the mask leaves out as gaps.
fn kept(of: &Measurement) -> Vec<f64> {
    let values = of.samples.values().iter().enumerate();
    let or_gap = |(i, v): (usize, &f64)| if of.is_kept(i) { *v } else { f64::NAN };
    values.map(or_gap).collect()
}

/// A round number over a value.
fn top_over(most: f64) -> f64 {
    if !(most > 0.0 && most.is_finite()) {
        return 1.0;
    }
    let wanted = 1.04 * most;
    let decade = 10.0_f64.powf(wanted.log10().floor());
    let round = TOPS.iter().map(|top| top * decade);
    round
        .into_iter()
        .find(|top| *top >= wanted)
        .unwrap_or(wanted)
}

/// Slanted lines over a stretch, as wide as it can be seen.
fn hatched([from, to]: [f64; 2], [first, last]: [f64; 2], top: f64) -> Vec<[f64; 2]> {
    let least = (last - first) / 200.0;
    let middle = 0.5 * (from + to);
    let half = (0.5 * (to - from)).max(least);
    let (left, right) = ((middle - half).max(first), (middle + half).min(last));
    let step = top / HATCHES as f64;
    let line = |i: usize| {
        let low = step * i as f64;
        [[left, low], [right, low + step], [right, f64::NAN]]
    };
    let sides = [
        [left, 0.0],
        [left, top],
        [left, f64::NAN],
        [right, 0.0],
        [right, top],
    ];
    let slanted = (0..HATCHES).flat_map(line);
    slanted.chain(sides).chain([[right, f64::NAN]]).collect()
}

/// What tracks are called, with their meaning.
pub fn track_words(track: Track) -> (&'static str, &'static str) {
    match track {
        Track::Y => ("Y", said(SUM_MEANS)),
        Track::Cct => ("CCT", said!("Correlated colour temperature, K.")),
        Track::Glow => (
            said!("Glow"),
            said!("Share of the power that is no line, per cent."),
        ),
        Track::Lines => (
            said!("Lines"),
            said!("Weights of the lines, in the unit of the values x nm."),
        ),
    }
}

/// Every track.
pub const TRACKS: [Track; 4] = [Track::Y, Track::Cct, Track::Glow, Track::Lines];

/// A quantity over time, with the band of its noise, where the light jumps, and a mark at the time
/// of what is held, ms.
pub fn over_time(tracks: &Tracks, track: Track, jumps: &[Jump], held_ms: Option<f64>) -> Chart {
    let curves = tracks.curves(track, SPANS);
    let lines = tracks.lines_nm();
    let [first, last] = ends_ms(tracks);
    let (unit, ms) = match 1e-3 * (last - first) {
        s if s < 300.0 => ("s", 1e3),
        s if s < 10_800.0 => ("min", 60e3),
        _ => ("h", 3600e3),
    };
    let factor = if track == Track::Glow { 100.0 } else { 1.0 };
    let series = curves.into_iter().enumerate().map(|(index, curve)| {
        let points = curve.iter().map(|[t, v]| [t / ms, v * factor]).collect();
        let at = lines.get(index).filter(|_| track == Track::Lines);
        match at {
            Some(nm) => {
                let colour = Ink::Own(srgb_of_fill(*nm).0);
                Series::line(format!("{} nm", fixed(nm, 1)), colour, points)
            }
            None => Series::line("", Ink::Measured, points),
        }
    });
    let mut series: Vec<Series> = series.collect();
    let is_empty = series.iter().all(|series| series.marks.points().len() < 2);
    series.extend(bands(tracks, track, [1.0 / ms, factor]));
    let mut chart = Chart {
        title: match track {
            Track::Y => said!("Y over time"),
            Track::Cct => said!("CCT over time"),
            Track::Glow => said!("Glow over time"),
            Track::Lines => said!("Lines over time"),
        }
        .to_owned(),
        x_label: tr!("Time ({unit})", unit),
        y_label: match track {
            Track::Y => "Y".to_owned(),
            Track::Cct => "CCT (K)".to_owned(),
            Track::Glow => said!("Share of the glow (%)").to_owned(),
            Track::Lines => said!("Weight of the lines").to_owned(),
        },
        x_range: [first / ms, (last / ms).max(first / ms + 1e-3)],
        series,
        blank: match (is_empty, track) {
            (false, _) => String::new(),
            (true, Track::Lines) => said!("No line was found yet.").to_owned(),
            (true, _) => said!("A course begins with the second spectrum of a light.").to_owned(),
        },
        ..Chart::default()
    };
    // A quantity that hardly changes is not stretched to its noise.
    let [low, high] = chart.y_limits();
    chart.y_range = Some(match track {
        Track::Cct => {
            let middle = 0.5 * (low + high);
            let half = (0.5 * (high - low)).max(0.02 * middle);
            [middle - half, middle + half]
        }
        _ => [low.min(0.0), high.max(0.0)],
    });
    if !jumps.is_empty() {
        let [low, high] = chart.y_limits();
        let mark = |jump: &Jump| {
            let at = jump.time_ms / ms;
            [[at, low], [at, high], [at, f64::NAN]]
        };
        let marks = jumps.iter().flat_map(mark).collect();
        let marks = stroke(said!("jumps"), Ink::Faint, marks, 1.2, Dash::Dashed);
        chart.series.push(marks);
    }
    if let (Some(held), Some([low, high]), false) = (held_ms, chart.y_range, is_empty) {
        let at = held / ms;
        let points = vec![[at, low], [at, high]];
        let mark = stroke(said!("held"), Ink::Second, points, 1.6, Dash::Dashed);
        chart.series.push(mark);
    }
    chart
}

/// The bands that hold a quantity 95 times of 100, by the scatter of its frames.
fn bands(tracks: &Tracks, track: Track, [by_time, by_value]: [f64; 2]) -> Vec<Series> {
    let lines = tracks.lines_nm();
    let courses = tracks.courses(track, SPANS).into_iter().enumerate();
    let band = |(index, course): (usize, Option<Course>)| {
        let Course { points, half } = course?;
        let side = |sign: f64| {
            let value = move |at: &[f64; 2]| by_value * (at[1] + sign * half);
            points
                .iter()
                .map(move |at| [by_time * at[0], value(at)])
                .collect::<Vec<_>>()
        };
        let ink = match lines.get(index).filter(|_| track == Track::Lines) {
            Some(nm) => Ink::Own(srgb_of_fill(*nm).0),
            None => Ink::Measured,
        };
        let base = side(-1.0).iter().map(|at| at[1]).collect();
        let name = if index == 0 { "95 %" } else { "" };
        Some(Series::area(name, ink, side(1.0), base))
    };
    courses.filter_map(band).collect()
}

/// The times of the first and the newest frame, ms.
pub fn ends_ms(tracks: &Tracks) -> [f64; 2] {
    let time = |index: usize| tracks.point(index).map_or(0.0, |point| point.time_ms);
    [time(0), time(tracks.len().saturating_sub(1))]
}

/// Wavelengths of the waterfall, nm.
pub const WATERFALL_NM: [f64; 2] = [380.0, 780.0];

/// The stream over time in the colours of its wavelengths, the first frame above: a row for a
/// moment, as bright as the light was there; pixels row by row, none while there is no light.
pub fn waterfall(tracks: &Tracks, [width, height]: [usize; 2]) -> Vec<Rgb> {
    let count = tracks.len();
    if count == 0 || width < 2 || height < 2 {
        return Vec::new();
    }
    let [first, last] = ends_ms(tracks);
    let rows: Vec<Vec<f64>> = at_even_times(tracks, [first, last], height)
        .into_iter()
        .map(|index| values(tracks, index, width))
        .collect();
    // Of a lamp that warms up the last frames are the brightest; one flash must not dim them all.
    let mut tops: Vec<f64> = rows
        .iter()
        .map(|row| row.iter().copied().fold(0.0, f64::max))
        .collect();
    tops.sort_by(f64::total_cmp);
    let top = tops[(tops.len() - 1) * 98 / 100];
    if tops.last() == Some(&0.0) {
        return Vec::new();
    }
    let [from, to] = WATERFALL_NM;
    let nm = |x: usize| from + (to - from) * x as f64 / (width - 1) as f64;
    let colours: Vec<Rgb> = (0..width).map(|x| srgb_of_fill(nm(x)).0).collect();
    let shaded = |(colour, value): (&Rgb, &f64)| {
        let share = if top > 0.0 { value / top } else { 0.0 };
        // By roots, as what is low is to be seen beside lines.
        let share = share.clamp(0.0, 1.0).sqrt();
        colour.map(|part| (f64::from(part) * share).round() as u8)
    };
    let pixels = rows
        .iter()
        .flat_map(|row| colours.iter().zip(row).map(shaded));
    pixels.collect()
}

/// The frame that was there at each of `count` moments.
fn at_even_times(tracks: &Tracks, [first, last]: [f64; 2], count: usize) -> Vec<usize> {
    let mut index = 0;
    let time = |index: usize| tracks.point(index).map_or(f64::INFINITY, |p| p.time_ms);
    (0..count)
        .map(|row| {
            let moment = first + (last - first) * row as f64 / (count - 1) as f64;
            // Halving, as a recording of an hour has 36,000 frames.
            let (mut low, mut high) = (index, tracks.len());
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                match time(middle) <= moment {
                    true => low = middle,
                    false => high = middle,
                }
            }
            index = low;
            index
        })
        .collect()
}

/// A frame's values at even wavelengths.
fn values(tracks: &Tracks, index: usize, width: usize) -> Vec<f64> {
    let Some(point) = tracks.point(index) else {
        return vec![0.0; width];
    };
    let smooth = point.composite.smooth();
    let on_band = smooth.on_band();
    let [from, to] = WATERFALL_NM;
    let nm = |x: usize| from + (to - from) * x as f64 / (width - 1) as f64;
    let line_at = |nm: f64, line: &Line| {
        let is_near = (nm - line.at_nm).abs() <= 0.5 * LINE_NM;
        if is_near { line.weight / LINE_NM } else { 0.0 }
    };
    let lines = point.composite.lines();
    (0..width)
        .map(|x| {
            let nm = nm(x);
            let glow = smooth.band.interpolate(&on_band, nm);
            glow + lines.iter().map(|line| line_at(nm, line)).sum::<f64>()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Sampled;

    fn shown(values: Vec<f64>, clipped: Vec<[f64; 2]>) -> Shown {
        let samples = Sampled::even(400.0, 1.0, values).expect("finite");
        Shown {
            of: Measurement::new("lamp", Quantity::Light, "W m-2 nm-1", samples),
            time_ms: 0.0,
            frames: 1,
            clipped,
            counts: None,
        }
    }

    #[test]
    fn the_axis_stands_still_while_a_light_flickers_and_nothing_leaves_it() {
        let top = |most: f64| {
            let chart = newest(&shown(vec![most; 301], Vec::new()), None, false);
            chart.y_range.expect("set")[1]
        };
        assert_eq!(top(0.81), top(0.93));
        for most in [1e-9, 0.0999, 0.97, 1.0, 9.99, 65_535.0] {
            assert!(
                (1.04..=1.61).contains(&(top(most) / most)),
                "{most}: {}",
                top(most)
            );
        }
        assert_eq!(top(0.0), 1.0);
    }

    #[test]
    fn what_is_clipped_is_hatched_over_its_columns_however_few() {
        let chart = newest(
            &shown(vec![1.0; 301], vec![[500.0, 500.0], [690.0, 700.0]]),
            None,
            false,
        );
        let hatches = chart
            .series
            .iter()
            .find(|s| s.name == "clipped")
            .expect("hatched");
        let at = hatches.marks.points().iter().map(|at| at[0]);
        let ends: Vec<f64> = at.clone().filter(|nm| *nm < 600.0).collect();
        let width = ends.iter().copied().fold(0.0, f64::max) - ends[0];
        // A two hundredth of the axis to each side.
        assert!((width - 3.0).abs() < 1e-9, "{width}");
        assert_eq!(at.fold(0.0, f64::max), 700.0);
        let no = newest(&shown(vec![1.0; 301], Vec::new()), None, false);
        assert!(no.series.iter().all(|series| series.name != "clipped"));
    }

    #[test]
    fn what_is_held_says_so_and_since_when_wherever_it_is_drawn() {
        let mut cut = shown(vec![1.0; 301], vec![[500.0, 500.0]]);
        cut.time_ms = 120_000.0;
        let chart = newest(&cut, None, true);
        assert_eq!(chart.title, "lamp, held at 0:02:00.0");
        assert_eq!(chart.series[0].name, "held");
        let course = over_time(&tracks(), Track::Y, &[], Some(cut.time_ms));
        let mark = course.series.last().expect("a mark");
        assert_eq!(mark.name, "held");
        let at = |index: usize| mark.marks.points()[index];
        // Two minutes, over the whole height.
        let [low, high] = course.y_limits();
        assert_eq!([at(0), at(1)], [[2.0, low], [2.0, high]]);
        let runs = over_time(&tracks(), Track::Y, &[], None);
        assert_eq!(runs.series.len() + 1, course.series.len());
    }

    /// A green light that comes up, and at its end falls dark.
    fn tracks() -> Tracks {
        let mut tracks = Tracks::default();
        for second in 0..600_u32 {
            let share = if second < 590 {
                f64::from(second) / 590.0
            } else {
                0.0
            };
            let value = |nm: i32| share * (-((f64::from(nm) - 530.0) / 40.0).powi(2)).exp();
            let values = (380..=780).map(value).collect();
            let light = Sampled::even(380.0, 1.0, values).expect("finite");
            tracks.push(1000.0 * f64::from(second), &light);
        }
        tracks
    }

    #[test]
    fn curves_over_time_keep_the_ends_of_every_span_of_time() {
        let tracks = tracks();
        let all: Vec<[f64; 2]> = tracks.points().map(|p| [p.time_ms, p.y]).collect();
        let curve = tracks.curves(Track::Y, 20).remove(0);
        assert!(curve.len() <= 40, "{}", curve.len());
        assert!(curve.is_sorted_by(|a, b| a[0] < b[0]));
        for span in all.chunks(30) {
            let most = span.iter().map(|at| at[1]).fold(0.0, f64::max);
            assert!(curve.iter().any(|at| at[1] == most), "{most}");
        }
        let chart = over_time(&tracks, Track::Y, &[], None);
        assert_eq!(chart.x_label, "Time (min)");
        assert!((chart.x_range[1] - 599.0 / 60.0).abs() < 1e-3);
        assert_eq!(
            over_time(&tracks, Track::Lines, &[], None).blank,
            "No line was found yet."
        );
    }

    #[test]
    fn the_waterfall_has_the_colour_of_the_light_and_its_brightness_at_each_moment() {
        let size = [41, 60];
        let pixels = waterfall(&tracks(), size);
        assert_eq!(pixels.len(), size[0] * size[1]);
        // 530 nm is 15 columns of 10 nm from the left.
        let at = |row: usize, column: usize| pixels[row * size[0] + column];
        let green = at(50, 15);
        assert!(
            green[1] > green[0] && green[1] > green[2] && green[1] > 100,
            "{green:?}"
        );
        let sum = |pixel: Rgb| pixel.iter().map(|part| u32::from(*part)).sum::<u32>();
        assert!(sum(at(10, 15)) < sum(green));
        assert!(sum(at(59, 15)) < 10, "{:?}", at(59, 15));
        assert!(sum(at(50, 35)) < sum(green) / 4, "{:?}", at(50, 35));
        assert!(waterfall(&Tracks::default(), size).is_empty());
    }
}
