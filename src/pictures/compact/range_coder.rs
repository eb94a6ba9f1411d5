//! A binary range coder with adaptive probabilities of 12 bits, integers only.

/// Bits of a probability.
const BITS: u32 = 12;
/// Shift that sets how slowly a probability adapts.
const SHIFT: u32 = 5;
/// Below this the range is shifted by a byte.
const TOP: u32 = 1 << 24;

/// Probability of a 0, in 4096ths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chance(u16);

impl Default for Chance {
    fn default() -> Self {
        Self(1 << (BITS - 1))
    }
}

impl Chance {
    fn learn(&mut self, bit: bool) {
        if bit {
            self.0 -= self.0 >> SHIFT;
        } else {
            self.0 += ((1 << BITS) - self.0) >> SHIFT;
        }
    }
}

/// Bits to bytes.
#[derive(Debug)]
pub(super) struct Encoder {
    low: u64,
    range: u32,
    /// The last byte that a carry may still change, and how many 255 follow it.
    held: u8,
    waiting: u64,
    bytes: Vec<u8>,
    is_first: bool,
}

impl Default for Encoder {
    fn default() -> Self {
        Self {
            low: 0,
            range: u32::MAX,
            held: 0,
            waiting: 0,
            bytes: Vec::new(),
            is_first: true,
        }
    }
}

impl Encoder {
    pub(super) fn bit(&mut self, chance: &mut Chance, bit: bool) {
        let bound = (self.range >> BITS) * u32::from(chance.0);
        if bit {
            self.low += u64::from(bound);
            self.range -= bound;
        } else {
            self.range = bound;
        }
        chance.learn(bit);
        while self.range < TOP {
            self.range <<= 8;
            self.shift();
        }
    }

    fn shift(&mut self) {
        let carry = (self.low >> 32) as u8;
        if self.low < 0xff00_0000 || carry > 0 {
            if !self.is_first {
                self.bytes.push(self.held.wrapping_add(carry));
            }
            self.is_first = false;
            for _ in 0..self.waiting {
                self.bytes.push(0xff_u8.wrapping_add(carry));
            }
            self.waiting = 0;
            self.held = (self.low >> 24) as u8;
        } else {
            self.waiting += 1;
        }
        self.low = (self.low << 8) & 0xffff_ffff;
    }

    /// The bytes of all bits.
    pub(super) fn finish(mut self) -> Vec<u8> {
        for _ in 0..5 {
            self.shift();
        }
        // A reader takes zeros beyond the end.
        while self.bytes.last() == Some(&0) {
            self.bytes.pop();
        }
        self.bytes
    }
}

/// Bytes to bits; beyond the end there are zeros.
#[derive(Debug)]
pub(super) struct Decoder<'a> {
    code: u32,
    range: u32,
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Decoder<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let mut decoder = Self {
            code: 0,
            range: u32::MAX,
            bytes,
            at: 0,
        };
        for _ in 0..4 {
            decoder.code = (decoder.code << 8) | decoder.byte();
        }
        decoder
    }

    fn byte(&mut self) -> u32 {
        let byte = self.bytes.get(self.at).copied().unwrap_or(0);
        self.at += 1;
        u32::from(byte)
    }

    /// True if more was read than there is: the bytes were cut off.
    pub(super) fn is_beyond_end(&self) -> bool {
        self.at > self.bytes.len() + 16
    }

    pub(super) fn bit(&mut self, chance: &mut Chance) -> bool {
        let bound = (self.range >> BITS) * u32::from(chance.0);
        let bit = self.code >= bound;
        if bit {
            self.code -= bound;
            self.range -= bound;
        } else {
            self.range = bound;
        }
        chance.learn(bit);
        while self.range < TOP {
            self.range <<= 8;
            self.code = (self.code << 8) | self.byte();
        }
        bit
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn bits_come_back_whatever_their_chances(bits in proptest::collection::vec((0_usize..5, any::<bool>()), 0..3000)) {
            let mut encoder = Encoder::default();
            let mut chances = [Chance::default(); 5];
            bits.iter().for_each(|(which, bit)| encoder.bit(&mut chances[*which], *bit));
            let bytes = encoder.finish();
            let mut decoder = Decoder::new(&bytes);
            let mut chances = [Chance::default(); 5];
            for (which, bit) in bits {
                prop_assert_eq!(decoder.bit(&mut chances[which]), bit);
            }
        }
    }

    #[test]
    fn what_is_nearly_certain_costs_nearly_nothing() {
        let mut encoder = Encoder::default();
        let mut chance = Chance::default();
        (0..100_000).for_each(|_| encoder.bit(&mut chance, false));
        let bytes = encoder.finish();
        // A probability of 12 bits is at most 4065/4096 (shift 5): 0.011 bits, 137 bytes here.
        assert!(bytes.len() < 150, "{}", bytes.len());
        let mut encoder = Encoder::default();
        let mut chance = Chance::default();
        (0..100_000).for_each(|_| encoder.bit(&mut chance, true));
        let bytes = encoder.finish();
        let mut decoder = Decoder::new(&bytes);
        let mut chance = Chance::default();
        assert!((0..100_000).all(|_| decoder.bit(&mut chance)));
    }
}
