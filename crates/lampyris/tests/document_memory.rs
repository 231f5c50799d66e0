//! Saved documents that mean harm by their size: reading holds no more than is said here for each of their bytes, and is quick.
//! One test in a binary of its own, because its allocator counts for the whole process.

use lampyris::document::Document;
use lampyris::import::Limits;
use peak_alloc::PeakAlloc;
use std::path::Path;
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Text by number.
type Item = Box<dyn Fn(usize) -> String>;

/// Bytes of memory for each byte of a file; an object of one field takes most.
const EACH: usize = 128;

#[test]
fn floods_take_little() {
    let numbered = |k: usize| format!("\"{k}\": {{}}");
    let floods: [(&str, &str, Item, &str); 9] = [
        ("objects", "\"desk\": [", Box::new(|_| "{\"\":0}".into()), "]"),
        ("lists", "\"desk\": [", Box::new(|_| "[]".into()), "]"),
        ("keys", "\"desk\": {", Box::new(|k| format!("\"{k}\":0")), "}"),
        ("lights", "\"lights\": {", Box::new(numbered), "}"),
        ("things", "\"objects\": {", Box::new(numbered), "}"),
        ("materials", "\"materials\": {", Box::new(numbered), "}"),
        ("emitters", "\"emitters\": [", Box::new(|_| "{\"share\":0}".into()), "]"),
        (
            "groups",
            "\"groups\": [",
            Box::new(|_| "{\"name\":\"\",\"color\":{\"r\":1,\"g\":1,\"b\":1}}".into()),
            "]",
        ),
        ("opened", "\"desk\": ", Box::new(|_| "[".into()), ""),
    ];
    for (name, before, item, after) in floods {
        let separator = if after.is_empty() { "" } else { "," };
        let items: Vec<String> = (0..200_000).map(item).collect();
        let text = format!("{{\"lampyris\": 1, {before}{}{after}}}", items.join(separator));
        drop(items);
        let held = MEMORY.current_usage();
        MEMORY.reset_peak_usage();
        let start = Instant::now();
        let read = Document::read(Path::new("a.lampyris.json"), text.as_bytes(), &Limits::default());
        let (took, peak) = (start.elapsed(), MEMORY.peak_usage().saturating_sub(held));
        drop(read);
        assert!(peak <= EACH * text.len(), "{name}: {} bytes a byte", peak / text.len());
        assert!(took < Duration::from_secs(5), "{name}: {took:?}");
    }
}
