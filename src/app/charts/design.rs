//! The place "Design" as charts: channels and what they reach among colours, the mixed spectrum.

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Series, Shape, curve, stroke},
        charts::{
            colour::SLIT_NM,
            products::chain::strip,
            quality::diagram,
            spectrum::{on_grid, over},
        },
        design::{
            Desk,
            front::{figure_name, lines_words},
            mix::MixChannel,
        },
        pages::DiagramShows,
    },
    color::{
        Observer, srgb_from_wavelength,
        xyz::{FIRST_NM, xyz_from_nm_values},
    },
    design::{
        mixture::Source,
        solve::{Against, FrontPoint},
    },
    languages::fixed,
    spectrum::Band,
};

/// The diagram without a light, for [`on_diagram`].
pub fn ground() -> Chart {
    let shows = DiagramShows {
        whites: false,
        ..DiagramShows::default()
    };
    diagram(&[], shows)
}

/// The diagram with the channels of a desk, what they reach, the mixture, a target, and the second
/// light with its name.
pub fn on_diagram(
    ground: &Chart,
    desk: &Desk,
    target: Option<[f64; 2]>,
    second: Option<(&str, &Desk)>,
) -> Chart {
    let mut chart = ground.clone();
    let black = [15; 3];
    let point = |name: &str, colour, shape, radius, at| {
        Series::points(name, colour, shape, vec![at]).sized(radius)
    };
    let mut reach = desk.reach.clone();
    reach.extend(desk.reach.first().copied());
    if reach.len() > 2 {
        let edge = stroke(said!("can be mixed"), black, reach, 1.6, Dash::Dashed);
        chart.series.push(edge);
    }
    for (strip, channel) in desk.strips.iter().zip(&desk.mix.channels) {
        let Some(at) = strip.uv else { continue };
        let ink = if desk.mix.is_heard(channel) {
            black
        } else {
            [128; 3]
        };
        let dot = point("", ink, Shape::Dot, 5.5, at);
        chart.series.push(dot.with_notes(vec![strip.title.clone()]));
        let dot = point("", strip.colour.0, Shape::Dot, 4.0, at);
        chart.series.push(dot.with_notes(vec![strip.title.clone()]));
    }
    if let Some(at) = target {
        chart
            .series
            .push(point(said!("target"), black, Shape::Ring, 9.0, at));
    }
    let place = |desk: &Desk| desk.figures.as_ref().and_then(|figures| figures.uv);
    if let Some((name, at)) = second.and_then(|(name, second)| Some((name, place(second)?))) {
        chart.series.push(point("", black, Shape::Dot, 7.0, at));
        let dot = Series::points(name, Ink::Second, Shape::Dot, vec![at]);
        chart.series.push(dot.sized(5.0));
    }
    if let Some(at) = place(desk) {
        chart.series.push(point("", black, Shape::Dot, 7.0, at));
        chart
            .series
            .push(point(said!("mixture"), [255; 3], Shape::Dot, 5.0, at));
    }
    chart.title = said!("Colours that these channels reach").to_owned();
    chart
}

/// The mixture over the wavelengths; lines as a slit of 5 nm sees them. A second light is drawn as
/// bright as the mixture.
pub fn mixed_spectrum(desk: &Desk, second: Option<(&str, &Desk)>) -> Chart {
    let band = Band::VISIBLE;
    let (channels, powers) = desk.lights();
    let mut smooth = desk.values.clone();
    let mut lines = Vec::new();
    for (channel, power) in channels.iter().zip(&powers) {
        let Some(at_nm) = channel.line_nm() else {
            continue;
        };
        let both = smooth.iter_mut().zip(&channel.values);
        both.for_each(|(sum, value)| *sum -= power * value);
        let power = power * channel.power();
        if power > 0.0 {
            lines.push(([at_nm, power / SLIT_NM], power));
        }
    }
    let first = (band.min_nm() - f64::from(FIRST_NM)) as usize;
    // What is left of a line by rounding is none.
    let points = curve(
        band.grid(),
        smooth[first..].iter().map(|value| value.max(0.0)),
    );
    let whole: f64 = desk.values.iter().sum();
    let area = Series::area("", Ink::Measured, points.clone(), Vec::new());
    let mut series = vec![area.coloured()];
    for ((channel, strip), power) in desk
        .mix
        .channels
        .iter()
        .zip(&desk.strips)
        .zip(desk.mix.powers())
    {
        let shape = part(channel, strip.light.as_ref().ok(), power, first);
        if let Some(points) = shape {
            series.push(stroke("", Ink::Faint, points, 1.0, Dash::Dotted));
        }
    }
    series.push(Series::line("", Ink::Text, points));
    let luminance = |desk: &Desk| xyz_from_nm_values(&desk.values, Observer::CIE_1931).y;
    if let Some((name, second)) = second
        && let equal = luminance(desk) / luminance(second)
        && equal.is_finite()
    {
        let points = on_grid(band, &second.values[first..], equal);
        series.push(stroke(name, Ink::Second, points, 2.4, Dash::Solid));
    }
    for (top, power) in lines {
        let colour = srgb_from_wavelength(top[0]).0;
        let label = format!("{}\n{:.0} %", fixed(top[0], 1), 100.0 * power / whole);
        let stem = Series::stems("", colour, vec![top], Vec::new());
        series.push(stem.labelled(vec![label]));
    }
    Chart {
        title: said!("The mixture: drag its lines").to_owned(),
        y_label: said!("Power per nm (lines drawn 5 nm wide)").to_owned(),
        colours: strip(band),
        series,
        ..over(band)
    }
}

/// A channel of the mixture that is no line, as a curve.
fn part(
    channel: &MixChannel,
    light: Option<&crate::design::mixture::Channel>,
    power: f64,
    first: usize,
) -> Option<Vec<[f64; 2]>> {
    let light = light.filter(|_| power > 0.0)?;
    let is_line = matches!(channel.source, Source::Line { .. });
    let points = || on_grid(Band::VISIBLE, &light.values[first..], power);
    (!is_line).then(points)
}

/// What lines at free places reach at best, and where the desk's mixture stands; the first series
/// has the points that can be taken.
pub fn front_chart(points: &[FrontPoint], against: Against, desk: &Desk) -> Chart {
    let name = figure_name(against);
    let known: Vec<(&FrontPoint, f64)> = points
        .iter()
        .filter_map(|point| Some((point, against.of(&point.figures)?)))
        .collect();
    let places: Vec<[f64; 2]> = known
        .iter()
        .map(|(point, value)| [point.figures.ler, *value])
        .collect();
    let note = |(point, value): &(&FrontPoint, f64)| {
        let ler = point.figures.ler;
        format!("{name} {value:.0}, {ler:.0} lm/W: {}", lines_words(point))
    };
    let dots = Series::points(said!("best found"), Ink::Spikes, Shape::Dot, places.clone());
    let mut series = vec![
        dots.with_notes(known.iter().map(note).collect()),
        Series::line("", Ink::Spikes, places.clone()),
    ];
    let here = desk
        .figures
        .as_ref()
        .and_then(|figures| Some([figures.ler, against.of(figures)?]));
    if let Some(here) = here {
        let ring = Series::points(
            said!("the faders now"),
            Ink::Measured,
            Shape::Ring,
            vec![here],
        );
        series.push(ring);
    }
    let all = || places.iter().copied().chain(here);
    let least = all().fold(f64::INFINITY, |least, at| least.min(at[0]));
    let most = all().fold(f64::NEG_INFINITY, |most, at| most.max(at[0]));
    let lowest = all().fold(0.0, |low: f64, at| low.min(at[1]));
    let (title, blank) = match known.is_empty() {
        true => (
            said!("The front"),
            said!("No light of lines has this colour and a figure."),
        ),
        false => (
            said!("The best found with free lines: click a point to take its lines"),
            "",
        ),
    };
    Chart {
        title: title.to_owned(),
        x_label: said!("Efficacy (lm/W)").to_owned(),
        y_label: name.to_owned(),
        x_range: match least < most {
            true => [(least - 10.0).max(0.0), most + 10.0],
            false => [0.0, 683.0],
        },
        y_range: Some([lowest, 100.0]),
        blank: blank.to_owned(),
        series,
        ..Chart::default()
    }
}

/// The channel whose line or LED stands nearest to a place, within a reach.
pub fn held_at(desk: &Desk, at_nm: f64, reach_nm: f64) -> Option<usize> {
    let place = |channel: &MixChannel| match channel.source {
        Source::Line { at_nm } => Some(at_nm),
        Source::Gauss { centre_nm, .. } => Some(centre_nm),
        _ => None,
    };
    let channels = desk.mix.channels.iter().enumerate();
    let found = channels.filter_map(|(i, c)| Some((i, (place(c)? - at_nm).abs())));
    let nearest = found.min_by(|a, b| a.1.total_cmp(&b.1));
    nearest.filter(|(_, off)| *off <= reach_nm).map(|(i, _)| i)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::App;

    #[test]
    fn the_diagram_has_a_point_for_each_channel_and_the_region_between_them() {
        let desk = Desk::of(App::new().document());
        let ground = ground();
        let second = Some(("a lamp", &desk));
        let chart = on_diagram(&ground, &desk, Some([0.2, 0.5]), second);
        let named = |name: &str| chart.series.iter().any(|series| series.name == name);
        assert!(named("can be mixed") && named("mixture") && named("target"));
        assert!(named("a lamp"));
        let noted = chart
            .series
            .iter()
            .filter(|series| !series.notes.is_empty());
        assert_eq!(noted.count(), 2 * desk.strips.len());
    }

    #[test]
    fn an_led_is_held_where_it_stands() {
        let desk = Desk::of(App::new().document());
        assert_eq!(held_at(&desk, 529.0, 8.0), Some(1));
        assert_eq!(held_at(&desk, 490.0, 8.0), None);
    }
}
