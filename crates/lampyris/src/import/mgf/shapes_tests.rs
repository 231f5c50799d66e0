//! The theorems of `shapes`.
