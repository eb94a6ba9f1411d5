//! Single and double precision for one tracer.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number that rays are traced with.
pub(super) trait Real:
    Copy
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    const ZERO: Self;
    const ONE: Self;
    const HALF: Self;
    /// So small that a way of it is none, and still not 0 when divided by.
    const TINY: Self;
    /// Farther than anything is.
    const FAR: Self;

    /// The nearest to a double.
    fn of(value: f64) -> Self;
    fn double(self) -> f64;
    fn root(self) -> Self;
    fn exponential(self) -> Self;
    /// Without sign.
    fn size(self) -> Self;

    /// The larger of two, of which neither is NaN.
    #[inline(always)]
    fn above(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    /// The smaller of two, of which neither is NaN.
    #[inline(always)]
    fn below(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
}

macro_rules! real {
    ($number:ty, $tiny:expr) => {
        impl Real for $number {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const HALF: Self = 0.5;
            const TINY: Self = $tiny;
            const FAR: Self = 1e30;

            #[inline(always)]
            fn of(value: f64) -> Self {
                value as Self
            }

            #[inline(always)]
            fn double(self) -> f64 {
                f64::from(self)
            }

            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }

            #[inline(always)]
            fn exponential(self) -> Self {
                self.exp()
            }

            #[inline(always)]
            fn size(self) -> Self {
                self.abs()
            }
        }
    };
}

real!(f32, 1e-12);
real!(f64, 1e-20);
