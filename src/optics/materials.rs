//! The materials that come with the program.
//!
//! Coefficients as in the database of refractiveindex.info (M. N. Polyanskiy, CC0 1.0), each from
//! the source named. Form L is written with resonances c in um and squared here.

use serde::{Deserialize, Serialize};

use super::index::{Material, Term};

/// A material of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BuiltinMaterial {
    /// Diamond.
    #[default]
    Diamond,
    /// Cubic zirconia with 12 % yttria.
    Zirconia,
    /// Sapphire, the ordinary ray only.
    Sapphire,
    /// The common crown glass.
    NBk7,
    /// A dense flint glass.
    NSf11,
    /// A dense flint glass.
    NSf10,
    /// Fused silica.
    Silica,
    /// Water at 20 C.
    Water,
}

impl BuiltinMaterial {
    /// All of them, in the order in which menus list them.
    pub const ALL: [Self; 8] = [
        Self::Diamond,
        Self::Zirconia,
        Self::Sapphire,
        Self::NBk7,
        Self::NSf11,
        Self::NSf10,
        Self::Silica,
        Self::Water,
    ];

    /// The word on the command line and in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Diamond => "diamond",
            Self::Zirconia => "zirconia",
            Self::Sapphire => "sapphire",
            Self::NBk7 => "n-bk7",
            Self::NSf11 => "n-sf11",
            Self::NSf10 => "n-sf10",
            Self::Silica => "silica",
            Self::Water => "water",
        }
    }

    /// The name that people read.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Diamond => said!("diamond"),
            Self::Zirconia => said!("cubic zirconia"),
            Self::Sapphire => said!("sapphire"),
            Self::NBk7 => said!("N-BK7, crown glass"),
            Self::NSf11 => said!("N-SF11, heavy flint glass"),
            Self::NSf10 => said!("N-SF10, flint glass"),
            Self::Silica => said!("fused silica"),
            Self::Water => said!("water"),
        }
    }

    /// The material of a [`BuiltinMaterial::word`].
    pub(crate) fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|stuff| stuff.word() == word)
    }

    /// Its dispersion.
    pub fn material(self) -> Material {
        match self {
            Self::Diamond => Material::sellmeier(
                later!("diamond"),
                "Peter 1923",
                [226.0, 760.0],
                &squared([[0.3306, 0.1750], [4.3356, 0.1060]]),
            ),
            Self::Zirconia => Material::sellmeier(
                later!("cubic zirconia"),
                "Wood & Nassau 1982, 12 % Y2O3",
                [361.0, 5135.0],
                &squared([
                    [1.347_091, 0.062_543],
                    [2.117_788, 0.166_739],
                    [9.452_943, 24.320_570],
                ]),
            ),
            Self::Sapphire => Material::sellmeier(
                later!("sapphire (ordinary ray)"),
                "Malitson & Dodge 1972",
                [200.0, 5000.0],
                &squared([
                    [1.431_349_3, 0.072_663_1],
                    [0.650_547_13, 0.119_324_2],
                    [5.341_402_1, 18.028_251],
                ]),
            ),
            Self::NBk7 => Material::sellmeier(
                "N-BK7",
                "SCHOTT catalogue 2017",
                [300.0, 2500.0],
                &[
                    [1.039_612_12, 0.006_000_698_67],
                    [0.231_792_344, 0.020_017_914_4],
                    [1.010_469_45, 103.560_653],
                ],
            ),
            Self::NSf11 => Material::sellmeier(
                "N-SF11",
                "SCHOTT catalogue 2017",
                [370.0, 2500.0],
                &[
                    [1.737_596_95, 0.013_188_707],
                    [0.313_747_346, 0.062_306_814_2],
                    [1.898_781_01, 155.236_29],
                ],
            ),
            Self::NSf10 => Material::sellmeier(
                "N-SF10",
                "SCHOTT catalogue 2017",
                [380.0, 2500.0],
                &[
                    [1.621_539_02, 0.012_224_145_7],
                    [0.256_287_842, 0.059_573_677_5],
                    [1.644_475_52, 147.468_793],
                ],
            ),
            Self::Silica => Material::sellmeier(
                later!("fused silica"),
                "Malitson 1965, 20 C",
                [210.0, 3710.0],
                &squared([
                    [0.696_166_3, 0.068_404_3],
                    [0.407_942_6, 0.116_241_4],
                    [0.897_479_4, 9.896_161],
                ]),
            ),
            Self::Water => Material::absolute(
                later!("water"),
                "Daimon & Masumura 2007, 20 C, against vacuum",
                [182.0, 1129.0],
                &[
                    [0.568_402_756_5, 0.005_101_829_712],
                    [0.172_617_739_1, 0.018_211_539_36],
                    [0.020_861_895_78, 0.026_207_222_93],
                    [0.113_074_868_8, 10.697_927_21],
                ],
            ),
        }
    }
}

/// Terms with resonances c as terms with C = c^2.
fn squared<const N: usize>(terms: [[f64; 2]; N]) -> [Term; N] {
    terms.map(|[b, c]| [b, c * c])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_material_is_left_out_of_the_list_of_all() {
        // serde names every variant where a word is none.
        let error = serde_json::from_str::<BuiltinMaterial>("\"\"").expect_err("no word");
        for stuff in BuiltinMaterial::ALL {
            assert!(error.to_string().contains(&format!("`{}`", stuff.word())));
        }
        let named = error.to_string().matches('`').count() / 2 - 1;
        assert_eq!(named, BuiltinMaterial::ALL.len(), "{error}");
    }

    #[test]
    fn words_lead_back_to_their_material() {
        for stuff in BuiltinMaterial::ALL {
            assert_eq!(BuiltinMaterial::from_word(stuff.word()), Some(stuff));
        }
        assert_eq!(BuiltinMaterial::from_word("glass"), None);
    }
}
