//! Figures against order: what a few more numbers do to Ra, Rf, CCT and the melanopic ratio.

use crate::{
    color::quality::{FewFigures, Light},
    spectrum::Composite,
    study::Progress,
};

/// The figures of the model of one order.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderPoint {
    /// Order N.
    pub order: usize,
    /// Numbers that the model takes.
    pub numbers: usize,
    /// Its figures.
    pub figures: FewFigures,
}

/// Figures against order, and those of the light itself.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderFigures {
    /// The exact values, drawn as lines.
    pub exact: FewFigures,
    /// Rising order.
    pub points: Vec<OrderPoint>,
}

/// One of the figures that are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Chosen {
    /// Ra of CRI.
    Ra,
    /// Rf of TM-30.
    Rf,
    /// Correlated colour temperature, K.
    Cct,
    /// Melanopic daylight efficacy ratio.
    MelanopicDer,
}

impl Chosen {
    /// All four.
    pub(crate) const ALL: [Self; 4] = [Self::Ra, Self::Rf, Self::Cct, Self::MelanopicDer];

    /// Title of the curve.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Ra => "Ra",
            Self::Rf => "Rf",
            Self::Cct => "CCT",
            Self::MelanopicDer => later!("melanopic DER"),
        }
    }

    /// The value, where there is one.
    pub(crate) fn of(self, figures: &FewFigures) -> Option<f64> {
        match self {
            Self::Ra => figures.ra.as_ref().ok().copied(),
            Self::Rf => figures.rf.as_ref().ok().copied(),
            Self::Cct => figures.cct.as_ref().ok().map(|cct| cct.kelvin),
            Self::MelanopicDer => figures.melanopic_der.as_ref().ok().copied(),
        }
    }

    /// Tolerance within which the exact value counts as reached: half a point of an index; half a
    /// per cent of the CCT and half a hundredth of the ratio, for which a point would mean nothing.
    pub(crate) fn near_enough(self, exact: f64) -> f64 {
        match self {
            Self::Ra | Self::Rf => 0.5,
            Self::Cct => 0.005 * exact.abs(),
            Self::MelanopicDer => 0.005,
        }
    }
}

impl OrderFigures {
    /// The least order from which on every larger one is near enough to the exact value; `None`
    /// when the last is not, or there is no exact value. Errors do not fall steadily: an order
    /// that is near by chance, with worse ones above it, does not count.
    pub(crate) fn settled_from(&self, chosen: Chosen) -> Option<usize> {
        let near = self.near(chosen)?;
        let last_off = near.iter().rposition(|near| !near);
        let first = last_off.map_or(0, |index| index + 1);
        self.points.get(first).map(|point| point.order)
    }

    /// The least order that is near enough, whatever larger ones do.
    #[cfg(test)]
    pub(crate) fn least_within(&self, chosen: Chosen) -> Option<usize> {
        let near = self.near(chosen)?;
        let first = near.iter().position(|near| *near)?;
        self.points.get(first).map(|point| point.order)
    }

    fn near(&self, chosen: Chosen) -> Option<Vec<bool>> {
        let exact = chosen.of(&self.exact)?;
        let within = chosen.near_enough(exact);
        let is_near = |point: &OrderPoint| {
            let value = chosen.of(&point.figures);
            value.is_some_and(|value| (value - exact).abs() <= within)
        };
        Some(self.points.iter().map(is_near).collect())
    }
}

/// The figures of `model(N)` for the orders 0 to `highest_order`, beside those of the light.
/// `None` when cancelled.
///
/// Pass the light [`Light::within`] the model's band to see the model alone, or the whole light to
/// see the band's share of the error too.
pub fn figures_against_order(
    light: &Light,
    highest_order: usize,
    model: impl Fn(usize) -> Composite,
    progress: &Progress,
) -> Option<OrderFigures> {
    progress.expect(highest_order + 1);
    let mut points = Vec::with_capacity(highest_order + 1);
    for order in 0..=highest_order {
        if progress.is_cancelled() {
            return None;
        }
        let model = model(order);
        points.push(OrderPoint {
            order,
            numbers: model.numbers(),
            figures: FewFigures::of(&Light::of_composite(&model)),
        });
        progress.step();
    }
    Some(OrderFigures {
        exact: FewFigures::of(light),
        points,
    })
}
