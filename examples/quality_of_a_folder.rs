//! Ra of every light in a folder, measured and modelled: `cargo run --example quality_of_a_folder lamps`.

use spectral_explorer::{
    color::quality::{FewFigures, Light},
    io,
    lamps::FitOptions,
    spectrum::{Composite, Kind},
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).ok_or("expected a folder")?;
    for file in std::fs::read_dir(folder)? {
        let Ok(reading) = io::read_path(&file?.path()) else {
            continue;
        };
        for light in reading
            .spectra
            .iter()
            .filter(|found| found.kind == Kind::Light)
        {
            let fit = Composite::fit(&light.samples, &FitOptions::default());
            let lights = [
                Light::of_sampled(&light.samples),
                Light::of_composite(&fit.composite),
            ];
            let [measured, modelled] = lights.map(|light| FewFigures::of(&light).ra);
            if let (Ok(measured), Ok(modelled)) = (measured, modelled) {
                println!("{}: Ra {measured:.1}, model {modelled:.1}", light.name);
            }
        }
    }
    Ok(())
}
