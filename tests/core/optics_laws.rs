//! What holds at every face, in every prism, drop and cut stone, and what is refused.

use spectral_explorer::{
    color::{Observer, Xyz},
    optics::{
        Brilliant, BuiltinMaterial, DropRay, HalfSpace, Incidence, Light, Material, Passage, Prism,
        Scene, Sky, Solid, bow, limits, minimum_deviation, reflectances,
    },
    spectrum::{Band, Line, Sampled},
};

fn prism(apex_deg: f64, incidence_deg: f64) -> Prism {
    let glass = BuiltinMaterial::NSf11.material();
    Prism::new(apex_deg, Incidence::Degrees(incidence_deg), &glass).unwrap()
}

/// The way through a prism of 60 degrees.
fn through(incidence_deg: f64, n: f64) -> Option<Passage> {
    prism(60.0, incidence_deg).passage(n)
}

#[test]
fn materials_have_their_published_figures() {
    // SCHOTT's data sheets; the gem trade's fire .044, .060, .018. Half a unit of the last
    // digit printed.
    for (stuff, n_d, v_d, fire) in [
        (BuiltinMaterial::NBk7, 1.5168, 64.17, 0.0138),
        (BuiltinMaterial::NSf11, 1.784_72, 25.68, 0.0548),
        (BuiltinMaterial::NSf10, 1.728_28, 28.53, 0.0455),
        (BuiltinMaterial::Silica, 1.458_46, 67.82, 0.0115),
        (BuiltinMaterial::Diamond, 2.417_48, 55.30, 0.044),
        (BuiltinMaterial::Zirconia, 2.158_77, 33.54, 0.060),
        (BuiltinMaterial::Sapphire, 1.768_17, 72.31, 0.018),
    ] {
        let figures = stuff.material().abbe().unwrap();
        assert!((figures.n_d - n_d).abs() < 1e-5, "{stuff:?} {figures:?}");
        assert!((figures.v_d - v_d).abs() < 5e-3, "{stuff:?} {figures:?}");
        assert!((figures.fire - fire).abs() < 5e-4, "{stuff:?} {figures:?}");
    }
}

#[test]
fn the_slope_of_an_index_is_its_slope() {
    for stuff in BuiltinMaterial::ALL {
        let material = stuff.material();
        for at_nm in [400.0, 587.5618, 760.0] {
            let n = |nm: f64| material.index(nm).unwrap();
            let slope = (n(at_nm + 0.05) - n(at_nm - 0.05)) / 0.1;
            let found = material.d_index_d_nm(at_nm).unwrap();
            // The central difference of .1 nm is off by its third derivative, about 1e-10 of
            // 1e-4, and rounding of 1e-15 over 0.1.
            assert!((found / slope - 1.0).abs() < 1e-6, "{stuff:?} {at_nm}");
        }
    }
}

#[test]
fn two_numbers_come_back() {
    let glass = Material::from_two_numbers(1.62, 36.3).unwrap();
    let figures = glass.abbe().unwrap();
    assert!((figures.n_d - 1.62).abs() < 1e-14);
    assert!((figures.v_d - 36.3).abs() < 1e-10);
    let is_guess = glass.is_extrapolated(500.0);
    assert!(is_guess, "two numbers are no measurement");
}

#[test]
fn a_formula_ends_at_its_resonances() {
    let zirconia = BuiltinMaterial::Zirconia.material();
    assert!(zirconia.index(361.0).is_ok() && !zirconia.is_extrapolated(361.0));
    // Its resonance is at 166.739 nm; 5 % above is 175.08.
    assert!(zirconia.index(175.2).is_ok() && zirconia.is_extrapolated(175.2));
    assert!(zirconia.index(175.0).is_err());
    let silica = BuiltinMaterial::Silica.material();
    // Beyond the infrared resonance the formula would give an index again.
    assert!(silica.index(12_000.0).is_err());
    for nothing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(silica.index(nothing).is_err());
        assert!(silica.d_index_d_nm(nothing).is_err());
    }
}

#[test]
fn a_table_gives_the_formula_it_was_made_of() {
    let diamond = BuiltinMaterial::Diamond.material();
    let nm: Vec<f64> = (380..=780).map(f64::from).collect();
    let n: Vec<f64> = nm.iter().map(|nm| diamond.index(*nm).unwrap()).collect();
    let table = Sampled::new(nm, n).unwrap();
    let tabled = Material::from_table("t", "", &table, false).unwrap();
    for at_nm in [380.0, 404.656, 546.074, 779.9] {
        let exact = diamond.index(at_nm).unwrap();
        // Between whole nm the third derivative of n, 4e-8 a nm^3, is left.
        assert!((tabled.index(at_nm).unwrap() - exact).abs() < 1e-7);
    }
    let slope = tabled.d_index_d_nm(600.0).unwrap();
    assert!((slope / diamond.d_index_d_nm(600.0).unwrap() - 1.0).abs() < 1e-3);
    assert_eq!(
        tabled.index(800.0).unwrap_err().to_string(),
        "t: expected a wavelength at which its index is known, 380 to 780 nm, found 800 nm"
    );
    let not = Sampled::new(vec![1.0, 2.0], vec![1.5, -1.0]).unwrap();
    assert!(Material::from_table("t", "", &not, false).is_err());
}

#[test]
fn a_sixth_of_the_light_comes_back_from_diamond() {
    let n = BuiltinMaterial::Diamond.material().index(589.294).unwrap();
    let [s, p] = reflectances(1.0, 1.0, n, 1.0);
    // The definition's six digits.
    assert!((s - 0.172_006).abs() < 5e-7, "{s}");
    assert_eq!(s, p);
}

#[test]
fn at_the_brewster_angle_no_p_light_comes_back() {
    let n: f64 = 1.5;
    let incidence = n.atan();
    let refraction = (incidence.sin() / n).asin();
    let [s, p] = reflectances(1.0, incidence.cos(), n, refraction.cos());
    assert!(p < 1e-30 && s > 0.1);
}

#[test]
fn both_ways_through_a_face_reflect_alike() {
    let (cos1, cos2) = (0.3_f64.cos(), (0.3_f64.sin() / 1.7).asin().cos());
    let there = reflectances(1.0, cos1, 1.7, cos2);
    let back = reflectances(1.7, cos2, 1.0, cos1);
    assert!((0..2).all(|k| (there[k] - back[k]).abs() < 1e-15));
}

#[test]
fn the_least_deviation_is_the_least_and_symmetric() {
    let n = BuiltinMaterial::NSf11.material().index(546.075).unwrap();
    let (least, incidence) = minimum_deviation(n, 60.0).unwrap();
    let at = |degrees: f64| through(degrees, n).unwrap();
    // Sums of a few angles near 60 degrees.
    assert!((at(incidence).deviation_deg - least).abs() < 1e-12);
    assert!((at(incidence).exit_deg - incidence).abs() < 1e-12);
    for off in [-2.0, -0.1, 0.1, 2.0] {
        assert!(at(incidence + off).deviation_deg > least);
    }
}

#[test]
fn the_way_back_through_a_prism_is_the_way_there() {
    let there = through(45.0, 1.5168).unwrap();
    let back = through(there.exit_deg, 1.5168).unwrap();
    assert!((back.exit_deg - 45.0).abs() < 1e-11);
    assert!((back.deviation_deg - there.deviation_deg).abs() < 1e-11);
    assert!((back.transmittance() - there.transmittance()).abs() < 1e-12);
}

#[test]
fn at_the_smallest_incidence_the_ray_leaves_along_the_face() {
    let n = 1.842_352_46;
    let smallest = limits(n, 60.0).smallest_incidence_deg.unwrap();
    assert!(through(smallest - 1e-6, n).is_none());
    let grazing = through(smallest + 1e-6, n).unwrap();
    assert!(grazing.exit_deg > 89.9 && grazing.transmittance() < 0.01);
}

#[test]
fn no_ray_passes_a_blunt_prism() {
    for degrees in -89..90 {
        for apex in [100.0, 150.0, 179.0] {
            let passage = prism(apex, f64::from(degrees)).passage(1.79);
            assert!(passage.is_none(), "{apex} {degrees}");
        }
    }
}

#[test]
fn reflection_at_the_bows_does_not_depend_on_the_index() {
    for n in [1.1, 1.333, 1.5, 1.9] {
        for (order, r, weight) in [
            (1, 1.0 / 9.0, (8.0_f64 / 9.0).powi(2) / 9.0),
            (2, 1.0 / 4.0, 0.75_f64.powi(2) / 16.0),
        ] {
            let bow = bow(n, order).unwrap();
            // tan i = (k + 1) tan r; a few operations on numbers below 1.
            assert!((bow.ray.reflectance_s_p[0] - r).abs() < 1e-14);
            assert!((bow.weights_s_p[0] - weight).abs() < 1e-14);
        }
    }
}

#[test]
fn at_a_bow_the_deviation_stands_still() {
    for order in [1, 2] {
        let bow = bow(1.333, order).unwrap();
        let at = |off: f64| DropRay::new(bow.ray.impact + off, 1.333).deviation_deg(order);
        assert!(at(1e-3) > bow.deviation_deg && at(-1e-3) > bow.deviation_deg);
        // Quadratic: a hundredth of the way, a ten thousandth of the rise.
        let ratio = (at(1e-4) - bow.deviation_deg) / (at(1e-2) - bow.deviation_deg);
        assert!(ratio < 2e-4, "{ratio}");
    }
}

#[test]
fn all_ways_out_of_a_drop_make_the_whole() {
    for impact in [0.0, 0.3, 0.86, 0.99, 1.0] {
        let ray = DropRay::new(impact, 1.333);
        for polarisation in 0..2 {
            let outside = ray.reflectance_s_p[polarisation];
            let inside: f64 = (0..4000).map(|k| ray.weights_s_p(k)[polarisation]).sum();
            // 4000 terms; at b = .99 R = .58, so nothing is left after 100.
            assert!((outside + inside - 1.0).abs() < 1e-12, "{impact}");
        }
    }
}

#[test]
fn bows_end_where_the_index_is_too_high() {
    assert!(bow(2.1, 1).is_none() && bow(2.1, 2).is_some());
    assert!(bow(1.333, 0).is_none() && bow(1.0, 1).is_none());
    assert!(bow(f64::NAN, 1).is_none());
}

#[test]
fn bodies_of_school_have_their_measures() {
    let cube = cube();
    assert_eq!((cube.corners().len(), cube.edges()), (8, 12));
    // Corners come from a square of ten thousand units, rounded at 1e-12.
    assert!((cube.volume() - 1.0).abs() < 1e-9 && (cube.area() - 6.0).abs() < 1e-9);
    let octahedron = Solid::octahedron(1.0).unwrap();
    assert_eq!((octahedron.corners().len(), octahedron.edges()), (6, 12));
    assert!((octahedron.volume() - 4.0 / 3.0).abs() < 1e-9);
    assert!(octahedron.contains([0.3, 0.3, 0.3]) && !octahedron.contains([0.5, 0.5, 0.5]));
}

#[test]
fn the_default_cut_has_the_facets_and_measures_of_its_definition() {
    let solid = Brilliant::default().solid().unwrap();
    assert_eq!(solid.planes().len(), 73);
    assert_eq!((solid.corners().len(), solid.edges()), (57, 128));
    for (plane, facet) in solid.planes().iter().zip(solid.facets()) {
        let sides = match plane.name {
            "table" => 8,
            "stars" | "upper halves" | "lower halves" => 3,
            _ => 4,
        };
        assert_eq!(facet.len(), sides, "{}", plane.name);
    }
    // Six digits are given.
    let [volume, area] = [solid.volume(), solid.area()];
    assert!((volume - 1.675_034).abs() < 5e-7, "{volume}");
    assert!((area - 8.016_930).abs() < 5e-7, "{area}");
    let heights = solid.corners().iter().map(|c| c[2]);
    let (low, high) = heights.fold((0.0_f64, 0.0_f64), |(a, b), z| (a.min(z), b.max(z)));
    assert!((high - 0.325_531).abs() < 5e-7 && (low + 0.891_655).abs() < 5e-7);
    for (name, degrees) in [
        ("stars", 21.4341),
        ("upper halves", 41.1133),
        ("lower halves", 41.9401),
    ] {
        let plane = solid.planes().iter().find(|p| p.name == name).unwrap();
        let slope = plane.normal[2].abs().acos().to_degrees();
        assert!((slope - degrees).abs() < 5e-5, "{name} {slope}");
    }
}

#[test]
fn a_culet_is_a_facet_more() {
    let cut = Brilliant {
        culet: 0.05,
        ..Brilliant::default()
    };
    let solid = cut.solid().unwrap();
    assert_eq!((cut.facets(), solid.planes().len()), (58, 74));
    assert!(solid.facets().last().unwrap().len() >= 8);
}

/// Half-spaces of a cube without its lid, and the lid.
fn open_cube() -> (Vec<HalfSpace>, HalfSpace) {
    let mut planes = Solid::cube(1.0).unwrap().planes().to_vec();
    let lid = planes.remove(4);
    (planes, lid)
}

#[test]
fn what_is_none_is_refused_in_words() {
    let (mut planes, lid) = open_cube();
    let open = Solid::new(planes.clone()).unwrap_err().to_string();
    let halo = HalfSpace {
        distance: 3.0,
        name: "halo",
        ..lid.clone()
    };
    planes.extend([lid, halo]);
    let lost = Solid::new(planes).unwrap_err().to_string();
    let two = |n_d: f64, v_d: f64| Material::from_two_numbers(n_d, v_d).unwrap_err();
    let cut = Brilliant {
        table: 1.5,
        ..Brilliant::default()
    };
    let diamond = BuiltinMaterial::Diamond.material();
    let blunt = Prism::new(60.0, Incidence::MinimumFor(546.075), &diamond).unwrap_err();
    for (found, expected) in [
        (open, "expected a closed body, found the side open"),
        (
            lost,
            "expected a facet for each plane, found none for the halo",
        ),
        (
            two(1.0, 50.0).to_string(),
            "n_d: expected a number from 1.0001 to 10, found 1",
        ),
        (
            two(f64::NAN, 50.0).to_string(),
            "n_d: expected a number from 1.0001 to 10, found NaN",
        ),
        (
            two(1.5, 0.0).to_string(),
            "V_d: expected a number above 0, found 0",
        ),
        (
            two(1.5, -3.0).to_string(),
            "V_d: expected a number above 0, found -3",
        ),
        (
            cut.solid().unwrap_err().to_string(),
            "table: expected a number between 0 and 1, both left out, found 1.5",
        ),
        (
            blunt.to_string(),
            "no light of 546.075 nm leaves: apex above twice the critical angle (48.7)",
        ),
    ] {
        assert_eq!(found, expected);
    }
    assert!(Solid::cube(-1.0).is_err() && Solid::cube(f64::NAN).is_err());
    assert!(Solid::new(Vec::new()).is_err());
    for apex in [0.0, -1.0, 180.0, f64::NAN, f64::INFINITY] {
        let said = Prism::new(apex, Incidence::Degrees(45.0), &diamond).unwrap_err();
        let expected = "apex: expected an angle above 0 and below 180 degrees, found";
        assert_eq!(said.to_string(), format!("{expected} {apex}"));
    }
    for incidence in [90.0, -90.0, f64::NAN] {
        assert!(Prism::new(60.0, Incidence::Degrees(incidence), &diamond).is_err());
    }
}

#[test]
fn cuts_out_of_range_are_refused() {
    let cases: [fn(&mut Brilliant); 9] = [
        |cut| cut.table = 0.0,
        |cut| cut.table = 1.0,
        |cut| cut.table = f64::NAN,
        |cut| cut.crown_deg = 90.0,
        |cut| cut.pavilion_deg = -1.0,
        |cut| cut.girdle = 0.0,
        |cut| cut.culet = -0.1,
        |cut| cut.star = 1.0,
        |cut| cut.lower = 0.0,
    ];
    for change in cases {
        let mut cut = Brilliant::default();
        change(&mut cut);
        assert!(cut.solid().is_err(), "{cut:?}");
    }
}

fn sky() -> Sky {
    Sky::new(BuiltinMaterial::Water.material(), 500)
}

#[test]
fn a_sodium_bow_stands_at_the_angles_of_its_rays() {
    let sky = sky();
    let light = Light::of_line(589.294).unwrap();
    let strip = sky.strip(&light, Observer::CIE_1931, false);
    let [from_deg, to_deg] = strip.ends_deg;
    let cell = (to_deg - from_deg) / 500.0;
    let brightest = |from: f64, to: f64| {
        let place = |deg: f64| ((deg - from_deg) / cell) as usize;
        (place(from)..place(to))
            .max_by(|a, b| strip.xyz[*a].y.total_cmp(&strip.xyz[*b].y))
            .map(|index| from_deg + (index as f64 + 0.5) * cell)
            .unwrap()
    };
    let n = sky.material().index(589.294).unwrap();
    let primary = bow(n, 1).unwrap().from_antisolar_deg;
    let secondary = bow(n, 2).unwrap().from_antisolar_deg;
    // Within the column of .05 degrees that holds the bow.
    assert!((brightest(38.0, 45.0) - primary).abs() <= cell);
    assert!((brightest(47.0, 58.0) - secondary).abs() <= cell);
    // Alexander's dark band between them: no ray of one or two reflections goes there.
    let dark = ((46.0 - from_deg) / cell) as usize;
    assert_eq!(strip.xyz[dark], Xyz::ZERO);
}

#[test]
fn the_strip_is_linear_in_the_light() {
    let sky = sky();
    let (a, b) = (546.075, 435.833);
    let one = |nm: f64| sky.strip(&Light::of_line(nm).unwrap(), Observer::CIE_1931, true);
    let band = Band::VISIBLE;
    let spikes = [a, b].map(|at_nm| Line::ideal(at_nm, 1.0));
    let both = Light::new("both", band, vec![0.0; 401], spikes.to_vec()).unwrap();
    let both = sky.strip(&both, Observer::CIE_1931, true);
    let (a, b) = (one(a), one(b));
    for (index, xyz) in both.xyz.iter().enumerate() {
        let off = *xyz - (a.xyz[index] + b.xyz[index]);
        // A few sums of numbers about 1.
        assert!(off.to_array().iter().all(|v| v.abs() < 1e-12));
    }
}

fn cube() -> Solid {
    Solid::cube(0.5).unwrap()
}

#[test]
fn invalid_scenes_are_refused_in_words() {
    let refused = |change: &dyn Fn(&mut Scene)| {
        let mut scene = Scene::default();
        change(&mut scene);
        scene.camera(&cube()).unwrap_err().to_string()
    };
    assert_eq!(
        refused(&|s| s.view.from = [0.1, 0.0, 0.0]),
        "view: expected a camera outside the gem, found it inside"
    );
    assert_eq!(
        refused(&|s| {
            s.lamps[1].centre = [0.0, -2.3, 3.5];
            s.lamps[1].half_edge_u = [1.0, 0.0, 0.0];
            s.lamps[1].half_edge_v = [0.0, -1.0, 0.0];
        }),
        "view: expected a free view of the gem, found the camera behind lamp 2"
    );
    assert!(refused(&|s| s.view.angle_deg = 180.0).starts_with("angle"));
    assert!(refused(&|s| s.view.from = s.view.towards).contains("view: expected a camera"));
    assert!(refused(&|s| s.view.from[0] = f64::NAN).contains("not finite"));
    assert!(refused(&|s| s.lamps[0].half_edge_u = [0.0; 3]).starts_with("lamp 1"));
    assert!(refused(&|s| s.lamps[0].centre = [0.0; 3]).contains("inside"));
    assert!(refused(&|s| s.dome = -1.0).starts_with("dome"));
}

#[test]
fn straight_from_above_there_is_a_picture_too() {
    let mut scene = Scene::default();
    scene.view.from = [0.0, 0.0, 9.0];
    scene.lamps.clear();
    scene.view.towards = [0.0; 3];
    let camera = scene.camera(&cube()).unwrap();
    assert!(camera.direction([0.3, 0.2]).iter().all(|v| v.is_finite()));
}
