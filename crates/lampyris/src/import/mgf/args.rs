//! Arguments of MGF entities as numbers: C syntax, finite, or an error that says what was expected.

use crate::import::report::quote;

/// Why an entity is refused; the reader adds file and line.
pub(super) type Reason<T> = Result<T, String>;

/// A finite number.
pub(super) fn number(word: &str) -> Reason<f64> {
    // Rust reads "inf" and "nan", which the format does not know.
    match word.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("{} is not a number", quote(word))),
    }
}

/// Exactly `N` numbers after the keyword.
pub(super) fn numbers<const N: usize>(keyword: &str, words: &[&str]) -> Reason<[f64; N]> {
    let words: &[&str; N] = exactly(keyword, words)?;
    let mut values = [0.0; N];
    for (value, word) in values.iter_mut().zip(words) {
        *value = number(word)?;
    }
    Ok(values)
}

/// Exactly `N` words after the keyword.
pub(super) fn exactly<'a, 'b, const N: usize>(
    keyword: &str,
    words: &'b [&'a str],
) -> Reason<&'b [&'a str; N]> {
    words.try_into().map_err(|_| {
        let plural = if N == 1 { "" } else { "s" };
        format!("{} takes {N} argument{plural}, found {}", quote(keyword), words.len())
    })
}
