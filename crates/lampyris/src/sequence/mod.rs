//! Low-discrepancy sequences as pure functions of (index, dimension, seed): no sampler object, no order of calls.
