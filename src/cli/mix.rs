//! `mix`: channels mixed to a light of a colour, and what lines can reach at best.

use std::{fmt::Write as _, io::Write, path::Path};

use super::{
    arguments::Mix, inputs::Inputs, print, print_json, refusal::Refusal, subject,
    words::numbers_with_commas,
};
use crate::{
    app::{Library, design::wish::MixWish, numbers::decimals},
    color::xyz::{FIRST_NM, LAST_NM},
    design::{
        SampleTables,
        mixture::{Channel, MixError, Source, Spec, left_out},
        solve::{
            Against, Care, Floors, FrontPoint, FrontProblem, MixFigures, Mixer, Problem, Solution,
            Target, faders, front, front_json, mix_json,
        },
    },
    spectrum::{Outside, Sampled},
    study::Progress,
};

/// Points of a front.
const POINTS: usize = 12;

/// The colour of a front where none is told, K.
const USUAL_KELVIN: f64 = 4000.0;

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a channel or a target that makes no sense or cannot be read.
pub(super) fn run(options: &Mix, out: &mut dyn Write, inputs: &mut Inputs) -> Result<(), Refusal> {
    let target = options.target.as_deref();
    let target = target
        .map(|word| target_of(word, options.duv, inputs))
        .transpose()?;
    if let (Some(against), Some(lines)) = (options.front, options.lines) {
        return of_front(against, lines, target, options.json, out);
    }
    let words = options.channels.iter();
    let channels: Vec<Channel> = words
        .map(|word| channel(word, inputs))
        .collect::<Result<_, _>>()?;
    let mut floors = Floors::default();
    for floor in &options.floors {
        floors = floors
            .with(floor)
            .map_err(|why| Refusal::Usage(format!("--floor: {why}")))?;
    }
    let alike = target.as_ref().and_then(|target| target.light.as_ref());
    // Told what to favour, a light is a colour and no more.
    let alike = alike.filter(|_| options.favour.is_none());
    let alike = alike.map(|light| light.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero));
    // Without a colour nothing is solved, so that no floor can be kept.
    if target.is_none() {
        floors = Floors::default();
    }
    let wish = Problem {
        target: target.map(|target| target.colour),
        objective: options.favour.unwrap_or(MixWish::default().favour),
        floors,
        alike: alike.as_deref(),
        care: Care::Full,
    };
    let mixer = Mixer::new(&channels, SampleTables::shipped()).map_err(Refusal::usage)?;
    let solution = mixer.solve(&wish);
    let left_out = 100.0 * left_out(&channels, &solution.weights);
    if left_out >= 0.01 {
        inputs.note(format!(
            "composite: {left_out:.2} % of the power lies outside 380-780 nm and is left out"
        ));
    }
    if options.json {
        return print_json(out, &mix_json(&channels, &solution));
    }
    print(out, &text(&channels, &solution))
}

/// A colour to be met, and the light that it is of.
struct Wanted {
    colour: Target,
    light: Option<Sampled>,
}

/// `--target`: a temperature, x,y or a light.
fn target_of(word: &str, duv: Option<f64>, inputs: &mut Inputs) -> Result<Wanted, Refusal> {
    let colour = |colour: Result<Target, MixError>| {
        let colour = colour.map_err(|why| Refusal::Usage(format!("--{why}")))?;
        Ok(Wanted {
            colour,
            light: None,
        })
    };
    let kelvin = word
        .strip_suffix(['K', 'k'])
        .map(|k| k.trim().parse::<f64>());
    if let Some(Ok(kelvin)) = kelvin {
        return colour(Target::of_kelvin(kelvin, duv.unwrap_or(0.0)));
    }
    if duv.is_some() {
        return Err(Refusal::Usage(
            "--duv: found a target that is no temperature, expected one such as 4000K".to_owned(),
        ));
    }
    if let Some([x, y]) = numbers_with_commas(word).as_deref() {
        return colour(Target::of_xy([*x, *y]));
    }
    let light = subject::light("--target", word.as_ref(), inputs)?
        .spectrum
        .samples;
    let colour = Target::of_light(&light).map_err(|why| Refusal::File(format!("--{why}")))?;
    Ok(Wanted {
        colour,
        light: Some(light),
    })
}

fn channel(word: &str, inputs: &mut Inputs) -> Result<Channel, Refusal> {
    let refused = |why: MixError| Refusal::Usage(format!("--channel: {why}"));
    // A name that is there is taken as it stands, whatever signs are in it.
    let is_there = Path::new(word).exists() || Library::bundled().find(word).is_ok();
    let spec = if is_there {
        Spec::named(word)
    } else {
        word.parse().map_err(refused)?
    };
    let light = match &spec.source {
        Source::Named(name) => Some(subject::light("--channel", name.as_ref(), inputs)?),
        _ => None,
    };
    let table = light.as_ref().map(|light| &light.spectrum.samples);
    Channel::new(spec, table).map_err(refused)
}

fn of_front(
    against: Against,
    lines: usize,
    target: Option<Wanted>,
    json: bool,
    out: &mut dyn Write,
) -> Result<(), Refusal> {
    let target = match target {
        Some(target) => target.colour,
        None => Target::of_kelvin(USUAL_KELVIN, 0.0).map_err(Refusal::usage)?,
    };
    let wish = FrontProblem {
        target,
        against,
        lines,
        points: POINTS,
        floors: None,
    };
    let points =
        front(&wish, SampleTables::shipped(), &Progress::default()).map_err(Refusal::usage)?;
    let points = points.unwrap_or_default();
    if json {
        return print_json(out, &front_json(&points));
    }
    print(out, &front_text(&points))
}

/// A mixture in words: the faders, its figures, whether it is what was asked for.
fn text(channels: &[Channel], solution: &Solution) -> String {
    let widest = channels.iter().map(|c| c.spec.words.chars().count()).max();
    let width = widest.unwrap_or(0).max("channel".len());
    let mut text = format!(
        "{:<width$} {:>12} {:>8} {:>8} {:>6} {:>7}\n",
        "channel", "power", "share", "drive", "DMX", "DMX 16"
    );
    for fader in faders(channels, &solution.weights) {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:<width$} {:>12.6} {:>6.2} % {:>6.2} % {:>6} {:>7}",
            fader.spec,
            fader.weight,
            100.0 * fader.share_of_power,
            fader.drive_percent,
            fader.dmx_8,
            fader.dmx_16
        );
    }
    let MixFigures {
        cct,
        ra,
        rf,
        rg,
        ler,
        melanopic_der,
        ..
    } = &solution.figures;
    let _ = writeln!(
        text,
        "\nCCT {} K, Duv {}; Ra {}, Rf {}, Rg {}; {ler:.1} lm/W, melanopic DER {melanopic_der:.3}\n{}",
        decimals(cct.map(|cct| cct.kelvin), 0),
        decimals(cct.map(|cct| cct.duv), 4),
        decimals(*ra, 1),
        decimals(*rf, 1),
        decimals(*rg, 1),
        solution.why
    );
    text
}

fn front_text(points: &[FrontPoint]) -> String {
    let mut text = format!("{:>7} {:>6} {:>6} {:>6}  lines\n", "lm/W", "Rf", "Ra", "Rg");
    for point in points {
        let lines = point.lines.iter();
        let lines: Vec<String> = lines
            .map(|line| format!("{:.1} nm {:.1} %", line.at_nm, 100.0 * line.share_of_power))
            .collect();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:>7.1} {:>6} {:>6} {:>6}  {}",
            point.figures.ler,
            decimals(point.figures.rf, 1),
            decimals(point.figures.ra, 1),
            decimals(point.figures.rg, 1),
            lines.join(", ")
        );
    }
    text
}
