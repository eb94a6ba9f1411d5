//! The race as charts.
