//! How much memory the process has used at most.

/// Peak resident memory [bytes], where the system tells it.
pub(crate) fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<u64>().ok().map(|kib| kib * 1024)
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    #[test]
    fn touched_memory_counts() {
        let before = super::peak().unwrap();
        let block = vec![1u8; 64 << 20];
        assert!(super::peak().unwrap() >= block.len() as u64);
        assert!(before > 0);
    }
}
