//! A light in few words as a chart: what they decode to over what was measured, and what it is made
//! of below.

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Panel, Scale, Series, curve},
        derived::less,
        studies::EncodedLight,
    },
    color::srgb_of_fill,
    spectrum::add_lines,
};

/// Measured and decoded above, decoded less measured below.
pub fn words_chart(name: &str, found: &EncodedLight) -> Chart {
    let encoding = &found.encoded.encoding;
    let band = encoding.band();
    let top = found.measured.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let unit = if top > 0.0 { top } else { 1.0 };
    let points = |values: &[f64]| curve(band.grid(), values.iter().map(|v| v / unit));
    let (floor, measured) = (vec![0.0; band.points()], points(&found.measured));
    let mut series =
        vec![Series::area(said!("measured"), Ink::Measured, measured, floor).coloured()];
    let parts = found.parts.iter().zip((0..).map(Ink::Overlay));
    for ((title, values), ink) in parts {
        series.push(Series::line(title.clone(), ink, points(values)).dashed(Dash::Dashed));
    }
    let smooth = points(&encoding.smooth.on_band());
    series.push(Series::line(said!("short series"), Ink::Smooth, smooth).dashed(Dash::Dotted));
    if !encoding.lines.is_empty() {
        let mut lines = vec![0.0; band.points()];
        add_lines(band, &encoding.lines, &mut lines);
        let name = said!("lines of their own width");
        series.push(Series::line(name, Ink::Residual, points(&lines)).dashed(Dash::Dashed));
    }
    let decoded = points(&found.decoded);
    series.push(Series::line(said!("from the words"), Ink::Model, decoded));
    let off = less(&found.decoded, &found.measured);
    Chart {
        title: tr!(
            "{name} in {words} numbers",
            name,
            words = found.encoded.words.len()
        ),
        x_label: said!("Wavelength, nm").to_owned(),
        y_label: said!("Of the measured peak").to_owned(),
        x_range: [band.min_nm(), band.max_nm()],
        y_scale: scale(&found.measured),
        series,
        colours: band.grid().map(|nm| Ink::Own(srgb_of_fill(nm).0)).collect(),
        residual: Some(Panel {
            y_label: said!("Off by, at 1 nm").to_owned(),
            y_range: None,
            series: vec![Series::line(
                said!("from the words less measured"),
                Ink::Residual,
                points(&off),
            )],
        }),
        ..Chart::default()
    }
}

/// Lines that tower over the mean this many times are drawn over an axis of roots.
const TOWERS: f64 = 6.0;

/// How heights are drawn.
fn scale(measured: &[f64]) -> Scale {
    let top = measured.iter().fold(0.0_f64, |m, v| m.max(*v));
    let mean = measured.iter().sum::<f64>() / measured.len().max(1) as f64;
    if mean > 0.0 && top > TOWERS * mean {
        Scale::Root
    } else {
        Scale::Linear
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{
            App, Command,
            studies::{EncodeAsk, Question},
        },
        study::Progress,
    };

    #[test]
    fn what_is_drawn_adds_up_to_what_the_words_decode_to() {
        let mut app = App::new();
        let light = app.entry("cie_fluorescent_1nm/FL11").expect("shipped");
        app.apply(Command::Show(light));
        let found = EncodeAsk::of(app.document(), 20, true, false).answer(&Progress::default());
        let found = found.expect("not cancelled").expect("a light");
        let chart = words_chart("FL11", &found);
        assert!(chart.title.starts_with("FL11 in "));
        let points = |i: usize| chart.series[i].marks.points();
        let last = chart.series.len() - 1;
        for i in 0..points(0).len() {
            let sum: f64 = (1..last).map(|k| points(k)[i][1]).sum();
            assert!((sum - points(last)[i][1]).abs() < 1e-9, "point {i}");
        }
        let residual = chart.residual.expect("it is off by little");
        let off = residual.series[0].marks.points();
        assert!(off.iter().any(|p| p[1] != 0.0));
        for (i, [_, off]) in off.iter().enumerate() {
            let [decoded, measured] = [last, 0].map(|k| points(k)[i][1]);
            assert!((off - (decoded - measured)).abs() < 1e-12);
        }
    }
}
