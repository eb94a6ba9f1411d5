//! A serial port, whose cable is a pair of pseudo-terminals.

use super::*;
use crate::streams::{BAUD, Event, Source};

const PATIENCE: Duration = Duration::from_secs(60);

#[test]
fn a_serial_port_tells_frames_and_that_it_was_unplugged() {
    // A pair of pseudo-terminals stands for a cable.
    let (instrument, port) = SerialPort::pair().expect("pseudo-terminals");
    let path = PathBuf::from("no such port");
    let mut source = Serial::of(port, path, BAUD, Lines::new("sensor"));
    instrument
        .write_all(b"415nm:1,445nm:2\r\n")
        .expect("written");
    match source.next(PATIENCE) {
        Some(Event::Frame(frame)) => assert_eq!(frame.samples.nm(), [415.0, 445.0]),
        event => panic!("{event:?}"),
    }
    drop(instrument);
    match source.next(PATIENCE) {
        Some(Event::Said(words)) => assert!(words.contains("unplugged"), "{words}"),
        event => panic!("{event:?}"),
    }
    assert_eq!(source.next(Duration::ZERO), None);
}
