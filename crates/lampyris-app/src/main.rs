//! The program `lampyris`.

fn main() {}
