//! How many of all measured surfaces that ship tell a model from its light.

use super::{derived::Derived, tables::Tables, ticks::short, verdicts::HARD_TO_SEE};
use crate::{
    color::{
        Lab, delta_e_2000,
        patches::{difference, labs_into},
    },
    languages::fixed,
};

/// How many of all measured surfaces tell a model from its light.
#[derive(Clone, Debug, PartialEq)]
pub struct Surfaces {
    /// How many there are.
    pub count: usize,
    /// Those whose colours differ by 1 (CIEDE2000) or more.
    pub beyond_1: usize,
    /// The largest CIEDE2000.
    pub delta_e_max: f64,
    /// The surface that has it.
    pub worst: String,
}

impl Surfaces {
    /// Of the present model of a light, products at 1 nm; `None` where there are no patches to see.
    pub(super) fn of(derived: &Derived, tables: &Tables) -> Option<Self> {
        derived.patches.as_ref()?;
        let set = tables.surfaces();
        let white = set.white_xyz(&derived.measured);
        let (mut exact, mut model) = (set.buffer(), set.buffer());
        set.xyz_into(&derived.measured, &mut exact);
        set.xyz_into(&derived.outline(), &mut model);
        for spike in derived.ideal_spikes() {
            set.add_line(spike.at_nm, spike.weight, &mut model);
        }
        let [exact, model] = [exact, model].map(|xyz| {
            let mut labs = vec![Lab::new(0.0, 0.0, 0.0); xyz.len()];
            labs_into(&xyz, white, &mut labs);
            labs
        });
        let beyond = |(a, b): &(&Lab, &Lab)| delta_e_2000(**a, **b) >= HARD_TO_SEE;
        let found = difference(&exact, &model);
        Some(Self {
            count: set.len(),
            beyond_1: exact.iter().zip(&model).filter(beyond).count(),
            delta_e_max: found.max,
            worst: set.names()[found.worst].clone(),
        })
    }

    /// The same without the surface that differs most.
    pub fn brief(&self) -> String {
        format!("{}.", self.clause())
    }

    /// A sentence: "Of 401 measured surfaces 12 differ by 1 or more, at most 2.19 (CES81)."
    pub fn sentence(&self) -> String {
        format!("{} ({}).", self.clause(), self.worst)
    }

    fn clause(&self) -> String {
        let (count, hard) = (self.count, short(HARD_TO_SEE));
        let most = fixed(self.delta_e_max, 2);
        match self.beyond_1 {
            0 => tr!(
                "Of {n} measured surface none differs by ΔE₀₀ {hard} or more, at most {most}"
                    | "Of {n} measured surfaces none differs by ΔE₀₀ {hard} or more, at most {most}"
                        % count,
                hard,
                most
            ),
            1 => tr!(
                "Of {n} measured surface 1 differs by ΔE₀₀ {hard} or more, at most {most}"
                    | "Of {n} measured surfaces 1 differs by ΔE₀₀ {hard} or more, at most {most}"
                        % count,
                hard,
                most
            ),
            several => tr!(
                "Of {n} measured surface {several} differ by ΔE₀₀ {hard} or more, at most {most}"
                    | "Of {n} measured surfaces {several} differ by ΔE₀₀ {hard} or more, at most \
                       {most}"
                        % count,
                several,
                hard,
                most
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::app::{App, Command, Settings};

    #[test]
    fn the_patches_among_them_differ_as_the_patches_of_the_document_do() {
        let mut app = App::new();
        for order in [3, 7, 20] {
            let settings = Settings {
                order,
                ..app.document().settings
            };
            app.apply(Command::Edit(settings));
            let patches = app.derived().patches.as_ref().expect("a light").clone();
            let found = app.surfaces().expect("a light").clone();
            assert!(found.delta_e_max >= patches.max - 1e-6, "{order}");
            let beyond = patches.items.iter().filter(|p| p.delta_e_2000 >= 1.0);
            assert!(found.beyond_1 >= beyond.count(), "{order}");
            assert!(found.beyond_1 < found.count || order == 3);
            assert_eq!(found.beyond_1 == 0, found.delta_e_max < 1.0);
        }
    }
}
