//! The gem's picture as a file.

use crate::{
    app::memo::ByAddress,
    io::with_attributes_in_order,
    optics::{Light, png, spectral_exr},
};

use super::{
    gem::GemFilm,
    gem_shown::{GemLook, GemShown},
};

/// As what a picture is saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GemForm {
    /// As the screen shows it.
    Png,
    /// Every plane of wavelengths and every line, as numbers.
    Exr,
}

/// A picture of a gem to be saved.
#[derive(Clone, Debug, PartialEq)]
pub struct GemFile {
    pub film: ByAddress<GemFilm>,
    pub light: Light,
    pub look: GemLook,
    pub form: GemForm,
}

impl GemFile {
    pub fn extension(&self) -> &'static str {
        match self.form {
            GemForm::Png => "png",
            GemForm::Exr => "exr",
        }
    }

    /// A name made of gem and light.
    pub fn file_name(&self) -> String {
        let material = &self.film.0.film.studio().material().name;
        let words = format!("{material} under {}", self.light.name);
        let letters = words.chars();
        let stem: String = letters
            .map(|c| if c.is_alphanumeric() { c } else { '-' })
            .collect();
        format!("{stem}.{}", self.extension())
    }

    /// The file.
    ///
    /// # Errors
    /// Why it cannot be made, in words.
    pub fn bytes(&self) -> Result<Vec<u8>, String> {
        let GemFilm { film, pass, .. } = &*self.film.0;
        match self.form {
            GemForm::Png => {
                let shown = GemShown::of(&self.film.0, &self.light, self.look)?;
                png([shown.size; 2], &shown.pixels).ok_or_else(|| "There is no picture.".to_owned())
            }
            GemForm::Exr => {
                let facts = [
                    ("light", self.light.name.clone()),
                    ("gem", film.studio().material().name.clone()),
                    ("cut", format!("{:?}", pass.scene.cut())),
                    ("view", format!("{:?}", film.studio().scene().view)),
                    ("rays", pass.rays.to_string()),
                ];
                spectral_exr(film, &self.light, &facts)
                    .map(with_attributes_in_order)
                    .map_err(|why| format!("{why}."))
            }
        }
    }
}
