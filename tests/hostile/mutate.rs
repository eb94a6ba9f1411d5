//! Files changed in the ways in which they break, and in which somebody breaks them; the same in
//! every run.

/// Numbers that a reader should not believe.
const NUMBERS: [&str; 18] = [
    "NaN",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "1e-308",
    "5e-324",
    "1e999",
    "-1e999",
    "0",
    "-0",
    "-1",
    "999999999",
    "18446744073709551616",
    "9223372036854775807",
    "4294967295",
    "",
    "0.1.2",
];

/// Makes changed files.
pub(crate) struct Mutator {
    state: u64,
    words: &'static [&'static str],
}

impl Mutator {
    /// One that puts these words in.
    pub(crate) fn new(words: &'static [&'static str]) -> Self {
        Self {
            state: 0x9e37_79b9_7f4a_7c15,
            words,
        }
    }

    /// A number below a limit (xorshift).
    fn below(&mut self, limit: usize) -> usize {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        (self.state >> 16) as usize % limit.max(1)
    }

    /// One of some files, changed once to four times.
    pub(crate) fn mutate(&mut self, files: &[Vec<u8>]) -> Vec<u8> {
        let mut bytes = files[self.below(files.len())].clone();
        for _ in 0..=self.below(4) {
            self.change(&mut bytes, files);
        }
        bytes.truncate(1 << 16);
        bytes
    }

    fn change(&mut self, bytes: &mut Vec<u8>, files: &[Vec<u8>]) {
        let at = self.below(bytes.len() + 1);
        let past = (at + 1 + self.below(40)).min(bytes.len()).max(at);
        match self.below(13) {
            0 => bytes.truncate(at),
            1 => {
                for _ in 0..=self.below(4) {
                    let at = self.below(bytes.len());
                    let bit = 1 << self.below(8);
                    if let Some(byte) = bytes.get_mut(at) {
                        *byte ^= bit;
                    }
                }
            }
            2 => {
                let byte = self.below(256) as u8;
                if let Some(place) = bytes.get_mut(at) {
                    *place = byte;
                }
            }
            // The front of this file and the rear of another.
            3 => {
                let other = &files[self.below(files.len())];
                let from = self.below(other.len() + 1);
                bytes.truncate(at);
                bytes.extend_from_slice(&other[from..]);
            }
            4 => {
                let block = bytes[at..past].to_vec();
                let times = 1 + self.below(200);
                bytes.splice(past..past, block.repeat(times));
            }
            5 | 6 => self.swap_number(bytes),
            7 => {
                bytes.drain(at..past);
            }
            8 => {
                let lines: Vec<&[u8]> = bytes.split_inclusive(|b| *b == b'\n').collect();
                let gone = self.below(lines.len());
                let kept = lines.iter().enumerate().filter(|(i, _)| *i != gone);
                *bytes = kept.flat_map(|(_, line)| line.to_vec()).collect();
            }
            9 => {
                let odd: [&[u8]; 8] = [
                    b"\0",
                    b"\0\0\0\0",
                    b"\xff",
                    b"\xe2\x80\xae",
                    b"\r",
                    b"\x1a",
                    b"\xef\xbb\xbf",
                    b"\"",
                ];
                let odd = odd[self.below(odd.len())];
                bytes.splice(at..at, odd.iter().copied());
            }
            10 => {
                let end: &[u8] = [b"\r\n".as_slice(), b"\r", b"\n\n", b" "][self.below(4)];
                *bytes = bytes.split(|b| *b == b'\n').collect::<Vec<_>>().join(end);
            }
            11 => {
                let lines: Vec<&[u8]> = bytes.split_inclusive(|b| *b == b'\n').collect();
                let line = lines.get(self.below(lines.len()));
                let again = line.map_or_else(Vec::new, |line| line.to_vec());
                bytes.splice(at..at, again);
            }
            _ => {
                let word = self.words[self.below(self.words.len())].as_bytes();
                bytes.splice(at..at, word.iter().copied());
            }
        }
    }

    /// Another number in the place of one.
    fn swap_number(&mut self, bytes: &mut Vec<u8>) {
        let is_number = |b: &u8| b.is_ascii_digit() || *b == b'.';
        let starts: Vec<usize> = (0..bytes.len())
            .filter(|i| is_number(&bytes[*i]) && (*i == 0 || !is_number(&bytes[*i - 1])))
            .collect();
        if starts.is_empty() {
            return;
        }
        let start = starts[self.below(starts.len())];
        let length = bytes[start..].iter().take_while(|b| is_number(b)).count();
        let number = NUMBERS[self.below(NUMBERS.len())];
        bytes.splice(start..start + length, number.bytes());
    }
}
