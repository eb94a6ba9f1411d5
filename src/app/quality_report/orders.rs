//! The models of every order of a light, for what its figures are at each.

use std::sync::Arc;

use crate::{
    app::{App, Derived, tables::Tables},
    color::{xyz_of_lines, xyz_of_parts},
    spectrum::{Basis, Composite, Line, Series, numbers_of_order},
};

/// A light taken apart once, from which the model of any order is cut; for a thread of its own.
#[derive(Clone, Debug)]
pub struct ModelsByOrder {
    tables: Arc<Tables>,
    /// Coefficients of the smooth part to the largest order.
    projected: Vec<f64>,
    spikes: Vec<Line>,
    /// XYZ of the smooth part for an exact colour, where that is asked for.
    smooth_target: Option<[f64; 3]>,
}

impl ModelsByOrder {
    /// The models of what the window shows, by its settings but for the order.
    pub fn of(app: &App) -> Self {
        let is_exact = app.document().settings.colour_exact;
        Self::new(app.derived(), app.tables().clone(), is_exact)
    }

    /// The models of what was derived with some tables.
    pub fn new(derived: &Derived, tables: Arc<Tables>, colour_exact: bool) -> Self {
        let (band, weights) = (derived.band, &tables.viewing.weights);
        let (_, spikes) = derived.model.idealised().into_parts();
        let smooth_target = colour_exact.then(|| {
            let whole = xyz_of_parts(band, &derived.measured, &[], weights);
            (whole - xyz_of_lines(&spikes, weights)).to_array()
        });
        let basis = &tables.basis;
        let projected = basis.project(&derived.parts.smooth, basis.numbers());
        Self {
            projected,
            tables,
            spikes,
            smooth_target,
        }
    }

    /// The largest order there is.
    pub fn highest_order(&self) -> usize {
        let of_band = Basis::highest_order(self.tables.band());
        of_band.min((self.projected.len() - 1) / 2)
    }

    /// The model of an order; of the largest one above it.
    pub fn model(&self, order: usize) -> Composite {
        let numbers = numbers_of_order(order).min(self.projected.len());
        let mut coefficients = self.projected[..numbers].to_vec();
        if let Some(target) = self.smooth_target {
            // Too few numbers for an exact colour stay as they are.
            let _ = self.tables.colour.make_exact(&mut coefficients, target);
        }
        Composite::of_lines_inside(
            Series {
                band: self.tables.band(),
                basis: self.tables.basis.basis(),
                coefficients,
            },
            self.spikes.clone(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{Command, Settings},
        color::quality::Light,
        study::{
            Progress,
            quality::{Chosen, figures_against_order},
        },
    };

    #[test]
    fn the_model_of_an_order_is_the_one_that_is_shown_at_it() {
        for colour_exact in [false, true] {
            let mut app = App::new();
            let settings = Settings {
                colour_exact,
                ..app.document().settings
            };
            app.apply(Command::Edit(settings));
            let models = ModelsByOrder::of(&app);
            assert_eq!(models.highest_order(), 40);
            for order in [0, 1, 7, 40] {
                app.apply(Command::Edit(Settings { order, ..settings }));
                assert_eq!(models.model(order), app.derived().model, "{order}");
            }
        }
    }

    #[test]
    fn figures_against_order_come_to_rest() {
        let app = App::new();
        let models = ModelsByOrder::of(&app);
        let light = Light::of_sampled(&app.document().light.spectrum.samples);
        let light = light.within(app.derived().band);
        let highest = models.highest_order();
        let found = figures_against_order(
            &light,
            highest,
            |order| models.model(order),
            &Progress::default(),
        );
        let found = found.expect("nobody cancels it");
        assert_eq!(found.points.len(), highest + 1);
        for chosen in Chosen::ALL {
            assert!(found.settled_from(chosen).is_some(), "{chosen:?}");
        }
    }
}
