//! German, French and Spanish words for what the library holds, and the English words that find it.
//!
//! Accents may be left out, and German umlauts may be written as two letters: `Glühbirne`,
//! `Gluehbirne` and `gluhbirne` are one word.

use std::{collections::HashMap, sync::LazyLock};

use super::score::plain;

/// English words, and the German, French and Spanish ones for them.
const TABLE: &[(&str, &[&str])] = &[
    ("bulb", &["Glühbirne", "Glühlampe", "ampoule", "bombilla"]),
    (
        "incandescent bulb",
        &["lampe à incandescence", "lámpara incandescente"],
    ),
    ("filament", &["Glühfaden", "Glühdraht", "filamento"]),
    ("tungsten", &["tungstène", "tungsteno", "wolframio"]),
    ("halogen", &["Halogenlampe", "halogène", "halógeno"]),
    (
        "candle",
        &["Kerze", "Kerzenlicht", "bougie", "chandelle", "vela"],
    ),
    ("flame", &["Flamme", "llama"]),
    ("fire", &["Feuer", "feu", "fuego"]),
    ("campfire", &["Lagerfeuer", "feu de camp", "hoguera"]),
    ("fireplace", &["Kamin", "cheminée", "chimenea"]),
    (
        "sun",
        &[
            "Sonne",
            "Sonnenlicht",
            "soleil",
            "lumière du soleil",
            "luz solar",
            "luz del sol",
        ],
    ),
    ("space", &["Weltraum", "Weltall", "espace", "espacio"]),
    ("star", &["Stern", "étoile", "estrella"]),
    (
        "daylight",
        &["Tageslicht", "lumière du jour", "luz del día", "luz de día"],
    ),
    ("sky", &["Himmel", "ciel", "cielo"]),
    ("overcast", &["bewölkt", "bedeckt", "nuageux", "nublado"]),
    ("window", &["Fenster", "fenêtre", "ventana"]),
    ("print", &["Druck", "impression", "impresión"]),
    (
        "fluorescent tube",
        &[
            "Leuchtstoffröhre",
            "Leuchtstofflampe",
            "tube fluorescent",
            "tubo fluorescente",
            "fluorescente",
        ],
    ),
    ("office", &["Büro", "bureau", "oficina"]),
    ("school", &["Schule", "école", "escuela"]),
    ("classroom", &["Klassenzimmer", "salle de classe", "aula"]),
    (
        "supermarket",
        &["Supermarkt", "supermarché", "supermercado"],
    ),
    ("shop", &["Laden", "magasin", "tienda"]),
    (
        "energy saving lamp",
        &[
            "Energiesparlampe",
            "Sparlampe",
            "lampe à économie d'énergie",
            "ampoule basse consommation",
            "bombilla de bajo consumo",
        ],
    ),
    (
        "led",
        &["Leuchtdiode", "diode électroluminescente", "diodo"],
    ),
    (
        "flashlight",
        &["Taschenlampe", "lampe de poche", "linterna"],
    ),
    ("museum led", &["musée", "museo"]),
    ("warm white", &["warmweiß", "blanc chaud", "blanco cálido"]),
    ("cool white", &["kaltweiß", "blanc froid", "blanco frío"]),
    ("sodium", &["Natrium", "sodio"]),
    (
        "sodium lamp",
        &["Natriumdampflampe", "lampe à sodium", "lámpara de sodio"],
    ),
    (
        "high pressure",
        &["Hochdruck", "haute pression", "alta presión"],
    ),
    (
        "low pressure",
        &["Niederdruck", "basse pression", "baja presión"],
    ),
    (
        "street lamp",
        &[
            "Straßenlampe",
            "Straßenlaterne",
            "Straßenbeleuchtung",
            "réverbère",
            "lampadaire",
            "éclairage public",
            "farola",
            "alumbrado público",
        ],
    ),
    ("mercury", &["Quecksilber", "mercure", "mercurio"]),
    (
        "mercury lamp",
        &["Quecksilberdampflampe", "lampe au mercure"],
    ),
    (
        "metal halide",
        &[
            "Metalldampflampe",
            "Halogenmetalldampflampe",
            "halogénures métalliques",
            "halogenuros metálicos",
        ],
    ),
    ("stadium", &["Stadion", "stade", "estadio"]),
    ("floodlight", &["Flutlicht", "Scheinwerfer", "foco"]),
    ("cinema", &["Kino", "cinéma", "cine"]),
    ("projector", &["Projektor", "projecteur", "proyector"]),
    ("flash", &["Blitz", "éclair"]),
    ("xenon", &["xénon", "xenón"]),
    ("hydrogen", &["Wasserstoff", "hydrogène", "hidrógeno"]),
    ("helium", &["hélium", "helio"]),
    ("neon", &["néon", "neón"]),
    ("neon tube", &["Neonröhre", "tube au néon", "tubo de neón"]),
    ("argon", &["argón"]),
    ("krypton", &["criptón"]),
    ("cadmium", &["cadmio"]),
    ("neodymium", &["Neodym", "néodyme", "neodimio"]),
    ("laser", &["láser"]),
    ("filter", &["filtre", "filtro"]),
    (
        "colour filter",
        &["Farbfilter", "filtre coloré", "filtro de color"],
    ),
    ("gel", &["Farbfolie", "gélatine", "gelatina"]),
    ("glass", &["Glas", "verre", "vidrio"]),
    ("red", &["rot", "rouge", "rojo", "roja"]),
    ("green", &["grün", "vert", "verte", "verde"]),
    ("blue", &["blau", "bleu", "bleue", "azul"]),
    ("yellow", &["gelb", "jaune", "amarillo", "amarilla"]),
    ("white", &["weiß", "blanc", "blanche", "blanco", "blanca"]),
    ("skin", &["Haut", "peau", "piel"]),
    ("leaf", &["Blatt", "feuille", "hoja"]),
    ("grass", &["Gras", "herbe", "hierba", "césped"]),
    ("flower", &["Blume", "fleur", "flor"]),
    ("carrot", &["Möhre", "Karotte", "carotte", "zanahoria"]),
    ("banana", &["Banane", "plátano"]),
    ("apple", &["Apfel", "pomme", "manzana"]),
    ("meat", &["Fleisch", "viande", "carne"]),
    ("brick", &["Ziegel", "Backstein", "brique", "ladrillo"]),
    ("soil", &["Erde", "Boden", "terre", "tierra"]),
    ("snow", &["Schnee", "neige", "nieve"]),
    ("water", &["Wasser", "eau", "agua"]),
    ("sea", &["Meer", "mer", "mar"]),
    ("mirror", &["Spiegel", "miroir", "espejo"]),
    ("gold", &["oro"]),
    ("silver", &["Silber", "argent", "plata"]),
    ("copper", &["Kupfer", "cuivre", "cobre"]),
    ("iron", &["Eisen", "hierro"]),
    ("steel", &["Stahl", "acier", "acero"]),
    ("brass", &["Messing", "laiton", "latón"]),
    ("lamp", &["Lampe", "lámpara"]),
    ("light", &["Licht", "lumière", "luz"]),
];

/// Small words between others, which find nothing.
const SMALL: [&str; 27] = [
    "a", "al", "au", "aux", "con", "d", "das", "de", "del", "der", "des", "die", "du", "el", "en",
    "et", "la", "las", "le", "les", "los", "mit", "the", "und", "un", "une", "y",
];

/// By every way of writing a foreign word without accents, its English.
static ENGLISH: LazyLock<HashMap<String, &'static str>> = LazyLock::new(|| {
    let mut english = HashMap::new();
    for (to, foreign) in TABLE {
        for word in *foreign {
            for written in [unaccented(word), unaccented(&with_two_letters(word))] {
                english.insert(written.clone(), *to);
                english.insert(without_small(&written), *to);
            }
        }
    }
    english
});

/// The English for what is typed: of all of it, or word by word where that knows one at least.
pub(super) fn english(typed: &str) -> Option<String> {
    let typed = unaccented(typed);
    let short = without_small(&typed);
    for whole in [&typed, &short] {
        if let Some(english) = ENGLISH.get(whole) {
            return Some((*english).to_owned());
        }
    }
    let words = short.split(' ');
    let each: Vec<&str> = words
        .map(|word| ENGLISH.get(word).map_or(word, |to| *to))
        .collect();
    let english = each.join(" ");
    (english != short).then_some(english)
}

/// The English for a foreign word that begins so, or nearly is so.
pub(super) fn english_nearly(typed: &str) -> Option<&'static str> {
    let typed = unaccented(typed);
    let letters = typed.chars().count();
    if letters < LEAST {
        return None;
    }
    let begun = ENGLISH.iter().filter(|(word, _)| word.starts_with(&typed));
    // The shortest is what is typed soonest; of equals the first in the alphabet.
    let begun = begun.min_by_key(|(word, _)| (word.len(), (*word).clone()));
    let most = letters / 4;
    let near = || {
        let all = ENGLISH.iter();
        let errors = all.map(|(word, to)| (strsim::osa_distance(&typed, word), word, to));
        let near = errors.filter(|(errors, ..)| *errors <= most);
        let best = near.min_by_key(|(errors, word, _)| (*errors, (*word).clone()));
        best.map(|(_, _, to)| *to)
    };
    begun.map(|(_, to)| *to).or_else(near)
}

/// Fewer letters begin too many words.
const LEAST: usize = 4;

/// Plain words without accents: what is sorted and searched by.
pub fn unaccented(text: &str) -> String {
    let plain = plain(text);
    let mut out = String::with_capacity(plain.len());
    for letter in plain.chars() {
        match letter {
            'ä' | 'à' | 'â' | 'á' | 'ã' => out.push('a'),
            'ö' | 'ô' | 'ó' | 'ò' => out.push('o'),
            'ü' | 'û' | 'ú' | 'ù' => out.push('u'),
            'é' | 'è' | 'ê' | 'ë' => out.push('e'),
            'í' | 'î' | 'ï' | 'ì' => out.push('i'),
            'ç' => out.push('c'),
            'ñ' => out.push('n'),
            'ß' => out.push_str("ss"),
            'œ' => out.push_str("oe"),
            other => out.push(other),
        }
    }
    out
}

/// Umlauts as two letters.
fn with_two_letters(word: &str) -> String {
    let lower = word.to_lowercase();
    lower
        .replace('ä', "ae")
        .replace('ö', "oe")
        .replace('ü', "ue")
}

fn without_small(text: &str) -> String {
    let words = text.split(' ').filter(|word| !SMALL.contains(word));
    words.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
pub(super) fn table() -> impl Iterator<Item = (&'static str, &'static str)> {
    let rows = TABLE.iter();
    rows.flat_map(|(english, foreign)| foreign.iter().map(move |word| (*word, *english)))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn accents_change_no_order_of_words() {
        let mut words = ["Zacke", "Überlagerung", "Ökologie", "Auge"];
        words.sort_by_key(|word| unaccented(word));
        assert_eq!(words, ["Auge", "Ökologie", "Überlagerung", "Zacke"]);
    }

    #[test]
    fn a_word_is_known_with_and_without_its_accents() {
        for typed in ["Glühbirne", "gluehbirne", "GLUHBIRNE", "die Glühbirne"] {
            assert_eq!(english(typed).as_deref(), Some("bulb"), "{typed}");
        }
        for typed in ["warmweiß", "warmweiss"] {
            assert_eq!(english(typed).as_deref(), Some("warm white"), "{typed}");
        }
        assert_eq!(english("lampe a sodium").as_deref(), Some("sodium lamp"));
        assert_eq!(english("lumière du jour").as_deref(), Some("daylight"));
        // Word by word, with what is the same in both.
        assert_eq!(english("rot LED").as_deref(), Some("red led"));
        assert_eq!(english("tungsten"), None);
    }

    #[test]
    fn a_word_is_known_by_its_beginning_and_nearly() {
        assert_eq!(english_nearly("quecks"), Some("mercury"));
        assert_eq!(english_nearly("Kezre"), Some("candle"));
        assert_eq!(english_nearly("que"), None);
        assert_eq!(english_nearly("qqqqqqqq"), None);
    }

    #[test]
    fn there_are_a_hundred_and_fifty_words_each_of_one_meaning() {
        let words: BTreeSet<&str> = table().map(|(word, _)| word).collect();
        assert!(words.len() >= 150, "{}", words.len());
        assert_eq!(words.len(), table().count(), "a word stands twice");
        for (word, to) in table() {
            assert_eq!(english(word).as_deref(), Some(to), "{word}");
        }
    }
}
