//! Formats that are known by their content and not read: refused by their name.

use crate::told::refusal;

#[test]
fn files_of_other_kinds_are_refused_by_name() {
    for (name, bytes, words) in [
        ("a.zip", b"PK\x03\x04....".as_slice(), "zip archive"),
        ("a.png", b"\x89PNG\r\n\x1a\n", "PNG"),
        ("a.jpg", b"\xff\xd8\xff\xe0", "JPEG"),
        ("a.pdf", b"%PDF-1.7", "PDF"),
        ("a.spc", b"\0\x4b\x01\x02\x03\x04\x05\x06\0", "Galactic"),
        ("a.sli", b"\0\x01\x02\x03\x04\x05\x06\0\0", "ENVI"),
        ("a.spdx", b"SPDXVersion: SPDX-2.3\n", "software licence"),
        ("a.dx", b"<br />\n<b>Warning</b>", "web page"),
        ("a.asd", b"as7\0\0\x01\0\0", "ASD binary"),
        ("a.0", b"\n\n\xfe\xfe\x01\0\0\0", "OPUS"),
        ("a.IRR8", b"AVS84\x01\0\0\0", "AvaSoft"),
        (
            "a.dat",
            b"\"TOA5\",\"CR6\"\n\"TS\",1\n\"x\",2\n",
            "data logger",
        ),
        ("a", b"\x01\x02\x03\x04\x05", "binary data"),
    ] {
        let why = refusal(name, bytes);
        assert!(why.contains(words), "{why}");
        assert!(why.starts_with(&format!("{name}: found")), "{why}");
    }
}
