//! A lamp behind a filter, both as composites: `cargo run --example lamp_through_glass`.

use spectral_explorer::{
    color::{Observer, Xyz, delta_e_of_xyz},
    lamps::FitOptions,
    preset,
    spectrum::{Composite, Outside},
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let lamp = preset::table("cie_fluorescent_1nm", "FL11").ok_or("no lamp")?;
    let glass = preset::table("colorchecker_ohta", "orange").ok_or("no surface")?;
    let light = Composite::fit(lamp, &FitOptions::default().order(10)).composite;
    let factor = Composite::fit(glass, &FitOptions::of_a_factor().order(10)).composite;
    let behind = light.times(factor.smooth())?;
    let measured = |nm: f64| lamp.at(nm, Outside::Zero) * glass.at(nm, Outside::Hold);
    let table = Observer::CIE_1931.table();
    let truth = (360..=830).map(f64::from).fold(Xyz::ZERO, |sum, nm| {
        sum + Xyz::from_array(table.at(nm)) * measured(nm)
    });
    let white = light.xyz(Observer::CIE_1931);
    let seen = behind.xyz(Observer::CIE_1931);
    let off = delta_e_of_xyz(truth, seen, white).ok_or("no light")?;
    println!(
        "{:.1} % of Y comes back; model against table dE00 {off:.3}",
        100.0 * seen.y / white.y
    );
    Ok(())
}
