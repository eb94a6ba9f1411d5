//! Positions of a picture's points in a pixel and in a stratum of wavelengths.
//!
//! Points run along the additive sequences R2 and R3, whose steps are powers of the generalised
//! golden ratio (M. Roberts, 2018), each pixel and plane with a shift of its own. Sums are of whole
//! numbers modulo 2^32, so that they are the same everywhere.

/// Steps of the sequence in two dimensions: 2^32 / p and 2^32 / p^2 with p^3 = p + 1.
const R2: [u32; 2] = [3_242_174_889, 2_447_445_414];

/// Steps in three: 2^32 / q, / q^2, / q^3 with q^4 = q + 1.
const R3: [u32; 3] = [3_518_319_155, 2_882_110_345, 2_360_945_575];

/// A number that looks random and depends on every bit of two others.
pub(super) fn mixed(a: u64, b: u64) -> u64 {
    // The finaliser of splitmix64 (Steele, Lea, Flood 2014) over a sum of odd multiples.
    let mut x = a
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(b.wrapping_mul(0xd1b5_4a32_d192_ed03))
        .wrapping_add(0x2545_f491_4f6c_dd1d);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// A whole number as a share of 2^32, never 1.
pub(super) fn share(x: u32) -> f64 {
    f64::from(x) * (1.0 / 4_294_967_296.0)
}

/// Point of a sequence in the plane, shifted by a key.
pub(super) fn point_2(key: u64, index: u32) -> [f64; 2] {
    let shift = [key as u32, (key >> 32) as u32];
    std::array::from_fn(|k| share(shift[k].wrapping_add(index.wrapping_mul(R2[k]))))
}

/// Point of a sequence in space, shifted by a key.
pub(super) fn point_3(key: u64, index: u32) -> [f64; 3] {
    let more = mixed(key, 1);
    let shift = [key as u32, (key >> 32) as u32, more as u32];
    std::array::from_fn(|k| share(shift[k].wrapping_add(index.wrapping_mul(R3[k]))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_powers_of_the_generalised_golden_ratio() {
        let root = |power: i32| {
            let mut x = 1.5_f64;
            for _ in 0..200 {
                x = (1.0 + x).powf(1.0 / f64::from(power));
            }
            x
        };
        let (p, q) = (root(3), root(4));
        for (k, step) in R2.iter().enumerate() {
            assert_eq!(
                *step,
                (4_294_967_296.0 / p.powi(k as i32 + 1)).round() as u32
            );
        }
        for (k, step) in R3.iter().enumerate() {
            assert_eq!(
                *step,
                (4_294_967_296.0 / q.powi(k as i32 + 1)).round() as u32
            );
        }
    }

    #[test]
    fn points_fill_the_square_evenly() {
        for key in [0, 7, u64::MAX] {
            let mut cells = [0; 64];
            for index in 0..640 {
                let [x, y] = point_2(mixed(key, 3), index);
                cells[(8.0 * x) as usize * 8 + (8.0 * y) as usize] += 1;
            }
            // Ten each; random points would give 2 to 20.
            assert!(cells.iter().all(|c| (7..=13).contains(c)), "{cells:?}");
        }
    }
}
