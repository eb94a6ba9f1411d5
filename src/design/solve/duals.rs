//! Dual variables of an interior-point method, and the share of a step that stays inside.

use nalgebra::DVector;

/// Share of the way to the edge that a step goes at most.
const SHORT_OF_EDGE: f64 = 0.99;

/// A price is at most so many times what the barrier asks, and at least its inverse: wide enough
/// for a step to be Newton's, and no edge is forgotten.
const PRICES_WITHIN: f64 = 1e3;

/// The dual variables: multipliers of the unknowns and of the limits.
pub(super) struct Duals {
    pub(super) unknowns: DVector<f64>,
    pub(super) limits: Option<Vec<f64>>,
}

impl Duals {
    /// Goes along with a step from a place.
    pub(super) fn follow(
        &mut self,
        place: &DVector<f64>,
        step: &DVector<f64>,
        barrier: f64,
        rooms: &[(f64, DVector<f64>)],
    ) {
        let now = &self.unknowns;
        let change = DVector::from_fn(step.len(), |j, _| {
            (barrier - now[j] * step[j]) / place[j] - now[j]
        });
        let part = short_of_zero(now, &change);
        self.unknowns.axpy(part, &change, 1.0);
        let tolls = self.limits.iter_mut().flatten();
        for ((room, rise), toll) in rooms.iter().zip(tolls) {
            let asked = (barrier - *toll * rise.dot(step)) / room;
            *toll = asked.max((1.0 - SHORT_OF_EDGE) * *toll);
        }
    }

    /// Stays near what the barrier itself would ask, or a step forgets the edge.
    pub(super) fn stay_near(&mut self, place: &DVector<f64>, barrier: f64) {
        for (price, room) in self.unknowns.iter_mut().zip(place.iter()) {
            *price = price.clamp(
                barrier / room / PRICES_WITHIN,
                PRICES_WITHIN * barrier / room,
            );
        }
    }
}

/// The share of a step that keeps every number positive, at most 1.
pub(super) fn short_of_zero(from: &DVector<f64>, step: &DVector<f64>) -> f64 {
    let both = from.iter().zip(step.iter()).filter(|(_, s)| **s < 0.0);
    both.map(|(v, s)| -SHORT_OF_EDGE * v / s)
        .fold(1.0, f64::min)
}
