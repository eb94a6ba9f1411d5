//! `picture`: a spectral picture in few numbers a pixel, and such a picture under another light.

use std::{fmt::Write as _, io::Write, path::Path};

use super::{
    arguments::Picture,
    inputs::Inputs,
    picture_input::{about, is_wall, light_of},
    picture_relit, print,
    refusal::Refusal,
    room_words::Lines,
    target::{Replaces, Target},
    watch::watched,
};
use crate::{
    app::ticks::short,
    io::{Choices, envi, name_of, shown},
    pictures::{
        About, Asked, BOUND_P95, BOUND_RMS, Bytes, CompactPlan, EnviFile, Errors, Exactly,
        FixedSettings, Half, Illuminant, InMemory, LineChoice, OfImage, Operator, Peer,
        PictureError, Pixels, Plan, Precision, ReferenceKind, Scene, Survey, Trust, choose,
        compact_plan, exact_bytes, measure, peers, peers_json, picture_json, save_compact,
        save_full, white_y_of,
    },
    study::Progress,
};

/// The light whose relighting is said how far to trust.
const TRUSTED_UNDER: &str = "A";

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a picture or a light that cannot be read, what cannot be kept in few numbers,
/// and a file that cannot be written.
pub(super) fn run(
    options: &Picture,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let target = options.out.as_deref().map(|path| target(options, path));
    if let Some(target) = &target {
        target.path()?;
    }
    if let (Some(light), Some(target)) = (&options.relight, &target) {
        return picture_relit::run(options, light, target, out, inputs);
    }
    let light = match &options.light {
        Some(word) => Some(light_of("--light", word, inputs)?),
        None => None,
    };
    let light = light.as_ref();
    with_pixels(options, light, inputs, |pixels, about, inputs| {
        let target = target.as_ref();
        let told =
            watched(|progress| of_pixels(options, pixels, about, light, target, inputs, progress))?;
        let Some(target) = target else {
            return print(out, &told);
        };
        let wrote = format!("Wrote {}.", shown(target.path));
        if options.json {
            inputs.note(wrote);
            return print(out, &told);
        }
        print(out, &format!("{told}{wrote}\n"))
    })
}

fn target<'a>(options: &'a Picture, path: &'a Path) -> Target<'a> {
    let read = [
        Some(options.input.as_os_str()),
        options.light.as_deref(),
        options.relight.as_deref(),
    ];
    Target::out(path, Replaces::Nothing, options.force, &read)
}

/// Opens the picture: a cube on disk stays there, others are read whole, and the wall is made.
/// `work` is told whether the kind of the values is only guessed.
fn with_pixels(
    options: &Picture,
    light: Option<&Illuminant>,
    inputs: &mut Inputs,
    work: impl FnOnce(&dyn Pixels, (About, bool), &mut Inputs) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    let path = options.input.as_path();
    if is_wall(path) {
        let wall = Scene::at_hand(light).map_err(about(path))?;
        let said = About {
            source: wall.name().to_owned(),
            ..About::default()
        };
        let pixels = InMemory::of(&wall).map_err(about(path))?;
        return work(&pixels, (said, false), inputs);
    }
    // A picture goes to others: where it lay on this machine is nobody's business.
    let source = name_of(path);
    if envi::pair_of(path).is_some() {
        let file = EnviFile::open(path, options.all_bands, options.kind).map_err(about(path))?;
        file.notes().iter().for_each(|said| inputs.note(said));
        let about = About {
            unit: file.unit().to_owned(),
            source,
            noise: 0.0,
        };
        return work(&file, (about, file.is_kind_guessed()), inputs);
    }
    let choices = Choices {
        kind: options.kind,
        ..Choices::default()
    };
    let reading = inputs.reading(path, &choices).map_err(Refusal::file)?;
    let Some(image) = reading.images.first() else {
        return Err(Refusal::File(format!(
            "{}: found no spectral image, expected one",
            shown(path)
        )));
    };
    let understood = reading.images_understood.first();
    let is_guess = understood.is_some_and(|of| of.kind.is_guess());
    // The first is the line about its size.
    image
        .notes
        .iter()
        .skip(1)
        .for_each(|said| inputs.note(said));
    let pixels = OfImage::new(image, options.all_bands).map_err(about(path))?;
    pixels.notes().iter().for_each(|said| inputs.note(said));
    let about = About {
        unit: image.unit.clone(),
        source,
        noise: 0.0,
    };
    work(&pixels, (about, is_guess), inputs)
}

/// Carries the command out on pixels; what it prints.
fn of_pixels(
    options: &Picture,
    pixels: &dyn Pixels,
    (said, is_guess): (About, bool),
    light: Option<&Illuminant>,
    target: Option<&Target>,
    inputs: &mut Inputs,
    progress: &Progress,
) -> Result<String, Refusal> {
    let refused = about(&options.input);
    let survey = Survey::of(pixels, progress).map_err(&refused)?;
    let plan =
        plan(options, pixels, &survey, light, (inputs, progress)).map_err(|why| match why {
            PictureError::Numbers { .. } => Refusal::Usage(format!("--numbers: {why}")),
            PictureError::LineOutside { .. } | PictureError::TooManyLines { .. } => {
                Refusal::Usage(format!("--lines: {why}"))
            }
            PictureError::NoRelighting(_) => Refusal::Usage(format!("--reference: {why}")),
            why => refused(why),
        })?;
    let operator = Operator::steady(pixels.bands(), &plan).map_err(&refused)?;
    if options.peers {
        let peers = peers(pixels, &operator, &survey, progress).map_err(&refused)?;
        return Ok(match options.json {
            true => format!("{:#}\n", peers_json(&peers)),
            false => peers_words(&peers),
        });
    }
    let noise = survey.usual_noise();
    let said = (&operator, About { noise, ..said });
    let kept = kept(options, pixels, said, &survey, target, progress).map_err(&refused)?;
    if kept.is_single {
        inputs.note(
            "the numbers of the full form have 32 bits: with 16 its own colour would pass the bound",
        );
    }
    let trust = trust(&operator, &survey, light);
    let trust = trust.map(|trust| if is_guess { trust.of_a_guess() } else { trust });
    if options.json {
        let json = picture_json(&operator, kept.bytes, &kept.error, noise, trust.as_ref());
        return Ok(format!("{json:#}\n"));
    }
    Ok(words(&operator, &kept, trust.as_ref()))
}

/// What is kept of every pixel: the best within the bound or of so many numbers, but for what is
/// told by hand.
fn plan(
    options: &Picture,
    pixels: &dyn Pixels,
    survey: &Survey,
    light: Option<&Illuminant>,
    (inputs, progress): (&mut Inputs, &Progress),
) -> Result<Plan, PictureError> {
    let bands = pixels.bands();
    let is_factor = bands.is_factor();
    let mut base = Plan::new(bands, 3);
    if let Some(light) = light.filter(|_| is_factor) {
        base.own = Some(light.clone());
    }
    let wish = FixedSettings {
        reference: options.reference,
        lines: match &options.lines {
            None => LineChoice::Best,
            Some(Lines::None) => LineChoice::None,
            Some(Lines::Auto) => LineChoice::Found,
            Some(Lines::At(places)) => LineChoice::At(places.clone()),
        },
    };
    let asked = match options.numbers {
        Some(numbers) => Asked::Budget(numbers),
        None => Asked::Bound {
            p95: options.bound.unwrap_or(BOUND_P95),
            rms: BOUND_RMS,
        },
    };
    let known = light.filter(|_| !is_factor);
    let choice = choose(bands, survey, known, (&base, &wish), asked, progress)?;
    choice.notes.iter().for_each(|said| inputs.note(said));
    if !choice.is_reached && options.numbers.is_none() {
        let p95 = options.bound.unwrap_or(BOUND_P95);
        inputs.note(format!(
            "the bound is not reached: the nearest, {} numbers, has \u{394}E\u{2080}\u{2080} {:.3} \
             (95 %) where {p95} is asked for and a relative rms of {:.2} % where {:.2} % is, both \
             before the numbers are rounded",
            choice.chosen.numbers,
            choice.chosen.p95,
            100.0 * choice.chosen.rms,
            100.0 * choice.bound_rms
        ));
    }
    Ok(choice.plan)
}

/// What was kept, where, and what it is off by.
struct Kept {
    bytes: Bytes,
    /// Whether the full form has numbers of 32 bits.
    is_single: bool,
    error: Errors,
}

/// What a thread found; a panic in it is one here.
fn joined<T>(thread: std::thread::ScopedJoinHandle<'_, T>) -> T {
    thread
        .join()
        .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

/// Writes the file, and measures what both forms take and the one asked for is off by.
fn kept(
    options: &Picture,
    pixels: &dyn Pixels,
    (operator, said): (&Operator, About),
    survey: &Survey,
    target: Option<&Target>,
    progress: &Progress,
) -> Result<Kept, PictureError> {
    let white_y = white_y_of(operator, &survey.sample);
    let sample: Vec<Vec<f64>> = survey
        .sample
        .iter()
        .map(|p| operator.numbers_of(p))
        .collect();
    let half = Half::of(&sample);
    let bound = options.bound.unwrap_or(BOUND_P95);
    let mut precision = Precision::Half;
    let mut error = measure(pixels, operator, &half, white_y, progress)?;
    if error.own.p95 > bound {
        // Numbers that all but cancel, as with nearly as many of them as bands, need more digits.
        let exactly = measure(pixels, operator, &Exactly, white_y, progress)?;
        if exactly.own.p95 < error.own.p95 {
            (precision, error) = (Precision::Single, exactly);
        }
    }
    let plan: CompactPlan =
        compact_plan(pixels, operator, &survey.sample, bound, white_y, progress)?;
    let path = target.map(|target| target.path);
    let is_compact = path.is_some_and(|path| path.to_string_lossy().ends_with(".png"));
    let folder = tempfile::tempdir()?;
    let place = |form: bool, name: &str| match path {
        Some(path) if form => path.to_owned(),
        _ => folder.path().join(name),
    };
    let (of_full, of_compact) = (
        place(!is_compact, "full.exr"),
        place(is_compact, "compact.png"),
    );
    let kept = (precision, half);
    // Packing takes most of the time and is one thread's work each; the longest tells how far it is.
    let (full, compact, exact) = std::thread::scope(|scope| {
        let full = scope.spawn(|| {
            let none = Progress::default();
            save_full(
                &of_full,
                pixels,
                operator,
                kept,
                (&said, error.clone()),
                &none,
            )
        });
        let compact = scope.spawn(|| {
            let none = Progress::default();
            save_compact(&of_compact, pixels, operator, &plan, &said, &none)
        });
        let exact = exact_bytes(pixels, Precision::Half, progress);
        (joined(full), joined(compact), exact)
    });
    Ok(Kept {
        bytes: Bytes {
            full: Some(full?),
            compact: Some(compact?),
            exact: Some(exact?),
        },
        is_single: precision == Precision::Single,
        error: if is_compact { plan.error } else { error },
    })
}

/// How far relighting to a bulb can be trusted; `None` where nobody knows what lit the picture.
fn trust(operator: &Operator, survey: &Survey, light: Option<&Illuminant>) -> Option<Trust> {
    let new = Illuminant::named(TRUSTED_UNDER)?;
    let is_factor = operator.bands().is_factor();
    let known = light.filter(|_| !is_factor);
    let relit = operator
        .relit(&new, known, crate::pictures::Between::Bands)
        .ok()?;
    let old = known.and_then(|light| light.on_bands(operator.bands()).ok());
    let noise = match &old {
        Some(old) => survey.noise_under(old),
        None => survey.noise.clone(),
    };
    Some(operator.trust(&relit, &new, old.as_deref(), &noise))
}

fn words(operator: &Operator, kept: &Kept, trust: Option<&Trust>) -> String {
    let plan = operator.plan();
    let reference = match plan.reference.kind {
        ReferenceKind::One => "no reference".to_owned(),
        ReferenceKind::Light => format!("reference {}", plan.reference.name),
        ReferenceKind::Mean => "reference mean".to_owned(),
    };
    let lines: Vec<String> = plan.lines.iter().map(|line| short(line.at_nm)).collect();
    let lines = match &lines[..] {
        [] => "no lines".to_owned(),
        lines => format!("lines at {} nm", lines.join(", ")),
    };
    let mut text = format!("{} numbers a pixel, {reference}, {lines}\n", plan.numbers());
    let Errors {
        own,
        lights,
        relative_rms,
        ..
    } = &kept.error;
    let all = std::iter::once(("own colour", own)).chain(lights.iter().map(|(n, s)| (&n[..], s)));
    // Writing to a string cannot fail.
    for (name, spread) in all {
        let _ = writeln!(
            text,
            "{name:>12}  \u{394}E\u{2080}\u{2080} {:.3} mean, {:.3} (95 %), {:.2} most",
            spread.mean, spread.p95, spread.max
        );
    }
    let mib = |bytes: Option<u64>| bytes.unwrap_or(0) as f64 / f64::from(1 << 20);
    let Bytes {
        full,
        compact,
        exact,
    } = kept.bytes;
    let _ = writeln!(
        text,
        "relative rms {:.2} %; {:.2} MiB full, {:.2} compact, {:.2} exact",
        100.0 * relative_rms,
        mib(full),
        mib(compact),
        mib(exact)
    );
    if let Some(trust) = trust {
        let _ = writeln!(text, "relit to {TRUSTED_UNDER}: {}", trust.words());
    }
    text
}

fn peers_words(peers: &[Peer]) -> String {
    let mut text = format!(
        "{:<24} {:>7} {:>12} {:>9} {:>9}\n",
        "way", "numbers", "bytes", "\u{394}E own", "\u{394}E lights"
    );
    for peer in peers {
        let number = |value: Option<f64>| value.map_or("-".to_owned(), |v| format!("{v:.3}"));
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:<24} {:>7} {:>12} {:>9} {:>9}  {}",
            peer.name,
            peer.numbers,
            peer.bytes.map_or("-".to_owned(), |bytes| bytes.to_string()),
            number(peer.error.as_ref().map(|error| error.own.p95)),
            number(peer.lights().map(|spread| spread.p95)),
            peer.description
        );
    }
    text
}
