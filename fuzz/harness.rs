//! What must hold whatever a file holds: one harness for the fuzz target and for `tests/hostile`.
//!
//! [`attack`] hands bytes to one reader, directly and through the sniffers, as they are and with a
//! person's choices, and panics when a promise is broken: an answer in time and within memory, a
//! refusal of one line that says what was expected, and nothing but finite numbers in a spectrum.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::fmt::Debug;
use std::hint::black_box;
use std::time::Duration;

use spectral_explorer::io::WavelengthUnit;
use spectral_explorer::io::{
    ABSURD, Choices, Counted, Dialect, FORMATS, Format, Input, ReadError, Reading, csv, read_bytes,
    read_bytes_as, read_path,
};
use spectral_explorer::io::{Columns, Provenance};
use spectral_explorer::spectrum::{Composite, Kind, NamedSpectrum, Rect, SpectralImage};
use zip::CompressionMethod;

#[path = "../tests/common/containers.rs"]
mod containers;
pub(crate) use containers::{workbook, zipped};

/// Memory that any file may take, in bytes.
const MEMORY_FLOOR: usize = 512 << 20;
/// Memory that each byte of a file may take where that is more, in bytes.
const MEMORY_TIMES: usize = 20;
/// Time that any file may take: what starting costs, and the ticks in which time is counted.
const TIME_FLOOR: Duration = Duration::from_millis(250);
/// Time for each MiB; ten times the promise where the program is not optimised.
const TIME_PER_MIB: Duration = Duration::from_secs(if cfg!(debug_assertions) { 10 } else { 1 });
/// A slow answer is asked for again so often before it counts: the machine may have been busy.
const PATIENCE: usize = 3;

/// What parts the first file of a pair from the one beside it.
pub(crate) const BESIDE: &[u8] = b"\n=== BESIDE ===\n";
/// Readers that look for a second file: the names that the first and the second get.
const PAIRS: [(&str, &str, &str); 2] = [
    ("ENVI", "a.hdr", "a.sli"),
    (
        "USGS splib07",
        "splib07a_Alunite_BECKa_AREF.txt",
        "splib07a_Wavelengths_BECK_3_ch.txt",
    ),
];

/// Longest spectrum that is written and read back, in points.
const LONGEST_WRITTEN: usize = 2000;
/// Most spectra of a file that are looked at closely.
const MOST_WRITTEN: usize = 3;
/// Largest image whose whole planes are asked for, in pixels.
const LARGEST_PLANE: usize = 1 << 16;

/// Counts what this thread holds.
struct Counting;

thread_local! {
    static HELD: Cell<usize> = const { Cell::new(0) };
    static PEAK: Cell<usize> = const { Cell::new(0) };
}

fn hold(bytes: usize) {
    // The thread may be past its end.
    let _ = HELD.try_with(|held| {
        held.set(held.get().wrapping_add(bytes));
        let _ = PEAK.try_with(|peak| {
            // What another thread made and this one drops takes the count below zero.
            if (held.get().wrapping_sub(peak.get())).cast_signed() > 0 {
                peak.set(held.get());
            }
        });
    });
}

fn drop_held(bytes: usize) {
    let _ = HELD.try_with(|held| held.set(held.get().wrapping_sub(bytes)));
}

// SAFETY: everything is the system's allocator; counting allocates nothing.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        hold(layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        hold(layout.size());
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        drop_held(layout.size());
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        drop_held(layout.size());
        hold(size);
        unsafe { System.realloc(place, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// What one reader made of one file.
type Answer = Result<Reading, ReadError>;

/// The format of a name in [`FORMATS`].
fn format_of(name: &str) -> &'static Format {
    let found = FORMATS.iter().find(|format| format.name == name);
    found.unwrap_or_else(|| panic!("no format is called {name:?}"))
}

/// What the fuzzer's bytes say: the first one chooses a reader by its place in [`FORMATS`], the
/// others are its file. `None` without a byte.
pub(crate) fn reader_and_file(bytes: &[u8]) -> Option<(&'static str, &[u8])> {
    let (first, file) = bytes.split_first()?;
    Some((FORMATS[usize::from(*first) % FORMATS.len()].name, file))
}

/// What is no archive put into one, for readers of archives: checksums keep changed bytes of a
/// packed member from ever being read.
fn dressed(name: &str, bytes: &[u8]) -> Option<Vec<u8>> {
    if bytes.starts_with(b"PK") {
        return None;
    }
    let one = |member| zipped(&[(member, bytes)], CompressionMethod::Stored);
    match name {
        "GDTF" => Some(one("description.xml")),
        "Ocean Optics ProcSpec" => Some(one("ps_0.xml")),
        "Excel workbook" => {
            let (sheet, texts) = halves(bytes).unwrap_or((bytes, b""));
            Some(workbook(sheet, texts, CompressionMethod::Stored))
        }
        _ => None,
    }
}

/// What stands before and behind [`BESIDE`].
fn halves(bytes: &[u8]) -> Option<(&[u8], &[u8])> {
    let cut = bytes.windows(BESIDE.len()).position(|w| w == BESIDE)?;
    Some((&bytes[..cut], &bytes[cut + BESIDE.len()..]))
}

/// Hands bytes to the reader of a name, which is one of [`FORMATS`].
///
/// # Panics
/// When a promise is broken.
pub(crate) fn attack(name: &str, bytes: &[u8]) {
    if let Some(archive) = dressed(name, bytes) {
        return attack(name, &archive);
    }
    let format = format_of(name);
    let file = format!("a.{}", format.extensions.first().unwrap_or(&"txt"));
    let direct = || {
        let input = Input::new(&file, bytes);
        // What a sniffer says does not matter here, but it may not panic either.
        black_box((format.sniff)(&input));
        (format.read)(&input)
    };
    // An empty file never gets to a reader.
    if !bytes.is_empty() {
        judge(&file, &in_bounds(bytes.len(), direct), false);
    }
    judge(
        &file,
        &in_bounds(bytes.len(), || read_bytes(&file, bytes)),
        true,
    );
    let choices = choices_of(bytes);
    let chosen = in_bounds(bytes.len(), || read_bytes_as(&file, bytes, &choices));
    judge(&file, &chosen, true);
    for (_, first, second) in PAIRS.iter().filter(|pair| pair.0 == name) {
        attack_pair(first, second, bytes);
    }
}

/// Whether a file is taken for one of a format by its content, and read. One of the format that is
/// not read is refused.
#[allow(dead_code, reason = "the fuzz target does not ask")]
pub(crate) fn opens_as(name: &str, bytes: &[u8]) -> bool {
    let format = format_of(name);
    if let Some(archive) = dressed(name, bytes) {
        return opens_as(name, &archive);
    }
    let first = halves(bytes).map_or(bytes, |(first, _)| first);
    let file = format!("a.{}", format.extensions.first().unwrap_or(&"txt"));
    match read_bytes(&file, first) {
        Ok(reading) => reading.format == name,
        // What needs a file beside it says so.
        Err(why) => {
            name == "a format that is not read"
                || why.expected.contains("beside")
                || why.expected.contains("same folder")
        }
    }
}

/// Puts two files beside one another and reads each.
fn attack_pair(first: &str, second: &str, bytes: &[u8]) {
    thread_local! {
        static FOLDER: tempfile::TempDir = tempfile::tempdir().expect("a folder");
    }
    let Some((one, other)) = halves(bytes) else {
        return;
    };
    FOLDER.with(|folder| {
        for (name, bytes) in [(first, one), (second, other)] {
            std::fs::write(folder.path().join(name), bytes).expect("room for a file");
        }
        for name in [first, second] {
            let path = folder.path().join(name);
            let answer = in_bounds(bytes.len(), || read_path(&path));
            // A refusal may name either of the two.
            match &answer {
                Err(why) if why.file == second => judge(second, &answer, true),
                Err(why) if why.file == first => judge(first, &answer, true),
                _ => judge(name, &answer, true),
            }
        }
    });
}

/// Decisions of a person who decides by the file's bytes.
fn choices_of(bytes: &[u8]) -> Choices {
    let sum = bytes.iter().fold(bytes.len(), |sum, byte| {
        sum.wrapping_mul(31).wrapping_add(usize::from(*byte))
    });
    // The sum in a base of its own for every decision; the last digit is "the reader decides".
    let mut rest = sum;
    let mut one_of = |count: usize| {
        let digit = rest % (count + 1);
        rest /= count + 1;
        (digit < count).then_some(digit)
    };
    Choices {
        dialect: one_of(Dialect::ALL.len()).map(|i| Dialect::ALL[i]),
        axis_column: one_of(4),
        wavelengths: one_of(WavelengthUnit::ALL.len()).map(|i| WavelengthUnit::ALL[i]),
        kind: one_of(Kind::ALL.len()).map(|i| Kind::ALL[i]),
        counted: one_of(3).map(|i| Counted::OFFERED[i]),
        ..Choices::default()
    }
}

/// Reads and sees that it took no more time and memory than a file of some bytes may take.
fn in_bounds(bytes: usize, read: impl Fn() -> Answer) -> Answer {
    let memory = MEMORY_FLOOR.max(MEMORY_TIMES * bytes);
    within(memory, TIME_FLOOR + time_of(bytes), read)
}

/// Time that the bytes of a file may take, besides what any file may.
pub(crate) fn time_of(bytes: usize) -> Duration {
    TIME_PER_MIB.mul_f64(bytes as f64 / f64::from(1 << 20))
}

/// Carries out what takes no more than so much memory and time.
///
/// # Panics
/// When it takes more.
pub(crate) fn within<T>(memory: usize, time: Duration, read: impl Fn() -> T) -> T {
    let mut slow = 0;
    loop {
        let before = HELD.get();
        PEAK.set(before);
        let start = computed();
        let answer = read();
        let took = computed().saturating_sub(start);
        let peak = PEAK.get().wrapping_sub(before);
        assert!(
            peak <= memory,
            "{peak} bytes of memory where {memory} are allowed"
        );
        if took <= time {
            return answer;
        }
        slow += 1;
        assert!(slow < PATIENCE, "{took:?} where {time:?} are allowed");
    }
}

/// How long this thread has been at work, without what the machine did besides.
#[cfg(unix)]
fn computed() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::try_from(time).expect("a clock that counts up from zero")
}

/// The time that went by: this system does not tell a thread's own.
#[cfg(not(unix))]
fn computed() -> Duration {
    static BEGIN: std::sync::LazyLock<std::time::Instant> =
        std::sync::LazyLock::new(std::time::Instant::now);
    BEGIN.elapsed()
}

fn is_line(text: &str) -> bool {
    !text.is_empty() && !text.contains(char::is_control)
}

/// Sees that an answer is one that a person can use. What [`read_bytes`] does for every format is
/// looked at where the answer is `whole`.
fn judge(file: &str, answer: &Answer, whole: bool) {
    let reading = match answer {
        Ok(reading) => reading,
        Err(why) => {
            let said = why.to_string();
            assert!(
                said.starts_with(file),
                "{said:?} does not start with {file}"
            );
            assert!(said.contains(", expected "), "{said:?}");
            assert!(is_line(&said), "{said:?} is not one line");
            assert!(said.chars().count() < 1000, "{said:?} is long");
            assert!(
                !why.found.is_empty() && !why.expected.is_empty(),
                "{said:?}"
            );
            return;
        }
    };
    let Reading {
        file: _,
        format: _,
        spectra,
        composites,
        table: _,
        cut_by: _,
        understood,
        images_understood,
        results,
        images,
        guesses,
        facts: _,
        in_front: _,
        notes,
    } = reading;
    assert!(understood.len() <= spectra.len(), "{understood:?}");
    // It is written down behind the reader.
    if whole {
        assert_eq!(images_understood.len(), images.len());
    }
    assert!(
        !spectra.is_empty() || !composites.is_empty() || !images.is_empty(),
        "read, and nothing in it"
    );
    for guess in guesses {
        let about = spectra.len() + composites.len();
        assert!(guess.spectrum < about, "{guess:?}");
        assert!(
            is_line(&guess.chosen) && is_line(&guess.because),
            "{guess:?}"
        );
    }
    for result in results {
        assert!(result.value.is_finite(), "{result:?}");
        assert!(
            result.spectrum.is_none_or(|i| i < spectra.len()),
            "{result:?}"
        );
    }
    for composite in composites {
        finite(&composite.composite);
    }
    for spectrum in spectra {
        sound(spectrum, whole);
    }
    for image in images {
        look_about(image, whole);
    }
    if whole {
        lines(notes);
        for result in results {
            assert!(is_line(&result.as_written), "{result:?}");
        }
        for composite in composites {
            assert!(is_line(&composite.name), "{composite:?}");
        }
        for spectrum in spectra.iter().take(MOST_WRITTEN) {
            comes_back(spectrum);
        }
    }
}

fn lines(notes: &[String]) {
    for note in notes {
        assert!(is_line(note), "{note:?} is not one line");
    }
}

fn all_finite(values: &[f64], what: impl Debug) {
    let odd = values.iter().find(|v| !v.is_finite());
    assert!(odd.is_none(), "{odd:?} in {what:?}");
}

fn sound(spectrum: &NamedSpectrum, whole: bool) {
    let NamedSpectrum {
        name,
        kind: _,
        unit,
        scale,
        samples,
        notes,
        source,
    } = spectrum;
    assert!(samples.len() >= 2, "{name}: {} points", samples.len());
    all_finite(samples.nm(), name);
    all_finite(samples.values(), name);
    let rising = samples.nm().windows(2).all(|w| w[0] < w[1]);
    assert!(rising, "{name}: wavelengths that do not rise");
    assert!(scale.is_finite() && *scale > 0.0, "{name}: scale {scale}");
    assert!(samples.step_nm() > 0.0, "{name}: {}", samples.step_nm());
    if whole {
        assert!(is_line(name) && !name.trim().is_empty(), "name {name:?}");
        assert!(unit.is_empty() || is_line(unit), "unit {unit:?}");
        assert!(source.is_empty() || is_line(source), "source {source:?}");
        lines(notes);
    }
}

fn finite(composite: &Composite) {
    all_finite(&composite.smooth().coefficients, "coefficients");
    for spike in composite.lines() {
        all_finite(&[spike.at_nm, spike.weight], spike);
    }
    black_box(composite.on_band());
}

/// Asks an image for everything that a view may ask for, also beyond its borders.
fn look_about(image: &SpectralImage, whole: bool) {
    let cube = &image.cube;
    let (width, height, bands) = (cube.width(), cube.height(), cube.nm().len());
    assert!(width > 0 && height > 0 && bands >= 2);
    assert!(image.scale.is_finite() && image.scale > 0.0);
    all_finite(cube.nm(), &image.name);
    let probes = [0, 1, width / 2, width - 1, width, usize::MAX];
    for x in probes {
        for y in [0, height / 2, height - 1, height, usize::MAX] {
            black_box(cube.value(x, y, bands - 1));
            if let Some(spectrum) = image.pixel(x, y) {
                sound(&spectrum, whole);
            }
        }
    }
    black_box(cube.value(0, 0, usize::MAX));
    assert!(cube.nearest_band(f64::NAN) < bands && cube.nearest_band(550.0) < bands);
    for spectrum in image.probes() {
        sound(&spectrum, whole);
    }
    let beyond = Rect {
        x: width - 1,
        y: height - 1,
        width: usize::MAX,
        height: usize::MAX,
    };
    if let Some(spectrum) = image.mean_of(beyond) {
        sound(&spectrum, whole);
    }
    if width.saturating_mul(height) <= LARGEST_PLANE {
        assert_eq!(cube.plane(bands - 1).len(), width * height);
        if let Some(spectrum) = image.mean() {
            sound(&spectrum, whole);
        }
    }
}

/// Names that look like something else in a table: a spread, an axis, a number, a unit.
const HOSTILE_NAMES: [&str; 10] = [
    "standard deviation",
    "A sigma",
    "wavelength",
    "x",
    "[nm]",
    "5%",
    "380nm",
    "R(ref) target",
    "LED (1/2), old; \u{b1}",
    "n/a",
];

/// Writes a spectrum as CSV, alone and several times beside itself under hostile names, and reads
/// it again to the same names and numbers.
fn comes_back(spectrum: &NamedSpectrum) {
    let samples = &spectrum.samples;
    if samples.len() > LONGEST_WRITTEN || samples.last_nm() >= ABSURD {
        return;
    }
    let alone = Columns::measured(spectrum);
    comes_back_as(spectrum, &alone, std::slice::from_ref(spectrum));
    let renamed = HOSTILE_NAMES.map(|name| NamedSpectrum {
        name: name.to_owned(),
        ..spectrum.clone()
    });
    let together = Columns::together(&renamed).expect("one kind and unit");
    comes_back_as(&renamed[0], &together, &renamed);
}

fn comes_back_as(first: &NamedSpectrum, columns: &Columns, all: &[NamedSpectrum]) {
    let text = csv(first, columns, &Provenance::default());
    let again = read_bytes("again.csv", text.as_bytes());
    let again = again.unwrap_or_else(|why| panic!("{why}\n{text}"));
    assert_eq!(again.spectra.len(), all.len(), "{text}");
    let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    for (back, was) in again.spectra.iter().zip(all) {
        if all.len() > 1 {
            assert_eq!(back.name, was.name, "{text}");
        }
        assert_eq!(bits(back.samples.nm()), bits(was.samples.nm()), "{text}");
        let same = bits(back.samples.values()) == bits(was.samples.values());
        assert!(same, "{text}");
    }
}
