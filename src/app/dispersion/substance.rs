//! What a prism or a gem is made of: a material of the program, an index that was opened, or two
//! numbers.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::{
    app::{entry::Entry, pages::knob::Reach, state::App},
    io::many::capitalised,
    languages::fixed,
    optics::{BuiltinMaterial, IndexError, Material},
    spectrum::{Kind, NamedSpectrum},
};

/// What a body is made of; kept as a word: "diamond", "1.5168,64.17" or the key of a spectrum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub enum Substance {
    /// A material that comes with the program.
    Shipped(BuiltinMaterial),
    /// A curve of n that was opened.
    Own { index: String },
    /// By hand.
    Numbers {
        /// Index at the line d.
        n_d: f64,
        /// Abbe number.
        v_d: f64,
    },
}

impl From<String> for Substance {
    fn from(word: String) -> Self {
        let numbers = word.split_once(',').and_then(|(n_d, v_d)| {
            let [n_d, v_d] = [n_d, v_d].map(|number| number.trim().parse().ok());
            Some(Self::Numbers {
                n_d: n_d?,
                v_d: v_d?,
            })
        });
        let shipped = BuiltinMaterial::from_word(&word).map(Self::Shipped);
        shipped.or(numbers).unwrap_or(Self::Own { index: word })
    }
}

impl From<Substance> for String {
    fn from(substance: Substance) -> Self {
        match substance {
            Substance::Shipped(stuff) => stuff.word().to_owned(),
            Substance::Own { index } => index,
            Substance::Numbers { n_d, v_d } => format!("{n_d},{v_d}"),
        }
    }
}

/// Indices at the line d that can be set by hand.
pub const INDICES: Reach = Reach::Within(1.05, 3.0);

/// Abbe numbers that can be set by hand.
pub const ABBES: Reach = Reach::Within(10.0, 100.0);

impl Substance {
    /// Two numbers to begin with: those of crown glass.
    pub const NUMBERS: Self = Self::Numbers {
        n_d: 1.5168,
        v_d: 64.17,
    };

    /// In words for people.
    pub fn title(&self, app: &App) -> String {
        match self {
            Self::Shipped(stuff) => stuff.title().to_owned(),
            Self::Own { index } => app.entry(index).map_or_else(
                || said!("an index that is not open").to_owned(),
                |entry| material_name(&entry.spectrum).to_owned(),
            ),
            Self::Numbers { .. } => said!("two numbers").to_owned(),
        }
    }

    /// The same in a sentence: "diamond", "a glass of n 1.5168 and V 64.2".
    pub fn in_words(&self, app: &App) -> String {
        match self {
            Self::Numbers { n_d, v_d } => {
                tr!(
                    "two numbers (n {n_d}, V {v_d})",
                    n_d = fixed(n_d, 4),
                    v_d = fixed(v_d, 1)
                )
            }
            _ => {
                let title = self.title(app);
                title.split(',').next().unwrap_or_default().to_owned()
            }
        }
    }

    /// Its dispersion.
    ///
    /// # Errors
    /// A sentence where the index is not open, or is none of a clear material.
    pub fn material(&self, app: &App) -> Result<Material, String> {
        let said = |why: IndexError| capitalised(&format!("{why}."));
        match self {
            Self::Shipped(stuff) => Ok(stuff.material()),
            Self::Own { index } => {
                let entry = app.entry(index).filter(|entry| is_index(&entry.spectrum));
                let entry = entry.ok_or_else(|| {
                    said!(
                        "The file of this material's index is not open: open it again, or choose \
                         another material."
                    )
                    .to_owned()
                })?;
                let own = app.document().own.iter().map(|entry| &entry.spectrum);
                material_of(&entry.spectrum, own).map_err(said)
            }
            Self::Numbers { n_d, v_d } => Material::from_two_numbers(*n_d, *v_d).map_err(said),
        }
    }

    /// Moves numbers that are set by hand to what is allowed.
    pub fn settle(&mut self) {
        if let Self::Numbers { n_d, v_d } = self {
            *n_d = INDICES.nearest(*n_d, 1.5168);
            *v_d = ABBES.nearest(*v_d, 64.17);
        }
    }
}

/// The curves of n among the user's own spectra, the newest first.
pub fn own_indices(app: &App) -> impl Iterator<Item = &Arc<Entry>> {
    let own = app.document().own.iter().rev();
    own.filter(|entry| is_index(&entry.spectrum))
}

/// Whether a spectrum is a curve of n as the reader of refractive indices names it.
pub fn is_index(spectrum: &NamedSpectrum) -> bool {
    spectrum.kind == Kind::Other && (spectrum.name == "n" || stem_of(&spectrum.name).is_some())
}

/// "glass" of "glass n" and of "glass n by formula 2".
fn stem_of(name: &str) -> Option<&str> {
    let before = |mark: &str| name.split_once(mark).map(|(stem, _)| stem);
    before(" n by ").or_else(|| name.strip_suffix(" n"))
}

/// What the curve is of: a column that is named "n" alone is of what its file is called after.
fn material_name(spectrum: &NamedSpectrum) -> &str {
    stem_of(&spectrum.name).unwrap_or(&spectrum.source)
}

/// The material that a curve of n tells of: by its formula where it has one, and with the k of the
/// same file, which is looked for among other curves.
///
/// # Errors
/// For values that are no index.
pub fn material_of<'a>(
    spectrum: &NamedSpectrum,
    mut others: impl Iterator<Item = &'a NamedSpectrum>,
) -> Result<Material, IndexError> {
    let (name, source) = (material_name(spectrum), &spectrum.source);
    let material = match spectrum.samples.formula() {
        Some(formula) => Material::from_formula(name, source, formula.clone()),
        None => Material::from_table(name, source, &spectrum.samples, false)?,
    };
    let extinction = stem_of(&spectrum.name).map_or("k".to_owned(), |stem| format!("{stem} k"));
    let is_its = |other: &&NamedSpectrum| {
        other.kind == Kind::Other && other.name == extinction && other.source == *source
    };
    Ok(match others.find(is_its) {
        Some(k) => material.with_extinction(k.samples.clone()),
        None => material,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{Command, assert_says, opened::Opened},
        io::read_bytes,
    };

    const GLASS: &str = "REFERENCES: A. Author\nDATA:\n  - type: tabulated nk\n    data: |\n        \
        0.3 1.65 0\n        0.5 1.60 0\n        0.9 1.58 0\n";

    fn with_glass() -> App {
        let mut app = App::new();
        let reading = read_bytes("glass.yml", GLASS.as_bytes()).expect("a table");
        let spectra = reading.spectra.into_iter();
        let opened = spectra.map(|spectrum| Opened::alone(spectrum, Vec::new()));
        app.apply(Command::Open(opened.collect()));
        app
    }

    #[test]
    fn an_opened_curve_of_n_is_a_material_and_that_of_k_is_none() {
        let app = with_glass();
        let found: Vec<_> = own_indices(&app).collect();
        assert_eq!(found.len(), 1);
        let own = Substance::Own {
            index: found[0].key.clone(),
        };
        assert_eq!(own.title(&app), "glass");
        let n = own.material(&app).expect("a glass").index(500.0);
        assert!((n.expect("in its table") - 1.6).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_material_says_so() {
        let app = App::new();
        let gone = Substance::Own {
            index: "own/7".to_owned(),
        };
        assert_says(&gone.material(&app).expect_err("gone"), "not open");
        let light = Substance::Own {
            index: app.document().light.key.clone(),
        };
        assert!(light.material(&app).is_err());
        let mut none = Substance::Numbers { n_d: 0.5, v_d: 1.0 };
        assert!(none.material(&app).is_err_and(|why| why.ends_with('.')));
        none.settle();
        assert!(none.material(&app).is_ok());
    }

    #[test]
    fn words_of_earlier_versions_are_understood() {
        let read = |text: &str| serde_json::from_str::<Substance>(text).expect("a substance");
        assert_eq!(
            read("\"n-sf11\""),
            Substance::Shipped(BuiltinMaterial::NSf11)
        );
        for one in [
            Substance::NUMBERS,
            Substance::Own {
                index: "own/3".to_owned(),
            },
        ] {
            let text = serde_json::to_string(&one).expect("JSON");
            assert_eq!(read(&text), one);
        }
    }

    #[test]
    fn the_k_of_the_same_file_makes_an_opaque_material_refused() {
        let text = "REFERENCES: A. Author\nDATA:\n  - type: tabulated nk\n    data: |\n        \
            0.3 1.5 5\n        0.5 1.6 5\n        0.9 1.7 5\n";
        let reading = read_bytes("m.yml", text.as_bytes()).expect("a table");
        let n = reading.spectra.iter().find(|s| is_index(s)).expect("n");
        let metal = material_of(n, reading.spectra.iter()).expect("values of an index");
        let why = metal.index(500.0).expect_err("k is 5").to_string();
        assert_says(&why, "found n 1.6000, k 5.0000 at 500 nm");
    }

    #[test]
    fn a_file_with_a_formula_gives_its_index_to_the_last_digit() {
        let text = "REFERENCES: A\nDATA:\n  - type: formula 2\n    wavelength_range: 0.3 2.5\n    \
            coefficients: 0 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 \
            103.560653\n";
        let reading = read_bytes("bk7.yml", text.as_bytes()).expect("a formula");
        let n = reading.spectra.iter().find(|s| is_index(s)).expect("n");
        let glass = material_of(n, reading.spectra.iter()).expect("an index");
        // By mpmath with 50 digits; between whole nm, where a table would be straight or bent.
        assert!((glass.index(587.6).unwrap() - 1.516_798_437_905_008_7).abs() < 1e-14);
        assert!((glass.d_index_d_nm(587.6).unwrap() / -4.179_195_425_607_8e-5 - 1.0).abs() < 1e-12);
        let figures = glass.abbe().expect("it covers the lines");
        let own = BuiltinMaterial::NBk7
            .material()
            .abbe()
            .expect("so does that");
        assert!((figures.v_d - own.v_d).abs() < 1e-9 && (figures.v_e - own.v_e).abs() < 1e-9);
    }
}
