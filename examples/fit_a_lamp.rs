//! Fits a lamp's table and prints its numbers and its colour: `cargo run --example fit_a_lamp lamp.csv`.

use spectral_explorer::{
    color::{Observer, xy_from_xyz},
    io,
    lamps::FitOptions,
    preset,
    spectrum::Composite,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let lamp = match std::env::args().nth(1) {
        Some(path) => io::read_path(path.as_ref())?.spectra.swap_remove(0).samples,
        None => preset::table("cie_fluorescent_1nm", "FL2")
            .ok_or("not shipped")?
            .clone(),
    };
    let fit = Composite::fit(&lamp, &FitOptions::default());
    let smooth = fit.composite.smooth();
    println!("{} series of order {}", smooth.basis.word(), smooth.order());
    for line in fit.composite.lines() {
        println!("{:.2} nm, weight {:.3}", line.at_nm, line.weight);
    }
    let [x, y] = xy_from_xyz(fit.composite.xyz(Observer::CIE_1931)).ok_or("no light")?;
    println!("x {x:.4} y {y:.4}, {} numbers", fit.composite.numbers());
    Ok(())
}
