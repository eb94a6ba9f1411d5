//! The cell delimiter and decimal mark of a text table.

use super::number;

/// Most columns of one table: far more than any instrument writes.
pub const MOST_COLUMNS: usize = 65_536;

/// The separator between two cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// One TAB.
    Tab,
    /// One semicolon.
    Semicolon,
    /// One comma.
    Comma,
    /// Any run of blanks and TABs.
    Space,
    /// The edge of a sheet's cell: a TAB, and no other mark has a meaning.
    Cell,
}

impl Delimiter {
    /// Every one that a text may be written with.
    pub const ALL: [Self; 4] = [Self::Tab, Self::Semicolon, Self::Comma, Self::Space];

    /// In a word: `tab`, `semicolon`, `comma`, `space`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Tab => "tab",
            Self::Semicolon => "semicolon",
            Self::Comma => "comma",
            Self::Space => "space",
            Self::Cell => "cell",
        }
    }
}

/// A delimiter and a decimal mark, found together because either alone misleads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dialect {
    /// The separator between two cells.
    pub delimiter: Delimiter,
    /// True if decimals are marked by a comma instead of a point.
    pub decimal_comma: bool,
}

impl Dialect {
    /// Every dialect that is tried; of equally good ones the earlier is taken. A comma between
    /// cells and in numbers at once works where cells are quoted.
    pub const ALL: [Self; 8] = [
        Self::new(Delimiter::Tab, false),
        Self::new(Delimiter::Semicolon, false),
        Self::new(Delimiter::Comma, false),
        Self::new(Delimiter::Space, false),
        Self::new(Delimiter::Tab, true),
        Self::new(Delimiter::Semicolon, true),
        Self::new(Delimiter::Space, true),
        Self::new(Delimiter::Comma, true),
    ];

    /// The dialect in which the rows of a workbook's sheet are passed on.
    pub(crate) const SHEET: Self = Self::new(Delimiter::Cell, false);

    /// A dialect of these two.
    pub(crate) const fn new(delimiter: Delimiter, decimal_comma: bool) -> Self {
        Self {
            delimiter,
            decimal_comma,
        }
    }

    /// The dialect in words, for provenance.
    pub fn words(self) -> String {
        let cells = match self.delimiter {
            Delimiter::Tab => said!("cells separated by TAB"),
            Delimiter::Semicolon => said!("cells separated by semicolon"),
            Delimiter::Comma => said!("cells separated by comma"),
            Delimiter::Space => said!("cells separated by blanks"),
            Delimiter::Cell => said!("cells of a sheet"),
        };
        match self.decimal_comma {
            true => tr!("{cells}, decimal comma", cells),
            false => cells.to_owned(),
        }
    }

    /// The cells of a line, trimmed; quotes around a cell are honoured and removed. One cell more
    /// than [`MOST_COLUMNS`] at most: it tells that there are too many, and a line of nothing but
    /// marks takes no more memory than that.
    pub fn split<'a>(self, line: &'a str, cells: &mut Vec<&'a str>) {
        const MOST_CELLS: usize = MOST_COLUMNS + 1;
        cells.clear();
        if self.delimiter == Delimiter::Cell {
            cells.extend(line.split('\t').map(str::trim_ascii).take(MOST_CELLS));
            return;
        }
        let list = list_behind_key(line);
        let line = list.map_or(line, |(_, list)| list);
        cells.extend(list.map(|(key, _)| key));
        let Some(mark) = self.mark() else {
            let words = line.split_ascii_whitespace();
            if line.is_ascii() {
                cells.extend(words.take(MOST_CELLS));
            } else {
                let parts = words.flat_map(|word| self.split_at_fixed_blanks(word));
                cells.extend(parts.take(MOST_CELLS));
            }
            return;
        };
        if !line.contains('"') {
            let all = line.split(char::from(mark)).map(str::trim_ascii);
            cells.extend(all.take(MOST_CELLS));
            return;
        }
        let mut in_quotes = false;
        let parts = |c: char| {
            in_quotes ^= c == '"';
            c == char::from(mark) && !in_quotes
        };
        cells.extend(line.split(parts).map(unquoted).take(MOST_CELLS));
    }

    /// The same in a list of their own.
    pub(crate) fn cells(self, line: &str) -> Vec<&str> {
        let mut cells = Vec::new();
        self.split(line, &mut cells);
        cells
    }

    /// The cells of a word that blanks stand in which break no line; between the thousands of a
    /// number they part nothing.
    fn split_at_fixed_blanks(self, word: &str) -> impl Iterator<Item = &str> {
        let is_one = || {
            word.contains(['.', ',']) && number::parse(word, self.decimal_comma).value().is_some()
        };
        let parts = !word.contains(FIXED_BLANKS) || is_one();
        let is_mark = move |c: char| !parts && FIXED_BLANKS.contains(&c);
        word.split(is_mark).filter(|part| !part.is_empty())
    }

    /// True if a line may have more than one cell, by a quick check.
    pub fn parts(self, line: &str) -> bool {
        let found = match self.mark() {
            Some(mark) => memchr::memchr(mark, line.as_bytes()),
            None => memchr::memchr3(b' ', b'\t', b'\x0c', line.as_bytes()),
        };
        let is_fixed = || self.mark().is_none() && line.contains(FIXED_BLANKS);
        found.is_some() || !line.is_ascii() && is_fixed()
    }

    /// The number of cells in a line, without an upper limit.
    pub fn count(self, line: &str) -> usize {
        let Some(mark) = self.mark() else {
            return line.split_ascii_whitespace().count();
        };
        let mut in_quotes = false;
        let marks = line.bytes().filter(|byte| {
            in_quotes ^= *byte == b'"';
            *byte == mark && (!in_quotes || self.delimiter == Delimiter::Cell)
        });
        1 + marks.count()
    }

    /// The byte between two cells; `None` for blanks and TABs in any number.
    pub(crate) fn mark(self) -> Option<u8> {
        match self.delimiter {
            Delimiter::Tab | Delimiter::Cell => Some(b'\t'),
            Delimiter::Semicolon => Some(b';'),
            Delimiter::Comma => Some(b','),
            Delimiter::Space => None,
        }
    }
}

const FIXED_BLANKS: [char; 2] = ['\u{a0}', '\u{202f}'];

/// Fewest numbers in brackets that are a row.
const FEWEST_IN_A_LIST: usize = 5;

/// The key and the list of a line such as `wavelengths: [380, 385, 390]` or `x = [380 385 390];`.
fn list_behind_key(line: &str) -> Option<(&str, &str)> {
    let open = memchr::memchr(b'[', line.as_bytes())?;
    let body = line.trim_end().trim_end_matches([';', ',']).trim_end();
    let list = body.strip_suffix(']')?.get(open + 1..)?;
    let key = line[..open].trim().strip_suffix([':', '='])?.trim();
    let parts = list.split([',', ';', ' ', '\t']);
    let filled = parts.filter(|part| !part.is_empty());
    let is_list = filled.take(FEWEST_IN_A_LIST).count() == FEWEST_IN_A_LIST;
    let has_key = key.contains(char::is_alphabetic);
    (is_list && has_key && !list.contains(['[', ']'])).then_some((key, list))
}

fn unquoted(cell: &str) -> &str {
    let cell = cell.trim_ascii();
    cell.strip_prefix('"')
        .and_then(|c| c.strip_suffix('"'))
        .map_or(cell, str::trim_ascii)
}

/// Length without the empty cells at the end of a line.
pub fn used(cells: &[&str]) -> usize {
    cells
        .iter()
        .rposition(|c| !c.is_empty())
        .map_or(0, |i| i + 1)
}
