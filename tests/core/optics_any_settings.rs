//! Whatever is asked: numbers or words, never NaN, never a panic.

use proptest::prelude::*;
use spectral_explorer::{
    color::Observer,
    optics::{
        Bench, BenchSettings, Brilliant, BuiltinMaterial, DropRay, Incidence, Light, Material,
        Solid, bow, prism_json,
    },
    spectrum::{Band, Line},
};

fn stuff() -> impl Strategy<Value = BuiltinMaterial> {
    (0..BuiltinMaterial::ALL.len()).prop_map(|i| BuiltinMaterial::ALL[i])
}

/// Any number at all, more often one that may be meant.
fn any_number(meant: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    prop_oneof![8 => meant, 1 => any::<f64>()]
}

fn light() -> Light {
    let band = Band::VISIBLE;
    let smooth = band
        .grid()
        .map(|nm| 1.0 + 0.4 * (nm / 50.0).cos())
        .collect();
    let spikes = [404.656, 546.075, 611.0].map(|at_nm| Line::ideal(at_nm, 9.0));
    Light::new("lamp", band, smooth, spikes.to_vec()).unwrap()
}

proptest! {
    #[test]
    fn an_index_is_above_one_or_refused(stuff in stuff(), nm in any_number(100.0..3000.0)) {
        let material = stuff.material();
        match (material.index(nm), material.d_index_d_nm(nm)) {
            (Ok(n), Ok(slope)) => prop_assert!(n > 1.0 && n.is_finite() && slope.is_finite()),
            (Err(_), Err(_)) => {}
            other => prop_assert!(false, "{other:?}"),
        }
    }

    #[test]
    fn two_numbers_make_a_glass_or_are_refused(
        n_d in any_number(1.0..3.0),
        v_d in any_number(-5.0..100.0),
        nm in 380.0..780.0,
    ) {
        if let Ok(glass) = Material::from_two_numbers(n_d, v_d) {
            prop_assert!(glass.index(nm).is_ok_and(|n| n > 1.0) || glass.index(nm).is_err());
        }
    }

    #[test]
    fn a_bench_keeps_all_energy_or_is_refused(
        stuff in stuff(),
        apex in any_number(1.0..120.0),
        incidence in any_number(-80.0..89.0),
        slit in any_number(0.001..50.0),
        screen in any_number(10.0..3000.0),
        columns in 1_usize..700,
    ) {
        let settings = BenchSettings {
            apex_deg: apex,
            incidence: Incidence::Degrees(incidence),
            slit_mm: slit,
            screen_mm: screen,
            ..BenchSettings::default()
        };
        let Ok(bench) = Bench::new(settings, stuff.material()) else {
            return Ok(());
        };
        let light = light();
        let Some(screen) = bench.whole_screen(&light, columns) else {
            return Ok(());
        };
        let strip = bench.strip(&light, screen, Observer::CIE_1931);
        let on: f64 = strip.smooth.iter().chain(&strip.lines).sum();
        prop_assert!(on.is_finite() && strip.energy.is_finite());
        let kept = on + strip.share_beside * strip.energy;
        // Sums of up to some ten thousand cells.
        prop_assert!((kept - strip.energy).abs() <= 1e-9 * strip.energy.max(1.0));
        prop_assert!(strip.xyz.iter().all(|xyz| xyz.is_finite()));
        prop_assert!(strip.images.len() + strip.lost_spikes_nm.len() == 3);
        let text = prism_json(&bench, &light, &[450.0], Some(&strip)).to_string();
        prop_assert!(!text.contains("NaN"));
    }

    #[test]
    fn a_drop_sends_out_what_falls_on_it(n in 1.01..3.0, impact in any_number(0.0..1.0)) {
        let ray = DropRay::new(impact, n);
        if impact.is_finite() {
            let [s, p] = ray.reflectance_s_p;
            prop_assert!((0.0..=1.0).contains(&s) && (0.0..=1.0 + 1e-12).contains(&p));
        }
        if let Some(bow) = bow(n, 1) {
            prop_assert!((0.0..=180.0).contains(&bow.from_antisolar_deg));
        }
    }

    #[test]
    fn a_cut_is_a_closed_body_or_is_refused(
        table in any_number(0.2..0.95),
        crown in any_number(5.0..70.0),
        pavilion in any_number(10.0..70.0),
        star in any_number(0.1..0.9),
        lower in any_number(0.1..0.95),
        girdle in any_number(0.005..0.2),
        culet in prop_oneof![3 => Just(0.0), 2 => 0.001..0.3],
    ) {
        let cut = Brilliant {
            table, crown_deg: crown, pavilion_deg: pavilion, star, lower, girdle, culet,
        };
        let Ok(solid) = cut.solid() else {
            return Ok(());
        };
        prop_assert!(is_closed(&solid), "{cut:?}");
        prop_assert!(solid.volume() > 0.0 && solid.volume() < 30.0);
    }
}

/// Euler's formula.
fn is_closed(solid: &Solid) -> bool {
    solid.corners().len() + solid.facets().len() == solid.edges() + 2
}
