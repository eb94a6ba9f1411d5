//! The figures of prism, rainbow and gem as JSON and CSV. Keys are stable; angles are degrees.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{
    bench::{Bench, Landing},
    chain::Traced,
    cut::Brilliant,
    film::Film,
    index::Material,
    index_error::IndexError,
    light::Light,
    picture::{Noise, Picture},
    prism::limits,
    rainbow::{Bow, Bows},
    strip::Strip,
};
use crate::color::Xyz;

/// Blocks across the picture in the JSON.
const BLOCKS: usize = 16;

/// A material and its figures.
fn material_json(material: &Material) -> Value {
    let figures = material.abbe();
    json!({
        "name": material.name,
        "source": material.source,
        "published_nm": material.published_nm,
        "n_d": figures.map(|f| f.n_d),
        "v_d": figures.map(|f| f.v_d),
        "v_e": figures.map(|f| f.v_e),
        "fire": figures.map(|f| f.fire),
    })
}

/// Wavelengths to list: the light's spikes and those asked for, rising, each once.
fn listed(light: Option<&Light>, at_nm: &[f64]) -> Vec<f64> {
    let spikes = light
        .into_iter()
        .flat_map(|l| l.spikes().iter().map(|s| s.at_nm));
    let mut all: Vec<f64> = spikes.chain(at_nm.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

fn landing_json(landing: &Landing, material: &Material, light: &Light) -> Value {
    let spike = light.spikes().iter().find(|s| s.at_nm == landing.at_nm);
    let mut all = json!(landing);
    all["resolving_power"] = json!(landing.resolving.power());
    all["resolving_limit"] = json!(landing.resolving.limit());
    all["weight"] = json!(spike.map(|s| s.weight));
    all["extrapolated"] = json!(material.is_extrapolated(landing.at_nm));
    all
}

/// The prism bench: the light's spikes and every wavelength asked for.
///
/// `at` holds those that land; `reflected` those that are totally reflected or run away from the
/// screen, `refused` those without an index, in words.
pub(crate) fn prism_json(
    bench: &Bench,
    light: &Light,
    at_nm: &[f64],
    strip: Option<&Strip>,
) -> Value {
    let (mut at, mut reflected, mut refused) = (Vec::new(), Vec::new(), Vec::new());
    for nm in listed(Some(light), at_nm) {
        match bench.landing(nm) {
            Ok(Some(landing)) => at.push(landing_json(&landing, bench.material(), light)),
            Ok(None) => reflected.push(nm),
            Err(error) => refused.push(refused_json(nm, &error)),
        }
    }
    let settings = bench.settings();
    let reference = bench.reference_nm();
    let limits = bench
        .material()
        .index(reference)
        .map(|n| limits(n, bench.prism().apex_deg()));
    let limits = limits.ok();
    json!({
        "light": light.name,
        "material": material_json(bench.material()),
        "apex": bench.prism().apex_deg(),
        "incidence": bench.prism().incidence_deg(),
        "entry_mm": settings.entry_mm,
        "screen_mm": settings.screen_mm,
        "slit_mm": settings.slit_mm,
        "reference_nm": reference,
        "critical": limits.map(|l| l.critical_deg),
        "largest_apex": limits.map(|l| l.largest_apex_deg),
        "smallest_incidence": limits.and_then(|l| l.smallest_incidence_deg),
        "at": at,
        "reflected": reflected,
        "reflected_to_nm": bench.reflected_to_nm(),
        "reflected_stretches": bench.reflected_nm(),
        "reflected_words": bench.reflected_words(),
        "refused": refused,
        "share_beside": strip.map(|s| s.share_beside),
        "extrapolated": strip.map(|s| s.extrapolated),
    })
}

/// The same figures as a table; what is totally reflected or refused has dashes.
pub(crate) fn prism_csv(bench: &Bench, light: &Light, at_nm: &[f64]) -> String {
    let mut table = String::from(
        "nm,n,deviation_deg,minimum_deviation_deg,d_deviation_d_nm,transmittance,x_mm,width_mm,\
         resolving_power,limit\n",
    );
    for nm in listed(Some(light), at_nm) {
        let row = bench.landing(nm).ok().flatten().map(|l| {
            let least = l.minimum_deviation_deg;
            let least = least.map_or("-".to_owned(), |d| format!("{d:.8}"));
            format!(
                "{:.9},{:.8},{least},{:.10},{:.8},{:.6},{:.6},{:.0},{}",
                l.n,
                l.deviation_deg,
                l.d_deviation_d_nm,
                l.transmittance,
                l.x_mm,
                l.width_mm,
                l.resolving.power(),
                l.resolving.limit()
            )
        });
        let row = row.unwrap_or_else(|| "-,-,-,-,-,-,-,-,-".to_owned());
        // Writing to a string cannot fail.
        let _ = writeln!(table, "{nm},{row}");
    }
    table
}

/// Both bows of the light's spikes and of every wavelength asked for. `primary` and `secondary`
/// are angles from the antisolar point.
pub(crate) fn rainbow_json(material: &Material, light: Option<&Light>, at_nm: &[f64]) -> Value {
    let (mut at, mut refused) = (Vec::new(), Vec::new());
    for nm in listed(light, at_nm) {
        match Bows::new(material, nm) {
            Ok(bows) => at.push(bows_json(&bows, material)),
            Err(error) => refused.push(refused_json(nm, &error)),
        }
    }
    json!({
        "light": light.map(|l| &l.name),
        "material": material_json(material),
        "at": at,
        "refused": refused,
    })
}

fn refused_json(nm: f64, error: &IndexError) -> Value {
    json!({ "nm": nm, "why": error.to_string() })
}

fn bows_json(bows: &Bows, material: &Material) -> Value {
    let mut all = json!({
        "nm": bows.at_nm,
        "n": bows.n,
        "extrapolated": material.is_extrapolated(bows.at_nm),
    });
    for (name, bow) in [("primary", bows.primary), ("secondary", bows.secondary)] {
        let of = |value: fn(&Bow) -> f64| json!(bow.as_ref().map(value));
        all[name] = of(|b| b.from_antisolar_deg);
        for (figure, value) in [
            ("impact", of(|b| b.ray.impact)),
            ("incidence", of(|b| b.ray.incidence_deg)),
            ("deviation", of(|b| b.deviation_deg)),
            ("weight_s", of(|b| b.weights_s_p[0])),
            ("weight_p", of(|b| b.weights_s_p[1])),
            ("polarisation", of(Bow::polarisation)),
        ] {
            all[format!("{name}_{figure}")] = value;
        }
    }
    all
}

/// Data for a gem's JSON.
#[derive(Clone, Debug)]
pub(crate) struct GemReport<'a> {
    /// The film.
    pub film: &'a Film,
    /// The picture under the light.
    pub picture: &'a Picture,
    /// Its noise.
    pub noise: Option<Noise>,
    /// The light.
    pub light: &'a Light,
    /// The one wavelength that was asked for instead of a light: radiance is told and no colour.
    pub wavelength_nm: Option<f64>,
    /// The cut, when it is a brilliant.
    pub cut: Option<&'a Brilliant>,
    /// Rays a pixel that were asked for.
    pub rays: u32,
    /// Number of blocks across; 16 by default.
    pub blocks: Option<usize>,
    /// Time taken, s.
    pub seconds: f64,
}

/// A gem's picture in figures. `mean` and `blocks` are radiance under radiance 1 for a wavelength,
/// X, Y, Z for a light, with Y = 1 for what shines with the light's own radiance.
pub(crate) fn gem_json(report: &GemReport<'_>) -> Value {
    let GemReport {
        film,
        picture,
        light,
        ..
    } = report;
    let traced: Traced = film.traced();
    let blocks = report.blocks.unwrap_or(BLOCKS);
    let (mean, blocks) = match report.wavelength_nm {
        // Y over the white's Y is the transport itself wherever the eye sees anything.
        Some(nm) => {
            let transport = Picture {
                size: picture.size,
                xyz: film.transport(nm).into_iter().map(|t| [t; 3]).collect(),
                white: Xyz::new(1.0, 1.0, 1.0),
                stand_ins_nm: Vec::new(),
                unfinished: false,
            };
            let first = |row: Vec<[f64; 3]>| row.iter().map(|b| json!(b[0])).collect::<Value>();
            let rows = transport.blocks(blocks).into_iter().map(first);
            (json!(transport.mean()[0]), rows.collect::<Value>())
        }
        None => (json!(picture.mean()), json!(picture.blocks(blocks))),
    };
    let white = picture.white;
    let studio = film.studio();
    let scene = studio.scene();
    json!({
        "size": picture.size,
        "rays": report.rays,
        "rays_a_pixel": film.rays_a_pixel(),
        "segments_per_ray": traced.segments_per_ray(),
        "share_on_gem": traced.chains as f64 / traced.rays.max(1) as f64,
        "cut_chains": traced.cut,
        "cut_weight": traced.cut_weight,
        "seconds": report.seconds,
        "rays_per_second": traced.rays as f64 / report.seconds,
        "noise": report.noise,
        "mean": mean,
        "blocks": blocks,
        "white": (white.y.is_finite() && white.y > 0.0)
            .then(|| (white * (1.0 / white.y)).to_array()),
        "light": light.name,
        "wavelength": report.wavelength_nm,
        "share_unseen": light.share_unseen(),
        "lines": Film::lines_of(light).iter().map(|s| json!({
            "nm": s.at_nm, "weight": s.weight,
        })).collect::<Vec<_>>(),
        "stand_ins": picture.stand_ins_nm,
        "material": material_json(studio.material()),
        "absorption_floored": studio.absorption().is_floored(),
        "cut": report.cut.map(|c| json!({
            "table": c.table, "crown": c.crown_deg, "pavilion": c.pavilion_deg, "star": c.star,
            "lower": c.lower, "girdle": c.girdle, "culet": c.culet, "facets": c.facets(),
        })),
        "view": scene.view,
        "scene": scene,
        "seed": film.settings().seed,
        "strata": film.settings().strata,
        "bytes": film.bytes(),
    })
}
