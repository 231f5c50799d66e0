//! The theorems of `polygon`.
