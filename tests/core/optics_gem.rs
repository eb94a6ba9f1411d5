//! The gem: identities, then reference pictures.

use std::num::NonZero;

use super::open_exr::lines_of_exr;
use serde_json::Value;
use spectral_explorer::{
    color::{Observer, Xyz, delta_e_of_xyz},
    io::{light_exr, read_bytes},
    optics::{
        Absorption, Brilliant, BuiltinMaterial, Ending, Film, FilmError, FilmSettings, GemReport,
        HalfSpace, Lamp, Light, Material, Noise, Picture, Plane, Scene, Solid, Studio, View,
        gem_json, reflectances, spectral_planes,
    },
    spectrum::{Band, Line},
    study::Progress,
};

fn go() -> Progress {
    Progress::default()
}

fn studio_of(solid: Solid, scene: Scene) -> Studio {
    Studio::new(
        solid,
        BuiltinMaterial::Diamond.material(),
        Absorption::None,
        scene,
    )
    .unwrap()
}

fn brilliant() -> Solid {
    Brilliant::default().solid().unwrap()
}

fn studio() -> Studio {
    studio_of(brilliant(), Scene::default())
}

fn film(studio: Studio, size: usize) -> Film {
    let settings = FilmSettings {
        size,
        ..FilmSettings::default()
    };
    Film::new(studio, settings).unwrap()
}

fn threads(count: usize) -> Option<NonZero<usize>> {
    NonZero::new(count)
}

fn no_roulette() -> Ending {
    Ending {
        roulette_below: 0.0,
        most_faces: 100_000,
    }
}

/// Film points all over the picture.
fn places() -> impl Iterator<Item = [f64; 2]> {
    let one = |i: u32| (f64::from(i) + 0.37) / 10.0 - 1.0;
    (0..20).flat_map(move |y| (0..20).map(move |x| [one(x), one(y)]))
}

/// A scene whose dome and lamps all shine alike.
fn all_ones() -> Scene {
    let mut scene = Scene {
        dome: 1.0,
        ..Scene::default()
    };
    scene.lamps.iter_mut().for_each(|lamp| lamp.radiance = 1.0);
    scene
}

/// A lamp's back is black, so a world of ones has none that turns it to the gem.
fn world_of_ones() -> Scene {
    let mut scene = all_ones();
    let faces_gem = |lamp: &Lamp| {
        let (u, v) = (lamp.half_edge_u, lamp.half_edge_v);
        let normal = [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ];
        (0..3).map(|k| normal[k] * lamp.centre[k]).sum::<f64>() < 0.0
    };
    scene.lamps.retain(faces_gem);
    scene
}

#[test]
fn in_a_world_of_ones_the_gem_vanishes() {
    let scene = world_of_ones();
    assert_eq!(
        scene.lamps.len(),
        6,
        "all lamps of the definition face the gem"
    );
    let studio = studio_of(brilliant(), scene);
    let (mut on_gem, mut most) = (0, 0);
    for place in places() {
        let seen = studio.look(place, 546.074, no_roulette()).unwrap();
        assert!((seen.radiance - 1.0).abs() < 1e-9, "{place:?}: {seen:?}");
        on_gem += usize::from(seen.faces > 0);
        most = most.max(seen.faces);
    }
    assert!(
        on_gem > 150 && most > 50,
        "{on_gem} rays met it, {most} faces at most"
    );
    // With roulette in single precision it holds on average.
    let mut film = film(studio, 64);
    film.trace(&Light::of_line(546.074).unwrap(), 64, None, &go())
        .unwrap();
    let mean = film.plane(40).iter().map(|v| f64::from(*v)).sum::<f64>() / 4096.0;
    // Roulette is the only chance left: below .05 of weight on some 1e5 chains.
    assert!((mean - 1.0).abs() < 1e-3, "{mean}");
}

#[test]
fn a_body_of_no_index_is_not_there() {
    let studio = studio();
    let empty = studio_of(Solid::cube(1e-3).unwrap(), Scene::default());
    for place in places() {
        let through = studio.look_through(place, 1.0, 0.0, no_roulette());
        let without = empty.look_through(place, 1.0, 0.0, no_roulette());
        // The ray goes on from a face: double precision of a direction.
        assert!(
            (through.radiance - without.radiance).abs() < 1e-9,
            "{place:?}"
        );
    }
}

#[test]
fn a_cube_face_on_lets_through_what_two_faces_leave() {
    let scene = Scene {
        dome: 0.0,
        lamps: vec![Lamp {
            centre: [0.0, 3.0, 0.0],
            half_edge_u: [0.0, 0.0, 9.0],
            half_edge_v: [9.0, 0.0, 0.0],
            radiance: 1.0,
        }],
        view: View {
            from: [0.0, -5.0, 0.0],
            towards: [0.0, 0.0, 0.0],
            angle_deg: 5.0,
        },
    };
    let mut scene = scene;
    // It shines towards -y.
    scene.lamps[0].half_edge_v = [-9.0, 0.0, 0.0];
    let studio = studio_of(Solid::cube(0.5).unwrap(), scene);
    let n = BuiltinMaterial::Diamond.material().index(589.294).unwrap();
    let [r, _] = reflectances(1.0, 1.0, n, 1.0);
    let seen = studio.look([0.0, 0.0], 589.294, no_roulette()).unwrap();
    assert!(
        (seen.radiance - (1.0 - r) / (1.0 + r)).abs() < 1e-12,
        "{seen:?}"
    );
    // Any convex list of planes: absorption takes exp(-a) on each way through a cube of side 1.
    let seen = studio.look_through([0.0, 0.0], n, 0.7, no_roulette());
    let e = (-0.7_f64).exp();
    let expected = (1.0 - r).powi(2) * e / (1.0 - r * r * e * e);
    assert!(
        (seen.radiance - expected).abs() < 1e-12,
        "{seen:?} {expected}"
    );
}

#[test]
fn single_precision_and_roulette_find_what_double_finds_without() {
    let studio = studio();
    let size = 16;
    let mut film = film(studio.clone(), size);
    film.trace_lines(&[587.562], 1024, None, &go()).unwrap();
    let fast = film.plane(40).iter().map(|v| f64::from(*v)).sum::<f64>() / 256.0;
    let side = 60;
    let place = |i: u32| 2.0 * (f64::from(i) + 0.5) / f64::from(side) - 1.0;
    let mut exact = 0.0;
    for y in 0..side {
        for x in 0..side {
            let seen = studio.look([place(x), place(y)], 587.562, no_roulette());
            exact += seen.unwrap().radiance / f64::from(side * side);
        }
    }
    // 3600 points of standard deviation .5, evenly spread: about 2e-3.
    assert!((fast - exact).abs() < 8e-3, "{fast} {exact}");
}

fn smooth_light(phase: f64) -> Light {
    let smooth = Band::VISIBLE
        .grid()
        .map(|nm| 1.0 + 0.6 * (nm / 60.0 + phase).sin())
        .collect();
    Light::new("smooth", Band::VISIBLE, smooth, Vec::new()).unwrap()
}

fn with_spikes(light: &Light, spikes: &[(f64, f64)]) -> Light {
    let spikes = spikes
        .iter()
        .map(|(at_nm, weight)| Line::ideal(*at_nm, *weight));
    Light::new(
        "both",
        light.band(),
        light.smooth().to_vec(),
        spikes.collect(),
    )
    .unwrap()
}

fn nearly(a: &Picture, b: &Picture, relative: f64) {
    let scale = a.white.y.max(b.white.y);
    for (a, b) in a.xyz.iter().zip(&b.xyz) {
        for k in 0..3 {
            let off = f64::from((a[k] - b[k]).abs()) / scale;
            assert!(off < relative, "{a:?} {b:?}");
        }
    }
}

#[test]
fn a_light_of_spikes_is_its_monochromatic_pictures() {
    let spikes = [(435.833, 2.0), (546.075, 3.0)];
    let dark = Light::new(
        "dark",
        Band::VISIBLE,
        vec![0.0; 401],
        vec![Line::ideal(500.0, 1.0)],
    )
    .unwrap();
    let light = with_spikes(&dark, &spikes);
    let mut both = film(studio(), 32);
    both.trace_lines(&[435.833, 546.075], 16, None, &go())
        .unwrap();
    let picture = both.picture(&light, Observer::CIE_1931);
    assert!(picture.stand_ins_nm.is_empty() && !picture.unfinished);
    let table = Observer::CIE_1931.table();
    let mut expected = vec![[0.0_f64; 3]; 32 * 32];
    for (nm, weight) in spikes {
        // A film of that wavelength alone, traced by itself: the same points.
        let mut alone = film(studio(), 32);
        alone
            .trace(&Light::of_line(nm).unwrap(), 16, None, &go())
            .unwrap();
        // The same rays; only the order of 16 sums of single precision may differ.
        for (a, b) in alone.transport(nm).iter().zip(both.transport(nm)) {
            assert!((a - b).abs() <= 1e-6 * a.max(0.1), "{a} {b}");
        }
        for (sum, t) in expected.iter_mut().zip(alone.transport(nm)) {
            for (sum, v) in sum.iter_mut().zip(table.at(nm)) {
                *sum += weight * v * f64::from(t);
            }
        }
    }
    for (found, expected) in picture.xyz.iter().zip(&expected) {
        for k in 0..3 {
            // Single precision of a few products, of numbers up to about 50.
            assert!((f64::from(found[k]) - expected[k]).abs() <= 1e-5 * expected[k].max(0.1));
        }
    }
}

#[test]
fn a_film_is_linear_in_the_light() {
    let a = with_spikes(&smooth_light(0.0), &[(435.833, 20.0)]);
    let b = with_spikes(&smooth_light(2.0), &[(435.833, -7.0), (611.0, 9.0)]);
    let sum: Vec<f64> = a
        .smooth()
        .iter()
        .zip(b.smooth())
        .map(|(a, b)| a + b)
        .collect();
    let spikes = a.spikes().iter().chain(b.spikes()).copied().collect();
    let both = Light::new("sum", Band::VISIBLE, sum, spikes).unwrap();
    let mut film = film(studio(), 48);
    film.trace(&both, 64, None, &go()).unwrap();
    let [pa, pb, pc] = [&a, &b, &both].map(|l| film.picture(l, Observer::CIE_1931));
    let added = Picture {
        xyz: pa
            .xyz
            .iter()
            .zip(&pb.xyz)
            .map(|(a, b)| std::array::from_fn(|k| a[k] + b[k]))
            .collect(),
        ..pc.clone()
    };
    // Single precision over 50 planes of a light of some hundred.
    nearly(&added, &pc, 1e-5);
    assert!((pa.white.y + pb.white.y - pc.white.y).abs() < 1e-9);
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let light = with_spikes(&smooth_light(1.0), &[(404.656, 3.0), (546.075, 30.0)]);
    let traced = |count: usize| {
        let mut film = film(studio(), 70);
        film.trace(&light, 30, threads(count), &go()).unwrap();
        film.trace(&light, 64, threads(count), &go()).unwrap();
        (
            film.picture(&light, Observer::CIE_1931),
            film.noise(&light, Observer::CIE_1931),
            film.traced(),
        )
    };
    let one = traced(1);
    assert_eq!(one, traced(2));
    assert_eq!(one, traced(5));
    let other_seed = FilmSettings {
        size: 70,
        seed: 2,
        ..FilmSettings::default()
    };
    let mut other = Film::new(studio(), other_seed).unwrap();
    other.trace(&light, 30, None, &go()).unwrap();
    assert_ne!(one.0, other.picture(&light, Observer::CIE_1931));
}

#[test]
fn another_light_needs_only_its_new_spikes() {
    let first = with_spikes(&smooth_light(0.0), &[(546.075, 40.0)]);
    let second = with_spikes(&smooth_light(2.0), &[(546.075, 10.0), (589.3, 60.0)]);
    let mut film = film(studio(), 48);
    film.trace(&first, 128, None, &go()).unwrap();
    let early = film.picture(&second, Observer::CIE_1931);
    assert_eq!(early.stand_ins_nm, [589.3]);
    assert_eq!(film.missing_lines(&second), [589.3]);
    let planes = film.planes().len();
    film.trace_lines(&film.missing_lines(&second), 16, None, &go())
        .unwrap();
    assert_eq!(film.planes().len(), planes + 1);
    assert!(matches!(film.planes()[planes], Plane::Line { at_nm } if at_nm == 589.3));
    let late = film.picture(&second, Observer::CIE_1931);
    assert!(late.stand_ins_nm.is_empty() && film.missing_lines(&second).is_empty());
    // The stratum's ten nm stand in well: not the same, but near on average.
    let (a, b) = (early.mean(), late.mean());
    assert!(
        early != late && (0..3).all(|k| (a[k] / b[k] - 1.0).abs() < 0.05),
        "{a:?} {b:?}"
    );
}

#[test]
fn cancelled_work_is_kept_as_far_as_it_came() {
    let mut film = film(studio(), 64);
    let progress = go();
    progress.cancel();
    let stopped = film.trace(&smooth_light(0.0), 16, None, &progress);
    assert_eq!(stopped, Err(FilmError::Cancelled));
    assert_eq!(film.traced().rays, 0);
    let picture = film.picture(&smooth_light(0.0), Observer::CIE_1931);
    assert!(picture.unfinished && picture.xyz.iter().all(|p| *p == [0.0; 3]));
}

#[test]
fn films_that_are_none_are_refused_in_words() {
    let said = |settings: FilmSettings| Film::new(studio(), settings).unwrap_err().to_string();
    let plain = FilmSettings::default();
    assert_eq!(
        said(FilmSettings { size: 15, ..plain }),
        "size: expected 16 to 4096 pixels, found 15"
    );
    assert_eq!(
        said(FilmSettings {
            size: 4096,
            ..plain
        }),
        "expected a film of at most 2048 MB, found one of 2920 MB"
    );
    let mut film = film(studio(), 16);
    for rays in [0, 65_537] {
        let refused = film
            .trace(&smooth_light(0.0), rays, None, &go())
            .unwrap_err();
        assert_eq!(
            refused.to_string(),
            format!("rays: expected 1 to 65536 a pixel, found {rays}")
        );
    }
}

#[test]
fn of_too_many_spikes_the_strongest_have_planes_and_the_others_stay_in_the_light() {
    let spikes: Vec<(f64, f64)> = (0..80)
        .map(|i| (385.0 + 4.9 * f64::from(i), 1.0 + f64::from(i)))
        .collect();
    let light = with_spikes(&smooth_light(0.0), &spikes);
    assert_eq!(Film::lines_of(&light).len(), 64);
    let mut film = film(studio_of(brilliant(), world_of_ones()), 16);
    film.trace(&light, 256, None, &go()).unwrap();
    let picture = film.picture(&light, Observer::CIE_1931);
    assert_eq!(picture.stand_ins_nm.len(), 16);
    // In a world of ones the picture is the light, whoever stands in.
    let mean = picture.mean();
    let white = picture.white * (1.0 / picture.white.y);
    let off = Xyz::from_array(mean) - white;
    assert!(
        off.to_array().iter().all(|v| v.abs() < 0.02),
        "{mean:?} {white:?}"
    );
}

#[test]
fn few_rays_are_unbiased() {
    let light = with_spikes(&smooth_light(0.0), &[(435.833, 20.0), (546.075, 30.0)]);
    let mean = |rays: u32, times: u64| {
        let mut sum = [0.0; 3];
        for seed in 0..times {
            let settings = FilmSettings {
                size: 64,
                seed,
                ..FilmSettings::default()
            };
            let mut film = Film::new(studio(), settings).unwrap();
            film.trace(&light, rays, None, &go()).unwrap();
            let own = film.picture(&light, Observer::CIE_1931).mean();
            (0..3).for_each(|k| sum[k] += own[k] / times as f64);
        }
        sum
    };
    let (many, few) = (mean(128, 2), mean(5, 30));
    for k in 0..3 {
        // 30 pictures of 4096 pixels with 5 rays: a standard error of about half a per cent.
        assert!((few[k] / many[k] - 1.0).abs() < 0.02, "{few:?} {many:?}");
    }
}

/// What a picture of a film is off by from a reference of the same size and light: colours are
/// those of blocks of 8 x 8 pixels, on the gem where any of 5 x 5 places of a block shows it.
fn true_noise(film: &Film, picture: &Picture, reference: &Picture) -> Noise {
    let (size, scale) = (picture.size, reference.white.y / picture.white.y);
    let pairs = picture.xyz.iter().zip(&reference.xyz);
    let square = |(a, b): (&[f32; 3], &[f32; 3])| {
        let (a, b) = (f64::from(a[1]) * scale, f64::from(b[1]));
        ((a - b) / (b + 0.02 * reference.white.y)).powi(2)
    };
    let white = reference.white * (1.0 / reference.white.y);
    let (found, expected) = (picture.blocks(size / 8), reference.blocks(size / 8));
    let (mut all, mut on_gem) = (Vec::new(), Vec::new());
    for (row, column) in (0..size / 8).flat_map(|row| (0..size / 8).map(move |x| (row, x))) {
        let xyz = |blocks: &[Vec<[f64; 3]>]| Xyz::from_array(blocks[row][column]);
        let delta = delta_e_of_xyz(xyz(&found), xyz(&expected), white).unwrap();
        all.push(delta);
        let film_at = |block: usize, i: usize| (16 * block + 4 * i) as f64 / size as f64 - 1.0;
        let place = |i: usize| [film_at(column, i % 5), -film_at(row, i / 5)];
        if (0..25).any(|i| film.studio().meets(place(i))) {
            on_gem.push(delta);
        }
    }
    all.sort_by(f64::total_cmp);
    Noise {
        relative_mse: pairs.map(square).sum::<f64>() / picture.xyz.len() as f64,
        delta_e_median: 0.5 * (all[all.len() / 2 - 1] + all[all.len() / 2]),
        delta_e_p95: all[all.len() * 95 / 100],
        delta_e_on_gem: Some(on_gem.iter().sum::<f64>() / on_gem.len() as f64),
    }
}

#[test]
fn the_noise_told_is_the_noise_there_is() {
    let light = with_spikes(&smooth_light(0.0), &[(435.833, 20.0), (546.075, 30.0)]);
    let traced = |rays: u32, seed: u64| {
        let settings = FilmSettings {
            size: 64,
            seed,
            ..FilmSettings::default()
        };
        let mut film = Film::new(studio(), settings).unwrap();
        film.trace(&light, rays, None, &go()).unwrap();
        film
    };
    let reference = traced(1024, 99).picture(&light, Observer::CIE_1931);
    for rays in [32, 128] {
        let film = traced(rays, 1);
        let told = film.noise(&light, Observer::CIE_1931).unwrap();
        let picture = film.picture(&light, Observer::CIE_1931);
        let true_noise = true_noise(&film, &picture, &reference);
        println!("{rays} rays: told {told:?}, true {true_noise:?}");
        // Halves of evenly spread points are worse than the whole, so a little more is told than
        // is there; one picture's own figure scatters by a third.
        let ratio = told.relative_mse / true_noise.relative_mse;
        assert!((0.5..3.0).contains(&ratio), "{ratio}");
        let ratio = told.delta_e_median / true_noise.delta_e_median;
        assert!((0.4..3.0).contains(&ratio), "{ratio}");
        let on_gem = |noise: Noise| noise.delta_e_on_gem.unwrap();
        let ratio = on_gem(told) / on_gem(true_noise);
        assert!((0.5..2.0).contains(&ratio), "{ratio}");
    }
    assert_eq!(traced(1, 1).noise(&light, Observer::CIE_1931), None);
}

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().unwrap();
    list.iter().map(|v| v.as_f64().unwrap()).collect()
}

#[test]
fn the_planes_are_those_of_the_reference() {
    let golden = parsed(include_str!("../golden/diamond_mono.json"));
    let planes = golden["sets"][0]["planes"].as_array().unwrap();
    let solid = brilliant();
    assert_eq!(solid.planes().len(), planes.len());
    for row in planes {
        let row = numbers(row);
        let same = |p: &HalfSpace| {
            let own = [p.normal[0], p.normal[1], p.normal[2], p.distance];
            // Twelve decimals.
            own.iter().zip(&row).all(|(a, b)| (a - b).abs() < 2e-12)
        };
        assert_eq!(solid.planes().iter().filter(|p| same(p)).count(), 1);
    }
}

/// Means of blocks with their standard errors, from pictures of different seeds.
fn blocks_with_errors<const N: usize>(pictures: &[Vec<[f64; N]>]) -> Vec<([f64; N], [f64; N])> {
    let count = pictures.len() as f64;
    (0..pictures[0].len())
        .map(|block| {
            let of = |k: usize| pictures.iter().map(move |p| p[block][k]);
            let mean: [f64; N] = std::array::from_fn(|k| of(k).sum::<f64>() / count);
            let error = std::array::from_fn(|k| {
                let squares: f64 = of(k).map(|v| (v - mean[k]).powi(2)).sum();
                (squares / (count - 1.0) / count).sqrt()
            });
            (mean, error)
        })
        .collect()
}

/// A wavelength of the reference lies where the pictures have it, within both errors.
fn is_in_the_pictures(row: &Value, absorption: f64, pictures: &[Film]) {
    let nm = row["nm"].as_f64().unwrap();
    let found: Vec<Vec<[f64; 1]>> = pictures
        .iter()
        .map(|film| {
            let picture = Picture {
                size: 128,
                xyz: film.transport(nm).into_iter().map(|t| [t; 3]).collect(),
                white: Xyz::new(1.0, 1.0, 1.0),
                stand_ins_nm: Vec::new(),
                unfinished: false,
            };
            picture
                .blocks(16)
                .into_iter()
                .flatten()
                .map(|b| [b[0]])
                .collect()
        })
        .collect();
    let blocks = blocks_with_errors(&found);
    let expected: Vec<f64> = row["mean"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(numbers)
        .collect();
    let errors: Vec<f64> = row["standard_error"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(numbers)
        .collect();
    let mut outside = 0;
    for (index, ([found], [own])) in blocks.iter().enumerate() {
        let error = (errors[index].powi(2) + own * own).sqrt();
        let off = (found - expected[index]).abs();
        outside += usize::from(off > 4.0 * error + 1e-6);
    }
    // The file: 99.5 % of 256 blocks within 4 standard errors.
    assert!(outside <= 1, "{nm} nm, a = {absorption}: {outside} blocks");
    let mean = blocks.iter().map(|(m, _)| m[0]).sum::<f64>() / 256.0;
    let own = blocks.iter().map(|(_, e)| e[0] * e[0]).sum::<f64>().sqrt() / 256.0;
    let (expected, error) = (
        row["picture_mean"].as_f64().unwrap(),
        row["picture_mean_se"].as_f64().unwrap(),
    );
    let error = (error * error + own * own).sqrt();
    println!(
        "{nm} nm: mean {mean:.7}, {:+.2} errors",
        (mean - expected) / error
    );
    assert!((mean - expected).abs() < 3.0 * error + 1e-6, "{nm}: {mean}");
}

#[test]
fn monochromatic_pictures_agree_with_the_reference_block_by_block() {
    let golden = parsed(include_str!("../golden/diamond_mono.json"));
    let lines: Vec<f64> = golden["sets"][0]["wavelengths"]
        .as_array()
        .unwrap()
        .iter()
        .map(|w| w["nm"].as_f64().unwrap())
        .collect();
    for set in golden["sets"].as_array().unwrap() {
        let absorption = set["absorption_per_unit_length"].as_f64().unwrap();
        let studio = Studio::new(
            brilliant(),
            BuiltinMaterial::Diamond.material(),
            Absorption::even(absorption).unwrap(),
            Scene::default(),
        )
        .unwrap();
        let pictures: Vec<Film> = (0..6)
            .map(|seed| {
                let settings = FilmSettings {
                    size: 128,
                    seed,
                    ..FilmSettings::default()
                };
                let mut film = Film::new(studio.clone(), settings).unwrap();
                let wanted = if absorption > 0.0 {
                    &[546.074][..]
                } else {
                    &lines
                };
                film.trace_lines(wanted, 12, None, &go()).unwrap();
                film
            })
            .collect();
        for row in set["wavelengths"].as_array().unwrap() {
            is_in_the_pictures(row, absorption, &pictures);
        }
    }
}

#[test]
fn pictures_in_colour_agree_with_the_reference() {
    let golden = parsed(include_str!("../golden/diamond_colour.json"));
    for row in golden["lights"].as_array().unwrap() {
        let spike =
            |s: &Value| Line::ideal(s["at_nm"].as_f64().unwrap(), s["weight"].as_f64().unwrap());
        let spikes = row["spikes"]
            .as_array()
            .unwrap()
            .iter()
            .map(spike)
            .collect();
        let name = row["name"].as_str().unwrap();
        let light = Light::new(name, Band::VISIBLE, numbers(&row["smooth_1nm"]), spikes).unwrap();
        let white = light.white(Observer::CIE_1931);
        let expected_white = numbers(&row["white"]);
        for (found, expected) in white.to_array().iter().zip(&expected_white) {
            // Seven digits there; sums over whole nm instead of integrals, 1e-5 apart.
            assert!(
                (found / expected - 1.0).abs() < 2e-4,
                "{white:?} {expected_white:?}"
            );
        }
        let found: Vec<Vec<[f64; 3]>> = (0..6)
            .map(|seed| {
                let settings = FilmSettings {
                    size: 128,
                    seed,
                    ..FilmSettings::default()
                };
                let mut film = Film::new(studio(), settings).unwrap();
                film.trace(&light, 96, None, &go()).unwrap();
                let picture = film.picture(&light, Observer::CIE_1931);
                // Blocks are told for a white of Y 1.
                let back = |b: [f64; 3]| b.map(|v| v * picture.white.y);
                picture.blocks(16).into_iter().flatten().map(back).collect()
            })
            .collect();
        let blocks = blocks_with_errors(&found);
        let flat = |key: &str| -> Vec<Vec<f64>> {
            let rows = row[key].as_array().unwrap().iter();
            rows.flat_map(|r| r.as_array().unwrap().iter().map(numbers))
                .collect()
        };
        let (expected, errors) = (flat("xyz"), flat("standard_error_xyz"));
        let (mut outside, mut sum) = (0, 0.0);
        for (index, (found, own)) in blocks.iter().enumerate() {
            for k in 0..3 {
                let error = (errors[index][k].powi(2) + own[k].powi(2)).sqrt();
                let off = (found[k] - expected[index][k]) / error;
                sum += off * off;
                // Both errors are estimates from a few runs: Student's tails.
                outside += usize::from(off.abs() > 5.0);
            }
        }
        println!(
            "{name}: {outside} of 768 outside, mean square {:.2}",
            sum / 768.0
        );
        assert!(outside <= 8, "{name}: {outside}");
    }
}

#[test]
fn a_spectral_image_goes_out_and_comes_back() {
    let light = with_spikes(&smooth_light(0.0), &[(435.833, 20.0), (546.075, 30.0)]);
    let mut film = film(studio(), 24);
    film.trace(&light, 64, None, &go()).unwrap();
    let facts = [("light", light.name.clone()), ("view", "A".to_owned())];
    let file = light_exr([24, 24], spectral_planes(&film, &light), &facts).unwrap();
    let reading = read_bytes("gem.exr", &file).unwrap();
    assert_eq!(reading.images.len(), 1, "{:?}", reading.notes);
    let cube = &reading.images[0].cube;
    assert_eq!((cube.width(), cube.height(), cube.nm().len()), (24, 24, 40));
    assert_eq!((cube.nm()[0], cube.nm()[39]), (385.0, 775.0));
    let lines = lines_of_exr(&file);
    let places: Vec<f64> = lines.iter().map(|(nm, _)| *nm).collect();
    assert_eq!(places, [435.833, 546.075]);
    for (nm, weight) in [(435.833, 20.0_f32), (546.075, 30.0)] {
        let expected: Vec<f32> = film.transport(nm).iter().map(|t| weight * t).collect();
        let (_, found) = lines.iter().find(|(at, _)| *at == nm).unwrap();
        assert_eq!(found, &expected, "exact energy");
    }
    // Smooth part and spikes come apart again: the strata less the lines are the smooth planes.
    for (x, y) in [(12, 12), (3, 20), (0, 0)] {
        let pixel = y * 24 + x;
        let total: f64 = (0..40).map(|band| 10.0 * cube.value(x, y, band)).sum();
        let spikes: f64 = lines.iter().map(|(_, e)| f64::from(e[pixel])).sum();
        let smooth: f64 = (0..40)
            .map(|j| {
                let from = 380.0 + 10.0 * j as f64;
                let mean = (0..10).map(|i| {
                    let nm = from + f64::from(i);
                    0.5 * (light.smooth_at(nm) + light.smooth_at(nm + 1.0))
                });
                mean.sum::<f64>() * f64::from(film.plane(j)[pixel])
            })
            .sum();
        // Single precision over 40 channels.
        assert!((total / (smooth + spikes) - 1.0).abs() < 1e-5, "{total}");
    }
}

#[test]
fn the_json_has_the_keys_that_were_asked_for() {
    let cut = Brilliant::default();
    let light = with_spikes(&smooth_light(0.0), &[(546.075, 30.0)]);
    let mut film = film(studio(), 40);
    film.trace(&light, 64, None, &go()).unwrap();
    let picture = film.picture(&light, Observer::CIE_1931);
    let report = |wavelength_nm: Option<f64>| {
        gem_json(&GemReport {
            film: &film,
            picture: &picture,
            noise: film.noise(&light, Observer::CIE_1931),
            light: &light,
            wavelength_nm,
            cut: Some(&cut),
            rays: 64,
            blocks: None,
            seconds: 1.5,
        })
    };
    let json = report(None);
    assert_eq!(
        (json["size"].as_u64(), json["rays"].as_u64()),
        (Some(40), Some(64))
    );
    for key in ["relative_mse", "delta_e_median", "delta_e_p95"] {
        assert!(json["noise"][key].as_f64().unwrap() > 0.0, "{key}");
    }
    let segments = json["segments_per_ray"].as_f64().unwrap();
    assert!(
        (10.0..25.0).contains(&segments),
        "17 on the gem: {segments}"
    );
    let blocks = json["blocks"].as_array().unwrap();
    assert!(blocks.len() == 16 && blocks.iter().all(|r| r.as_array().unwrap().len() == 16));
    assert_eq!(json["mean"].as_array().unwrap().len(), 3);
    assert_eq!(json["seconds"], 1.5);
    // The corner shows the dome.
    let corner = numbers(&json["blocks"][0][0]);
    let white = numbers(&json["white"]);
    assert!(
        (0..3).all(|k| (corner[k] - 0.1 * white[k]).abs() < 1e-5),
        "{corner:?}"
    );
    let mono = report(Some(546.075));
    assert!((mono["blocks"][0][0].as_f64().unwrap() - 0.1).abs() < 1e-6);
    assert!(mono["mean"].is_number());
}

#[test]
fn a_material_that_is_known_in_part_is_traced_in_part() {
    let nm: Vec<f64> = (500..=600).map(f64::from).collect();
    let n = vec![1.5; nm.len()];
    let table = spectral_explorer::spectrum::Sampled::new(nm, n).unwrap();
    let glass = Material::from_table("half", "", &table, false).unwrap();
    let studio = Studio::new(brilliant(), glass, Absorption::None, Scene::default()).unwrap();
    let mut film = film(studio, 16);
    film.trace(&smooth_light(0.0), 64, None, &go()).unwrap();
    let strata: Vec<f64> = (0..40)
        .map(|j| film.plane(j).iter().map(|v| f64::from(*v)).sum())
        .collect();
    assert!(strata[5] == 0.0 && strata[15] > 0.0);
    let picture = film.picture(&smooth_light(0.0), Observer::CIE_1931);
    assert!(picture.xyz.iter().flatten().all(|v| v.is_finite()));
}
