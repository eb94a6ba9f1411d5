//! Studies of light quality: many lights at once, and figures against the order of a model.

mod many;
mod order;

pub use many::figures_of_many;
pub use order::figures_against_order;
pub(crate) use order::{Chosen, OrderFigures};
