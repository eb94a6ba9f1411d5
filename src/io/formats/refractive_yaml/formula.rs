//! The nine dispersion formulas of refractiveindex.info (its document "Dispersion formulas").
//!
//! With `l` the wavelength in um and coefficients C1, C2, ...:
//!
//! ```text
//! 1 Sellmeier    n2 - 1 = C1 + C2 l2/(l2 - C3^2) + C4 l2/(l2 - C5^2) + ...
//! 2 Sellmeier-2  n2 - 1 = C1 + C2 l2/(l2 - C3) + C4 l2/(l2 - C5) + ...
//! 3 polynomial   n2 = C1 + C2 l^C3 + C4 l^C5 + ...
//! 4 the site's   n2 = C1 + C2 l^C3/(l2 - C4^C5) + C6 l^C7/(l2 - C8^C9) + C10 l^C11 + ...
//! 5 Cauchy       n = C1 + C2 l^C3 + C4 l^C5 + ...
//! 6 gases        n - 1 = C1 + C2/(C3 - l^-2) + C4/(C5 - l^-2) + ...
//! 7 Herzberger   n = C1 + C2/(l2 - 0.028) + C3 (1/(l2 - 0.028))^2 + C4 l2 + C5 l^4 + C6 l^6
//! 8 retro        (n2 - 1)/(n2 + 2) = C1 + C2 l2/(l2 - C3) + C4 l2
//! 9 exotic       n2 = C1 + C2/(l2 - C3) + C4 (l - C5)/((l - C5)^2 + C6)
//! ```

/// Refractive index by formula `number` at a wavelength in um; NaN for a number that is none, and
/// where the formula has no real value. Missing coefficients are zero.
pub(crate) fn index(number: u8, coefficients: &[f64], um: f64) -> f64 {
    let c = |place: usize| coefficients.get(place - 1).copied().unwrap_or(0.0);
    let square = um * um;
    // Pairs (C2, C3), (C4, C5), ... from a place on.
    let pairs = |from: usize| {
        let rest = coefficients.get(from - 1..).unwrap_or(&[]);
        rest.chunks_exact(2).map(|pair| (pair[0], pair[1]))
    };
    let powers = |from: usize| pairs(from).map(|(a, b)| a * um.powf(b)).sum::<f64>();
    match number {
        1 => {
            let terms: f64 = pairs(2).map(|(a, b)| a * square / (square - b * b)).sum();
            (1.0 + c(1) + terms).sqrt()
        }
        2 => {
            let terms: f64 = pairs(2).map(|(a, b)| a * square / (square - b)).sum();
            (1.0 + c(1) + terms).sqrt()
        }
        3 => (c(1) + powers(2)).sqrt(),
        4 => {
            let term = |from: usize| {
                if c(from) == 0.0 {
                    return 0.0;
                }
                c(from) * um.powf(c(from + 1)) / (square - c(from + 2).powf(c(from + 3)))
            };
            (c(1) + term(2) + term(6) + powers(10)).sqrt()
        }
        5 => c(1) + powers(2),
        6 => {
            let terms: f64 = pairs(2).map(|(a, b)| a / (b - 1.0 / square)).sum();
            1.0 + c(1) + terms
        }
        7 => {
            let part = 1.0 / (square - 0.028);
            c(1) + c(2) * part
                + c(3) * part * part
                + c(4) * square
                + c(5) * square * square
                + c(6) * square * square * square
        }
        8 => {
            let ratio = c(1) + c(2) * square / (square - c(3)) + c(4) * square;
            ((1.0 + 2.0 * ratio) / (1.0 - ratio)).sqrt()
        }
        9 => {
            let off = um - c(5);
            (c(1) + c(2) / (square - c(3)) + c(4) * off / (off * off + c(6))).sqrt()
        }
        _ => f64::NAN,
    }
}

#[cfg(test)]
mod tests {
    use super::index;

    /// Published values: n at a wavelength (um) by the formula and coefficients of the site.
    #[test]
    fn published_indices_are_met() {
        // Water by Daimon and Masumura 2007, 20 C: 1.33336 at 587.6 nm.
        let water = [
            0.0,
            5.684_027_565e-1,
            5.101_829_712e-3,
            1.726_177_391e-1,
            1.821_153_936e-2,
            2.086_189_578e-2,
            2.620_722_293e-2,
            1.130_748_688e-1,
            1.069_792_721e1,
        ];
        assert!((index(2, &water, 0.5876) - 1.3334).abs() < 2e-4);
        // Air by Ciddor 1996: 1.000277 at 589.3 nm.
        let air = [0.0, 0.057_921_05, 238.0185, 0.001_679_17, 57.362];
        assert!((index(6, &air, 0.5893) - 1.000_277).abs() < 1e-6);
        // Silver bromide by Schroeter 1931 (formula 8): about 2.25 at 589 nm.
        let bromide = [0.452_505, 0.099_39, 0.070_537, -0.001_50];
        assert!((index(8, &bromide, 0.589) - 2.25).abs() < 0.03);
        // Urea, ordinary ray, by Rosker 1985 (formula 9): about 1.49 at 589 nm.
        let urea = [2.1823, 0.0125, 0.0300, 0.0, 0.0, 0.0];
        assert!((index(9, &urea, 0.589) - 1.49).abs() < 0.01);
    }

    #[test]
    fn formulas_of_one_meaning_agree() {
        let sellmeier = index(1, &[0.0, 1.0, 0.1], 0.5);
        assert_eq!(sellmeier, index(2, &[0.0, 1.0, 0.1_f64 * 0.1], 0.5));
        let cauchy = index(5, &[1.5, 0.004, -2.0], 0.5);
        let squared = index(3, &[cauchy * cauchy], 0.5);
        assert!((cauchy - 1.516).abs() < 1e-12 && (squared - cauchy).abs() < 1e-12);
        let fourth = index(
            4,
            &[2.25, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.01, -2.0],
            0.5,
        );
        assert!((fourth - index(3, &[2.25, 0.01, -2.0], 0.5)).abs() < 1e-12);
        assert_eq!(index(7, &[1.5], 0.5), 1.5);
        assert!(index(0, &[], 0.5).is_nan());
    }
}
