//! Lines, whole and broken.

use super::*;

fn read(lines: &mut Lines, text: &str) -> Vec<Frame> {
    let mut frames = Vec::new();
    lines.feed(text.as_bytes(), 5.0, |frame| frames.push(frame));
    frames
}

#[test]
fn numbers_follow_their_wavelengths_between_commas_tabs_or_blanks() {
    for text in [
        "400,450,500,550,600\n1,2,3,4,5\n",
        "400\t450\t500\t550\t600\r\n1\t2\t3\t4\t5\r\n",
        "wavelength_nm 400 450 500 550 600\n1  2 3 4 5\n",
        "600,550,500,450,400,\n5, 4, 3, 2, 1,\n",
        "# a sensor\n\n400:1,450:2,500:3,550:4,600:5\n",
        "F5_600nm:5 clear:9 400nm:1 450[nm]:2 500nm:3 F4(550nm):4\n",
        "{\"wavelength_nm\":[400,450,500,550,600]}\n{\"values\":[1,2,3,4,5]}\n",
    ] {
        let mut lines = Lines::new("sensor");
        let frames = read(&mut lines, text);
        assert_eq!(frames.len(), 1, "{text}: {:?}", lines.broken);
        let samples = &frames[0].samples;
        assert_eq!(samples.nm(), [400.0, 450.0, 500.0, 550.0, 600.0], "{text}");
        assert_eq!(samples.values(), [1.0, 2.0, 3.0, 4.0, 5.0], "{text}");
        assert_eq!(lines.broken, Broken::default(), "{text}");
    }
}

#[test]
fn an_object_tells_exposure_unit_time_and_instrument() {
    let mut lines = Lines::new("meter");
    let text = "{\"wavelength_nm\":[400,500],\"values\":[1,2],\"integration_ms\":30,\
                \"unit\":\"counts\",\"time_ms\":7.5,\"instrument\":\"Flame\",\"else\":[1]}\n";
    let frame = read(&mut lines, text).remove(0);
    assert_eq!(frame.integration_ms, Some(30.0));
    assert_eq!((frame.unit.as_str(), frame.time_ms), ("counts", 7.5));
    assert_eq!(frame.instrument, "Flame");
    // The wavelengths stay, the time is that of the line.
    let next = read(&mut lines, "{\"values\":[3,4]}\n").remove(0);
    assert_eq!(
        (next.samples.nm(), next.time_ms),
        (&[400.0, 500.0][..], 5.0)
    );
}

#[test]
fn values_without_wavelengths_take_those_of_the_instrument_and_are_no_wavelengths_themselves() {
    let rising = "410 420 430 440 450\n";
    let mut lines = Lines::new("sensor");
    assert_eq!(read(&mut lines, "1 2 3 4 5\n"), []);
    assert!(
        lines.broken.last.contains("instrument"),
        "{:?}",
        lines.broken
    );
    let mut lines = Lines::new("sensor")
        .on_axis(vec![400.0, 450.0, 500.0, 550.0, 600.0])
        .expect("rising");
    let frames = read(&mut lines, &format!("{rising}F1:1 F2:2 F3:3 F4:4 F5:5\n"));
    assert_eq!(frames.len(), 2);
    assert_eq!(frames[0].samples.values()[0], 410.0);
}

#[test]
fn a_hundred_thousand_broken_lines_are_counted_and_none_is_shown() {
    let mut lines = Lines::new("noise");
    assert_eq!(read(&mut lines, "400,450,500,550,600\n"), []);
    let broken = [
        "1,2,3,4",
        "1,2,3,4,5,6",
        "1,2,,4,5",
        "1,2,three,4,5",
        "1,2,nan,4,5",
        "1,inf,3,4,5",
        "1,2,1e40,4,5",
        "{\"values\":[1,2,3",
        "{}",
        "400nm:1,450nm:x",
        "{\"values\":[1,null,3,4,5]}",
        "{\"wavelength_nm\":[400,400],\"values\":[1,2]}",
        "\u{0}\u{1}",
        "1;2;3;4;5",
        "{\"wavelength_nm\":[0,1],\"values\":[1,2]}",
    ];
    let count = 100_000;
    for line in broken.iter().cycle().take(count) {
        assert_eq!(read(&mut lines, &format!("{line}\n")), [], "{line}");
    }
    lines.feed(b"\xff\xfe1,2\n", 0.0, |frame| panic!("{frame:?}"));
    assert_eq!(lines.broken.count, count as u64 + 1);
    assert!(lines.broken.last.contains("no text"));
    // What is whole is shown afterwards.
    assert_eq!(read(&mut lines, "1,2,3,4,5\n").len(), 1);
}

#[test]
fn lines_are_the_same_however_the_bytes_are_cut_and_none_is_endless() {
    let text = "400,450,500,550,600\n1,2,3,4,5\n6,7,8,9,10\n";
    for size in [1, 2, 3, 7, 20] {
        let mut lines = Lines::new("cut");
        let mut frames = Vec::new();
        for bytes in text.as_bytes().chunks(size) {
            lines.feed(bytes, 0.0, |frame| frames.push(frame));
        }
        assert_eq!(frames.len(), 2, "{size}");
        assert_eq!(frames[1].samples.values()[4], 10.0, "{size}");
    }
    let mut lines = Lines::new("endless");
    for _ in 0..40 {
        lines.feed(&[b'1'; 100_000], 0.0, |frame| panic!("{frame:?}"));
        assert!(lines.pending.capacity() <= 2 * MOST_LINE_BYTES);
    }
    assert_eq!(read(&mut lines, "\n"), []);
    assert_eq!(read(&mut lines, text).len(), 2);
    assert_eq!(lines.broken.count, 1);
}

#[test]
fn half_a_line_at_the_end_is_no_frame_and_another_producer_begins_anew() {
    let mut lines = Lines::new("killed");
    // The last number may have been 56.
    assert_eq!(read(&mut lines, "400,450,500,550,600\n1,2,3,4,5"), []);
    lines.begin();
    assert_eq!(lines.broken.count, 1);
    // Values of one that tells no wavelengths are not put on those of the one before.
    assert_eq!(read(&mut lines, "1,2,3,4,5\n"), []);
    assert_eq!(lines.broken.count, 2);
}
