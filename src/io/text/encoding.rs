//! The encoding of a text that is neither marked nor UTF-8, detected by words common in titles of
//! tables, else by the pattern of its letters.

use encoding_rs::{
    BIG5, EUC_JP, EUC_KR, Encoding, GBK, IBM866, KOI8_R, SHIFT_JIS, WINDOWS_1251, WINDOWS_1252,
    WINDOWS_1253,
};

/// The amount of text examined, in bytes.
const PROBE_BYTES: usize = 64 * 1024;

const JAPANESE: &str = "波長;反射;透過;分光;強度;吸光;放射;試料;測定;データ";
const RUSSIAN: &str = "длина;волн;коэфф;отраж;пропуск;спектр;интенс;образ;излуч;нм";

/// Encodings and words, or the beginnings of words, that tables of their languages are titled with.
fn titled() -> [(&'static Encoding, &'static str); 10] {
    [
        (GBK, "波长;反射;透射;透过;光谱;强度;吸光;辐;样品"),
        (SHIFT_JIS, JAPANESE),
        (EUC_JP, JAPANESE),
        (BIG5, "波長;反射;穿透;光譜;強度;吸光;輻;樣品;量測"),
        (EUC_KR, "파장;반사;투과;스펙트럼;강도;흡광;시료;측정"),
        (WINDOWS_1251, RUSSIAN),
        (KOI8_R, RUSSIAN),
        (IBM866, RUSSIAN),
        (WINDOWS_1253, "μήκος;κύματος;ανάκλασ;διαπερατ;ένταση"),
        (WINDOWS_1252, "länge;stärke;éclair;réfl;µm;größe;°c;m²"),
    ]
}

pub(super) fn of(bytes: &[u8]) -> &'static Encoding {
    let probe = &bytes[..bytes.len().min(PROBE_BYTES)];
    let end = probe.iter().rposition(|byte| matches!(byte, b'\n' | b'\r'));
    // A character may be cut where the probe ends.
    let probe = match end {
        Some(end) if probe.len() < bytes.len() => &probe[..end],
        _ => probe,
    };
    let titled = titled().into_iter().filter_map(|(encoding, words)| {
        let text = encoding.decode_without_bom_handling_and_without_replacement(probe)?;
        let text = text.to_lowercase();
        let count = words.split(';').filter(|word| text.contains(word)).count();
        (count > 0).then_some((count, encoding))
    });
    // Of equally many words the earlier encoding.
    let best = titled.reduce(|best, other| if other.0 > best.0 { other } else { best });
    best.map_or_else(|| by_letters(probe), |(_, encoding)| encoding)
}

/// Letters of a Western language stand alone among those of ASCII. Words of nothing but high bytes
/// are Cyrillic, and Chinese where they are pairs of the commoner characters.
fn by_letters(probe: &[u8]) -> &'static Encoding {
    let runs = || probe.split(u8::is_ascii).filter(|run| !run.is_empty());
    let (all, long) = (runs().count(), runs().filter(|run| run.len() >= 4).count());
    if 2 * long < all || long == 0 {
        return WINDOWS_1252;
    }
    let is_pair = |pair: &[u8]| matches!(pair, [0xB0..=0xD7, 0xA1..=0xFE]);
    let are_pairs = |run: &[u8]| run.len().is_multiple_of(2) && run.chunks(2).all(is_pair);
    let is_cyrillic = |run: &[u8]| run.iter().all(|byte| *byte >= 0xC0);
    if runs().all(are_pairs) {
        GBK
    } else if runs().filter(|run| run.len() >= 4).all(is_cyrillic) {
        WINDOWS_1251
    } else {
        WINDOWS_1252
    }
}
