//! `gem`: a brilliant under a light as figures and as a picture.

use std::{io::Write, path::Path, time::Instant};

use super::{
    arguments::{CutOptions, Gem, ViewOptions},
    inputs::Inputs,
    material::{absorption_of, clear_for, material, note_extrapolated},
    print,
    prism::{light_of, sent},
    refusal::Refusal,
    room_words::Lamps,
    subject::{self, USUAL_LIGHT},
    target::{Replaces, Target},
    words::extension,
};
use crate::{
    app::{
        dispersion::{Sent, gem_exr},
        ticks::short,
    },
    color::{Adaptation, Observer},
    io::{many::many, png, shown},
    optics::{
        Absorption, Brilliant, Film, FilmSettings, GemReport, Light, Material, Picture, Scene,
        Studio, View, film_bytes, gem_json,
    },
    study::Progress,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a light or material that cannot be read, a gem or view that is none, and a file
/// that cannot be written.
pub(super) fn run(options: &Gem, out: &mut dyn Write, inputs: &mut Inputs) -> Result<(), Refusal> {
    let target = options.out.as_deref().map(|path| target(options, path));
    if let Some(target) = &target {
        target.path()?;
    }
    let is_png = target.as_ref().is_some_and(|t| extension(t.path) == "png");
    for (option, is_given) in [
        ("--stops", options.stops.is_some()),
        ("--seen", options.seen.is_some()),
    ] {
        if is_given && !is_png {
            inputs.note(format!("{option} is not used: no PNG is written"));
        }
    }
    let (light, observer) = light(options, inputs)?;
    let material = clear_for(material(&options.material, inputs)?, &light)?;
    let cut = brilliant(options.cut);
    let mut film = film(options, &cut, material, inputs)?;
    let planes = film.settings().strata + Film::lines_of(&light).len();
    let bytes = film_bytes(options.size, planes);
    inputs.remark(&format!("a film of {} MB", bytes.div_ceil(1 << 20)));
    let start = Instant::now();
    film.trace(&light, options.rays, None, &Progress::default())
        .map_err(Refusal::usage)?;
    let seconds = start.elapsed().as_secs_f64();
    let picture = film.picture(&light, observer);
    say_doubts(&film, &picture, &light, inputs);
    let report = GemReport {
        film: &film,
        picture: &picture,
        noise: film.noise(&light, observer),
        light: &light,
        wavelength_nm: options.wavelength,
        cut: Some(&cut),
        rays: options.rays,
        blocks: Some(options.blocks),
        seconds,
    };
    let text = if options.json {
        let mut json = gem_json(&report);
        let sent = options
            .wavelength
            .is_none()
            .then(|| sent(options.as_modelled));
        json["light_as"] = sent.map(Sent::word).into();
        format!("{json:#}\n")
    } else {
        words(&report)
    };
    // Written first, so that nobody is told of a picture that is not there.
    let Some(target) = target else {
        return print(out, &text);
    };
    let file = match is_png {
        true => screen_file(&picture, options, inputs),
        false => gem_exr(&film, &light, &cut, options.rays),
    };
    let file = file.map_err(|why| Refusal::File(format!("{}: {why}", shown(target.path))))?;
    target.save(&file)?;
    let (path, size) = (shown(target.path), options.size);
    let line = format!("Wrote {path}, {size} x {size} px.");
    if options.json {
        inputs.note(line);
        return print(out, &text);
    }
    print(out, &format!("{text}{line}\n"))
}

/// Where the picture goes: a PNG may replace a picture, spectral planes are data.
fn target<'a>(options: &'a Gem, path: &'a Path) -> Target<'a> {
    let replaces = match extension(path).as_str() {
        "png" => Replaces::Pictures,
        _ => Replaces::Nothing,
    };
    let read = [
        options.light.as_deref(),
        Some(&*options.material),
        options.filter.as_deref(),
    ];
    Target::out(path, replaces, options.force, &read)
}

/// The light, or the one wavelength, and whose eye looks.
fn light(options: &Gem, inputs: &mut Inputs) -> Result<(Light, Observer), Refusal> {
    if let Some(nm) = options.wavelength {
        return Ok((
            Light::of_line(nm).map_err(Refusal::usage)?,
            Observer::default(),
        ));
    }
    let usual = USUAL_LIGHT.as_ref();
    let light = subject::light("--light", options.light.as_deref().unwrap_or(usual), inputs)?;
    let app = subject::about_light(light, options.model);
    inputs.note_centres(options.model);
    let light = light_of(&app, sent(options.as_modelled))?;
    Ok((light, app.document().settings.observer))
}

fn brilliant(cut: CutOptions) -> Brilliant {
    let CutOptions {
        table,
        crown,
        pavilion,
        star,
        lower,
        girdle,
        culet,
    } = cut;
    Brilliant {
        table,
        crown_deg: crown,
        pavilion_deg: pavilion,
        star,
        lower,
        girdle,
        culet,
    }
}

fn view(options: ViewOptions) -> View {
    let named = options.view.unwrap_or(View::A);
    View {
        from: options.from.unwrap_or(named.from),
        towards: options.towards.unwrap_or(named.towards),
        angle_deg: options.angle.unwrap_or(named.angle_deg),
    }
}

/// The gem in its scene before anything is traced.
fn film(
    options: &Gem,
    cut: &Brilliant,
    material: Material,
    inputs: &mut Inputs,
) -> Result<Film, Refusal> {
    if options.blocks > options.size {
        return Err(Refusal::usage(format_args!(
            "--blocks: found {}, expected at most {}, one a pixel",
            options.blocks, options.size
        )));
    }
    let absorption = match options.absorption {
        Some(per_unit) => {
            Absorption::even(per_unit).map_err(|why| Refusal::usage(format_args!("--{why}")))?
        }
        None => absorption_of(options.filter.as_ref(), options.thickness, inputs)?,
    };
    let scene = Scene {
        view: view(options.view),
        ..match options.lamps {
            Lamps::Studio => Scene::default(),
            Lamps::Jeweller => Scene::jeweller(),
        }
    };
    let solid = cut.solid().map_err(Refusal::usage)?;
    let studio = Studio::new(solid, material, absorption, scene).map_err(Refusal::usage)?;
    let settings = FilmSettings {
        size: options.size,
        seed: options.seed,
        ..FilmSettings::default()
    };
    Film::new(studio, settings).map_err(Refusal::usage)
}

/// What is to be known of the picture beside its figures.
fn say_doubts(film: &Film, picture: &Picture, light: &Light, inputs: &mut Inputs) {
    let material = film.studio().material();
    let unseen = light.share_unseen();
    if unseen >= LEAST_UNSEEN {
        inputs.note(format!(
            "{:.1} % of the light's power is outside 380 to 780 nm and is not traced",
            100.0 * unseen
        ));
    }
    if !picture.stand_ins_nm.is_empty() {
        let places: Vec<String> = picture.stand_ins_nm.iter().map(|nm| short(*nm)).collect();
        inputs.note(format!(
            "the lines at {} nm have no rays of their own: strata stand in for them",
            places.join(", ")
        ));
    }
    let traced = || (380..=780).map(f64::from);
    if let Some([from, to]) = material.published_nm
        && traced().any(|nm| material.index(nm).is_err())
    {
        inputs.note(format!(
            "{}: the index is known for {} to {} nm alone: no light of other wavelengths is \
             traced, neither through the gem nor beside it",
            material.name,
            short(from),
            short(to)
        ));
    } else if traced().any(|nm| material.is_extrapolated(nm)) {
        note_extrapolated(material, inputs);
    }
}

/// Shares of the power that are less round to none.
const LEAST_UNSEEN: f64 = 0.0005;

/// The figures in words.
fn words(report: &GemReport) -> String {
    let traced = report.film.traced();
    let size = report.picture.size;
    let light = match report.wavelength_nm {
        Some(nm) => format!("light of {} nm", short(nm)),
        None => report.light.name.clone(),
    };
    let noise = match report.noise {
        Some(noise) => format!(
            "noise: relative MSE {:.2e}, \u{394}E\u{2080}\u{2080} {:.2} (median), {:.2} (95 %)",
            noise.relative_mse, noise.delta_e_median, noise.delta_e_p95
        ),
        None => "noise: not known with one ray a pixel".to_owned(),
    };
    format!(
        "{} under {light}, {size} x {size} px, {} a pixel, {:.1} faces a ray\n\
         {noise}\n{:.2} s, {:.2} million rays a second\n",
        report.film.studio().material().name,
        many(report.rays as usize, "ray", "rays"),
        traced.segments_per_ray(),
        report.seconds,
        traced.rays as f64 / report.seconds.max(1e-9) / 1e6,
    )
}

/// The picture as a screen shows it.
fn screen_file(picture: &Picture, options: &Gem, inputs: &mut Inputs) -> Result<Vec<u8>, String> {
    let by_eye = options.seen != Some(Adaptation::None);
    let adapted = by_eye.then(|| picture.adapted());
    if adapted == Some(None) {
        inputs.note("no eye adapts to so narrow a light: the picture is as seen beside daylight");
    }
    let adapted = adapted.flatten();
    let picture = adapted.as_ref().unwrap_or(picture);
    let pixels = picture.shown(options.stops.unwrap_or(0.0)).pixels;
    png([picture.size; 2], pixels.as_flattened()).ok_or_else(|| "found no picture".to_owned())
}
