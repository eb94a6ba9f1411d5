//! A small matrix times very many pixels, single precision.
//!
//! Pixels lie band after band. A tile of 64 pixels is copied together so that it stays in the
//! nearest cache; some rows of the matrix times some pixels stay in registers while the bands run.
//! Every pixel is worked out in the same order of operations wherever it lies in the picture, so
//! the answer does not depend on threads or strips. Wider registers are used where the processor
//! has them.

/// Pixels that are worked on together.
const TILE: usize = 64;

/// A matrix ready to be applied to many pixels.
#[derive(Clone, Debug)]
pub struct Kernel {
    rows: usize,
    columns: usize,
    /// Rows of one block.
    block: usize,
    /// `[block of rows][column][row in block]`, padded with zeros.
    packed: Vec<f32>,
    wide: Width,
}

/// Vector width that the processor offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Width {
    Plain,
    #[cfg(target_arch = "x86_64")]
    Fused256,
    #[cfg(target_arch = "x86_64")]
    Fused512,
}

impl Width {
    fn of_this_processor() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx512f") {
                return Self::Fused512;
            }
            if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
                return Self::Fused256;
            }
        }
        Self::Plain
    }

    /// Rows that fit into the registers beside the pixels.
    fn blocks(self) -> &'static [usize] {
        match self {
            Self::Plain => &[4],
            #[cfg(target_arch = "x86_64")]
            Self::Fused256 => &[6, 5, 4],
            #[cfg(target_arch = "x86_64")]
            Self::Fused512 => &[12, 11, 10, 8],
        }
    }
}

impl Kernel {
    /// A matrix of `rows` x `columns`, entry by entry.
    pub(crate) fn new(rows: usize, columns: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let wide = Width::of_this_processor();
        let padded = |block: &usize| rows.div_ceil(*block) * block;
        let blocks = wide.blocks().iter();
        let block = blocks.copied().min_by_key(padded).unwrap_or(4);
        let mut packed = vec![0.0; padded(&block) * columns];
        for row in 0..rows {
            for column in 0..columns {
                let at = (row / block * columns + column) * block + row % block;
                packed[at] = entry(row, column) as f32;
            }
        }
        Self {
            rows,
            columns,
            block,
            packed,
            wide,
        }
    }

    /// Three weighted sums.
    pub(crate) fn of_rows(rows: &[&[f64]]) -> Self {
        let columns = rows.first().map_or(0, |row| row.len());
        Self::new(rows.len(), columns, |r, c| {
            rows[r].get(c).copied().unwrap_or(0.0)
        })
    }

    /// Rows, numbers that come out for each pixel.
    pub(crate) fn rows(&self) -> usize {
        self.rows
    }

    /// The matrix times `count` pixels: `out[row * count + i]` from `input[column * count + i]`.
    /// A NaN in a pixel makes all of its numbers NaN.
    ///
    /// # Panics
    /// When a slice is shorter than that.
    pub fn apply(&self, input: &[f32], count: usize, out: &mut [f32]) {
        assert!(input.len() >= self.columns * count && out.len() >= self.rows * count);
        let mut tile = vec![0.0; self.columns * TILE];
        for start in (0..count).step_by(TILE) {
            let width = TILE.min(count - start);
            for (column, into) in tile.chunks_exact_mut(TILE).enumerate() {
                into[..width].copy_from_slice(&input[column * count + start..][..width]);
            }
            self.tile(&tile, &mut |row, values| {
                out[row * count + start..][..width].copy_from_slice(&values[..width]);
            });
        }
    }

    /// One tile; `tell` hears of every row's values.
    fn tile(&self, tile: &[f32], tell: &mut dyn FnMut(usize, &[f32; TILE])) {
        let mut values = [[0.0; TILE]; 12];
        for (index, packed) in self
            .packed
            .chunks_exact(self.columns * self.block)
            .enumerate()
        {
            self.block(tile, packed, &mut values);
            let first = index * self.block;
            for (row, values) in (first..self.rows.min(first + self.block)).zip(&values) {
                tell(row, values);
            }
        }
    }

    fn block(&self, tile: &[f32], packed: &[f32], out: &mut [[f32; TILE]; 12]) {
        match self.wide {
            Width::Plain => block::<4, 8, false>(tile, packed, out),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the features were found on this processor when the kernel was made.
            Width::Fused256 => unsafe {
                match self.block {
                    6 => block_256::<6>(tile, packed, out),
                    5 => block_256::<5>(tile, packed, out),
                    _ => block_256::<4>(tile, packed, out),
                }
            },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: as above.
            Width::Fused512 => unsafe {
                match self.block {
                    12 => block_512::<12>(tile, packed, out),
                    11 => block_512::<11>(tile, packed, out),
                    10 => block_512::<10>(tile, packed, out),
                    _ => block_512::<8>(tile, packed, out),
                }
            },
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn block_256<const ROWS: usize>(tile: &[f32], packed: &[f32], out: &mut [[f32; TILE]; 12]) {
    block::<ROWS, 16, true>(tile, packed, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx2,fma")]
fn block_512<const ROWS: usize>(tile: &[f32], packed: &[f32], out: &mut [[f32; TILE]; 12]) {
    block::<ROWS, 32, true>(tile, packed, out);
}

/// Some rows times a tile, so many pixels at a time that the sums stay in registers.
#[inline(always)]
fn block<const ROWS: usize, const LANES: usize, const FUSED: bool>(
    tile: &[f32],
    packed: &[f32],
    out: &mut [[f32; TILE]; 12],
) {
    for start in (0..TILE).step_by(LANES) {
        let mut sums = [[0.0_f32; LANES]; ROWS];
        for (pixels, weights) in tile.chunks_exact(TILE).zip(packed.chunks_exact(ROWS)) {
            let mut values = [0.0_f32; LANES];
            values.copy_from_slice(&pixels[start..start + LANES]);
            for row in 0..ROWS {
                let weight = weights[row];
                for lane in 0..LANES {
                    sums[row][lane] = if FUSED {
                        values[lane].mul_add(weight, sums[row][lane])
                    } else {
                        values[lane] * weight + sums[row][lane]
                    };
                }
            }
        }
        for (row, sums) in sums.iter().enumerate() {
            out[row][start..start + LANES].copy_from_slice(sums);
        }
    }
}
