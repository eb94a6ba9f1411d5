//! Accuracy against numbers: how far a model is from what it stands for.

pub mod error;
