//! Lines over TCP and standard input.

use std::{io::Write, net::Ipv4Addr};

use super::*;

/// Long enough for a busy machine; nothing waits for all of it unless something is wrong.
const PATIENCE: Duration = Duration::from_secs(60);

fn words(event: Option<Event>) -> String {
    match event {
        Some(Event::Said(words)) => words,
        event => panic!("{event:?}"),
    }
}

fn values(event: Option<Event>) -> Vec<f64> {
    match event {
        Some(Event::Frame(frame)) => frame.samples.values().to_vec(),
        event => panic!("{event:?}"),
    }
}

fn on_loopback() -> (LineSource<Listener>, SocketAddr) {
    let any = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
    let source = listen(any, Reach::Loopback, Lines::new("tcp")).expect("a free port");
    let address = source.name().parse().expect("an address");
    (source, address)
}

#[test]
fn nothing_listens_beyond_loopback_unless_asked() {
    let everywhere = SocketAddr::from((Ipv4Addr::UNSPECIFIED, 0));
    let refused = listen(everywhere, Reach::Loopback, Lines::new("tcp"));
    let why = refused.err().expect("refused").to_string();
    assert!(why.contains("expected a loopback address"), "{why}");
    assert!(listen(everywhere, Reach::All, Lines::new("tcp")).is_ok());
    let (source, address) = on_loopback();
    assert!(address.ip().is_loopback());
    let second = listen(address, Reach::Loopback, Lines::new("tcp"));
    assert!(matches!(second, Err(ListenError::Taken { .. })));
    drop(source);
}

#[test]
fn a_producer_that_dies_in_the_middle_of_a_line_is_told_and_the_next_one_is_heard() {
    let (mut source, address) = on_loopback();
    let head = "400,450,500,550,600\n";
    let mut producer = TcpStream::connect(address).expect("connected");
    producer
        .write_all(format!("{head}1,2,3,4,5\n6,7,8,9,1").as_bytes())
        .expect("sent");
    assert!(words(source.next(PATIENCE)).ends_with("sends."));
    assert_eq!(values(source.next(PATIENCE)), [1.0, 2.0, 3.0, 4.0, 5.0]);
    drop(producer);
    assert!(words(source.next(PATIENCE)).contains("the last spectrum stays"));
    assert_eq!(source.broken().count, 1);
    let mut producer = TcpStream::connect(address).expect("connected");
    producer
        .write_all(format!("{head}5,4,3,2,1\n").as_bytes())
        .expect("sent");
    assert!(words(source.next(PATIENCE)).ends_with("sends."));
    assert_eq!(values(source.next(PATIENCE)), [5.0, 4.0, 3.0, 2.0, 1.0]);
    assert_eq!(source.next(Duration::ZERO), None);
}

#[test]
fn the_end_of_standard_input_is_the_end_and_a_cut_number_is_none() {
    let text = "400,450,500,550,600\n1,2,3,4,5\n1,2,3,4,5";
    let mut source = piped(text.as_bytes(), "-", Lines::new("-"));
    assert_eq!(values(source.next(PATIENCE)).len(), 5);
    assert_eq!(source.next(PATIENCE), Some(Event::End));
    assert_eq!(source.next(PATIENCE), Some(Event::End));
    assert_eq!(source.broken().count, 1);
    // An object is whole where its last bracket stands.
    let object = "{\"wavelength_nm\":[400,500],\"values\":[1,2]}";
    let mut source = piped(object.as_bytes(), "-", Lines::new("-"));
    assert_eq!(values(source.next(PATIENCE)), [1.0, 2.0]);
    assert_eq!(source.next(PATIENCE), Some(Event::End));
    assert_eq!(source.broken().count, 0);
}
