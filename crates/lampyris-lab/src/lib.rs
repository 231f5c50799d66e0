//! The laboratory: what the papers claim in tables and figures, computed here and set beside it.
//!
//! An [`Experiment`] is a row of one closed table, [`ALL`]: paper, place, claim, and a function that measures. What it yields are
//! [`Findings`], plain data; a [`Report`] is the folder that they are written to, each experiment when it is done, and the page
//! that is put together of those that are there. docs/laboratory.md says how to add one.

mod artifacts;
mod convergence;
mod effort;
mod error;
mod experiment;
mod findings;
mod jarosz05;
mod keller96;
mod keller97;
mod page;
mod plot;
mod record;
mod report;
mod seen;
mod slides;
mod stage;
mod statistics;
mod table;
mod wald02;

pub use effort::Effort;
pub use error::{Error, Result};
pub use experiment::Experiment;
pub use findings::{Comparison, Demand, Exhibit, Findings, Image, Table};
pub use plot::{Axis, Mark, Plot, Series};
pub use report::{Measured, Report};
pub use table::{ALL, select};
pub use wald02::workload;
