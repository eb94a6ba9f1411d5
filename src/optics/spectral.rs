//! A film under a light as planes of wavelengths.

use super::{film::Film, light::Light, plane::Plane};

/// Planes at wavelengths (nm), each row after row from the top.
pub(crate) type SpectralPlanes = Vec<(f64, Vec<f32>)>;

/// The strata at their middles, with the whole light a nm (a spike's energy over the stratum's
/// width added in its stratum: energy is kept), and the spikes, each with its exact energy, value
/// x nm.
pub(crate) fn spectral_planes(film: &Film, light: &Light) -> [SpectralPlanes; 2] {
    let times = |plane: Vec<f32>, factor: f32| plane.iter().map(|t| factor * t).collect();
    let spike = |spike: crate::spectrum::Line| {
        let energy = times(film.transport(spike.at_nm), spike.weight as f32);
        (spike.at_nm, energy)
    };
    let spikes: SpectralPlanes = light.seen_spikes().map(spike).collect();
    let mut strata = SpectralPlanes::new();
    for (place, plane) in film.planes().iter().enumerate() {
        let Plane::Stratum { from_nm, to_nm } = *plane else {
            continue;
        };
        let width = to_nm - from_nm;
        let mean = (light.smooth_power([from_nm, to_nm]) / width) as f32;
        let mut values: Vec<f32> = times(film.plane(place), mean);
        let is_last = to_nm >= super::light::SEEN_NM[1];
        for (nm, energy) in &spikes {
            if *nm >= from_nm && (*nm < to_nm || (is_last && *nm <= to_nm)) {
                let over = (1.0 / width) as f32;
                let values = values.iter_mut().zip(energy);
                values.for_each(|(v, e)| *v += over * e);
            }
        }
        strata.push((0.5 * (from_nm + to_nm), values));
    }
    [strata, spikes]
}
