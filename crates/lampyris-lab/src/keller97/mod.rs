//! The figures of Keller's report of 1997.

mod patterns;

pub(crate) use patterns::FIGURE_1;
