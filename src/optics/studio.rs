//! A body of a material in a scene, ready to be looked at.

use super::{
    absorption::Absorption,
    chain::{Ending, Stage, Traced, Work},
    index::Material,
    index_error::IndexError,
    lanes::Start,
    scene::{Camera, Scene, SceneError},
    solid::Solid,
};

/// Everything that decides what a camera sees, but for the light.
#[derive(Clone, Debug)]
pub struct Studio {
    solid: Solid,
    material: Material,
    absorption: Absorption,
    scene: Scene,
    camera: Camera,
    fast: Stage<f32>,
}

/// Result of one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Radiance, under light of radiance 1.
    pub radiance: f64,
    /// Weight that was cut at the most faces.
    pub cut: f64,
    /// Faces met from inside; 0 beside the body.
    pub faces: u64,
}

/// Why there is nothing to look at.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StudioError {
    /// The scene is invalid.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The material is transparent nowhere between 380 and 780 nm.
    #[error(transparent)]
    Index(#[from] IndexError),
}

impl Studio {
    /// Puts a body into a scene.
    ///
    /// # Errors
    /// [`StudioError`] when the scene is not in order, or the material has no index at any whole
    /// nm of 380-780.
    pub fn new(
        solid: Solid,
        material: Material,
        absorption: Absorption,
        scene: Scene,
    ) -> Result<Self, StudioError> {
        let camera = scene.camera(&solid)?;
        if (380..=780).all(|nm| material.index(f64::from(nm)).is_err()) {
            // That it is a metal says more than that a table ends.
            let mut errors = (380..=780).filter_map(|nm| material.index(f64::from(nm)).err());
            if let Some(error) = errors.find(IndexError::is_opaque) {
                return Err(error.into());
            }
            material.index(780.0)?;
        }
        let fast = Stage::new(&solid, &scene, &camera, Ending::default());
        Ok(Self {
            solid,
            material,
            absorption,
            scene,
            camera,
            fast,
        })
    }

    /// The body's material.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// The body's absorption.
    pub fn absorption(&self) -> &Absorption {
        &self.absorption
    }

    /// The surroundings of the body.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    pub(super) fn fast(&self) -> &Stage<f32> {
        &self.fast
    }

    /// Index and absorption at a wavelength; `None` where the material is not known.
    pub(super) fn optics_at(&self, at_nm: f64) -> Option<[f64; 2]> {
        let index = self.material.index(at_nm).ok()?;
        Some([index, self.absorption.at(at_nm)])
    }

    /// True if the ray through a film point meets the body.
    pub(crate) fn meets(&self, film: [f64; 2]) -> bool {
        self.fast.meets(self.camera.direction(film))
    }

    /// One ray through a film point (from -1 to 1, to the right and upward) in double precision,
    /// for light of radiance 1 at a wavelength.
    ///
    /// # Errors
    /// [`IndexError`] where the material has no index.
    pub fn look(&self, film: [f64; 2], at_nm: f64, ending: Ending) -> Result<Seen, IndexError> {
        let index = self.material.index(at_nm)?;
        Ok(self.look_through(film, index, self.absorption.at(at_nm), ending))
    }

    /// As [`Studio::look`], for any index from 1 and any absorption a unit of length.
    pub(crate) fn look_through(
        &self,
        film: [f64; 2],
        index: f64,
        absorption: f64,
        ending: Ending,
    ) -> Seen {
        let stage = Stage::<f64>::new(&self.solid, &self.scene, &self.camera, ending);
        let direction = self.camera.direction(film);
        let start = match stage.begin(film, direction, [index, absorption], 1, 0) {
            Ok(start) => start,
            Err(radiance) => {
                return Seen {
                    radiance,
                    cut: 0.0,
                    faces: 0,
                };
            }
        };
        let mut one = One {
            start: Some(start),
            found: 0.0,
        };
        let mut traced = Traced::default();
        stage.follow(&mut one, &mut traced);
        Seen {
            radiance: one.found,
            cut: traced.cut_weight,
            faces: traced.segments,
        }
    }
}

/// A single chain.
struct One {
    start: Option<Start<f64>>,
    found: f64,
}

impl Work<f64> for One {
    fn next(&mut self) -> Option<Start<f64>> {
        self.start.take()
    }

    fn done(&mut self, _: u32, radiance: f64) {
        self.found = radiance;
    }
}
