//! The transfer function of IEC 61966-2-1 for bytes, by a table that the compiler works out.

/// Linear value of a byte.
pub fn linear(byte: u8) -> f32 {
    TABLE[usize::from(byte)]
}

static TABLE: [f32; 256] = {
    let mut table = [0.0; 256];
    let mut byte = 0;
    while byte < 256 {
        let v = byte as f64 / 255.0;
        let linear = if v <= 0.04045 { v / 12.92 } else { power_12_5((v + 0.055) / 1.055) };
        table[byte] = linear as f32;
        byte += 1;
    }
    table
};

/// x^2.4 for x in (0, 1], by Newton's method for y⁵ = x¹², from above.
const fn power_12_5(x: f64) -> f64 {
    let x4 = (x * x) * (x * x);
    let x12 = x4 * x4 * x4;
    let mut y = x * x;
    let mut step = 0;
    while step < 64 {
        let y4 = (y * y) * (y * y);
        y -= (y * y4 - x12) / (5.0 * y4);
        step += 1;
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_the_standard() {
        for byte in 0..=255u8 {
            let v = f64::from(byte) / 255.0;
            let exact = if v <= 0.04045 { v / 12.92 } else { libm::pow((v + 0.055) / 1.055, 2.4) };
            assert!((f64::from(linear(byte)) - exact).abs() <= exact * 6e-8, "{byte}: {exact}");
        }
        assert_eq!((linear(0), linear(255)), (0.0, 1.0));
    }
}
