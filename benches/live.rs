//! 100 frames a second of 2048 values over TCP, figures of each on standard output: how late they
//! are, how much of a core and how much memory that takes. `-- 10` measures 10 s in place of 60.
//!
//! The producer is a process of its own, so that what is measured is the follower alone.

use std::{
    ffi::OsString,
    fs,
    io::{self, Write},
    net::TcpStream,
    process::{Child, Command},
    thread,
    time::{Duration, Instant, SystemTime, UNIX_EPOCH},
};

use spectral_explorer::cli::{self, Outcome};

const PER_SECOND: u32 = 100;
const VALUES: usize = 2048;
/// What no frame may be later than, ms, and no follower busier than, of a core.
const LATEST_MS: f64 = 100.0;
const BUSIEST: f64 = 0.25;

fn now_ms() -> f64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(0.0, |since| 1e3 * since.as_secs_f64())
}

/// Sends frames at their moments.
fn produce(address: &str, frames: u32) -> io::Result<()> {
    let mut stream = TcpStream::connect(address)?;
    stream.set_nodelay(true)?;
    let nm: Vec<f64> = (0..VALUES).map(|i| 350.0 + 0.25 * i as f64).collect();
    writeln!(stream, "{{\"wavelength_nm\":{nm:?}}}")?;
    let began = Instant::now();
    for frame in 0..frames {
        let due = began + Duration::from_secs(1) * frame / PER_SECOND;
        thread::sleep(due.saturating_duration_since(Instant::now()));
        let noise = |i: usize| ((i as u32 * 7919 + frame * 104_729) % 1000) as f64 * 1e-6;
        let values: Vec<f64> = (0..VALUES)
            .map(|i| 0.5 + 0.4 * (0.01 * i as f64).sin() + noise(i))
            .collect();
        let time_ms = now_ms();
        // A line at once: written in pieces, each number would be a packet of its own.
        let line = format!("{{\"time_ms\":{time_ms},\"values\":{values:?}}}\n");
        stream.write_all(line.as_bytes())?;
    }
    Ok(())
}

/// Processor time of this process, s, and its memory, MB; `None` where the system does not tell.
fn used() -> Option<(f64, f64)> {
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = fields.get(11)?.parse::<f64>().ok()? + fields.get(12)?.parse::<f64>().ok()?;
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmRSS:"))?;
    let kib: f64 = line.split_whitespace().next()?.parse().ok()?;
    // Linux counts hundredths of a second.
    Some((ticks / 100.0, kib / 1024.0))
}

/// Takes what the follower prints: how late each frame is, and what was used meanwhile.
struct Watched {
    late_ms: Vec<f64>,
    used: Vec<(f64, f64)>,
}

impl Write for Watched {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let text = String::from_utf8_lossy(bytes);
        let time = text.split_once("\"time_ms\":").map(|(_, rest)| rest);
        let time = time.and_then(|rest| rest.split([',', '}']).next()?.parse::<f64>().ok());
        self.late_ms.extend(time.map(|time| now_ms() - time));
        if self.late_ms.len().is_multiple_of(PER_SECOND as usize) {
            self.used.extend(used());
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Starts the producer once the follower tells where it listens.
struct Starts {
    said: String,
    frames: u32,
    producer: Option<Child>,
}

impl Write for Starts {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.said += &String::from_utf8_lossy(bytes);
        let address = self.said.split_once("listening at ").map(|(_, rest)| rest);
        let address = address.and_then(|rest| rest.split_once('\n'));
        if let (None, Some((address, _))) = (&self.producer, address) {
            let program = std::env::current_exe()?;
            let mut command = Command::new(program);
            let command = command.args(["produce", address, &self.frames.to_string()]);
            self.producer = Some(command.spawn()?);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn main() -> io::Result<()> {
    let args: Vec<String> = std::env::args().collect();
    if let [_, word, address, frames] = &args[..]
        && word == "produce"
    {
        return produce(address, frames.parse().unwrap_or(0));
    }
    let seconds = args.iter().skip(1).find_map(|word| word.parse().ok());
    let frames = seconds.unwrap_or(60).max(2) * PER_SECOND;
    let words = ["follow", "--listen", "0", "--json", "--count"];
    let count = frames.to_string();
    let words = [cli::PROGRAM].into_iter().chain(words).chain([&*count]);
    let mut watched = Watched {
        late_ms: Vec::new(),
        used: Vec::new(),
    };
    let mut starts = Starts {
        said: String::new(),
        frames,
        producer: None,
    };
    let outcome = cli::run(words.map(OsString::from), None, &mut watched, &mut starts);
    if let Some(mut producer) = starts.producer {
        producer.wait()?;
    }
    assert_eq!(outcome, Outcome::Done(0), "{}", starts.said);
    let mut late = watched.late_ms;
    late.sort_by(f64::total_cmp);
    let at = |share: f64| late[((late.len() - 1) as f64 * share) as usize];
    println!(
        "{} frames of {VALUES} values, {PER_SECOND} a second",
        late.len()
    );
    println!(
        "late by {:.1} ms (median), {:.1} (99 %), {:.1} at most; {LATEST_MS} asked for",
        at(0.5),
        at(0.99),
        at(1.0)
    );
    match (watched.used.first(), watched.used.last()) {
        (Some((from, before)), Some((to, after))) => {
            let span = (watched.used.len() - 1) as f64;
            println!("{:.2} of a core; {BUSIEST} asked for", (to - from) / span);
            println!("memory {before:.1} MB after 1 s, {after:.1} MB at the end");
        }
        _ => println!("this system does not tell processor time and memory"),
    }
    Ok(())
}
