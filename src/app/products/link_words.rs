//! How thick a glass is and how often it is met, in words.

use super::Link;
use crate::{
    app::ticks::short,
    spectrum::{Band, Kind},
};

impl Link {
    /// Whether it is something that light passes through, and whose thickness can be changed.
    pub fn has_thickness(&self) -> bool {
        self.entry.kind() == Kind::Transmittance
    }

    /// What is to be known of its table on a band, a sentence each: where it ends, and what was
    /// odd about a file of the user's own.
    pub fn remarks(&self, band: Band) -> Vec<String> {
        let spectrum = &self.entry.spectrum;
        let (first, last) = (spectrum.samples.first_nm(), spectrum.samples.last_nm());
        let mut remarks = Vec::new();
        if first > band.min_nm() || last < band.max_nm() {
            remarks.push(tr!(
                "its table covers {first}-{last} nm; beyond that its end values are used.",
                first = short(first),
                last = short(last)
            ));
        }
        if self.entry.shelf().is_none() {
            // The first line of notes says how the file was read, not what is odd about it.
            let odd = spectrum.notes.iter().skip(1);
            remarks.extend(odd.map(|note| format!("{note}.").replace("..", ".")));
        }
        remarks
    }

    /// The thickness that the factor was measured at, mm, where its name says so ("... 2 mm").
    pub fn measured_mm(&self) -> Option<f64> {
        let words: Vec<&str> = self.entry.name().split_whitespace().collect();
        let stated = words.windows(2).rev().find(|pair| pair[1] == "mm")?;
        let mm: f64 = stated[0].parse().ok()?;
        (mm > 0.0 && mm.is_finite()).then_some(mm)
    }

    /// How a light meets it: "off red twice", "through glass 2 mm, 4 mm thick".
    pub fn met(&self) -> String {
        let once = Self {
            bounces: 1,
            ..self.clone()
        };
        let name = once.words();
        match (self.entry.kind(), self.bounces) {
            (Kind::Reflectance, 1) => tr!("off {name}", name),
            (Kind::Reflectance, 2) => tr!("off {name} twice", name),
            (Kind::Reflectance, times) => tr!("off {name} {times} times", name, times),
            (_, 1) => tr!("through {name}", name),
            (_, 2) => tr!("through {name} twice", name),
            (_, times) => tr!("through {name} {times} times", name, times),
        }
    }

    /// Its name, and what was made of it: "red, 3 times", "glass 2 mm, 4 mm thick".
    pub fn words(&self) -> String {
        let mut words = vec![self.entry.name().to_owned()];
        if self.thickness != 1.0 {
            words.push(match self.measured_mm() {
                Some(mm) => tr!("{mm} mm thick", mm = short(mm * self.thickness)),
                None => tr!("{times} times as thick", times = short(self.thickness)),
            });
        }
        if self.bounces != 1 {
            words.push(tr!("{times} times", times = self.bounces));
        }
        words.join(", ")
    }
}

#[cfg(test)]
mod tests {
    use crate::app::products::Products;

    #[test]
    fn a_glass_tells_its_thickness_in_mm_where_its_name_does_and_else_as_a_multiple() {
        let mut links = Products::first().chain;
        let [glass, skin] = &mut links[..] else {
            panic!("two of them")
        };
        assert_eq!((glass.measured_mm(), skin.measured_mm()), (Some(2.0), None));
        assert_eq!(glass.words(), glass.entry.name());
        glass.thickness = 1.5;
        skin.thickness = 2.0;
        skin.bounces = 3;
        assert!(
            glass.words().ends_with("2 mm, 3 mm thick"),
            "{}",
            glass.words()
        );
        assert_eq!(skin.words(), "light skin, 2 times as thick, 3 times");
    }
}
