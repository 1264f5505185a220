//! Spans of distances along a ray.

/// A span of distances along a ray that count: open at zero, closed at its bounds.
///
/// Comparisons put not-a-number outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    min: f64,
    max: f64,
}

impl Span {
    /// Everything ahead of the origin.
    pub const AHEAD: Self = Self {
        min: 0.0,
        max: f64::MAX,
    };

    /// The largest distance that counts.
    #[must_use]
    pub fn max(self) -> f64 {
        self.max
    }

    /// Returns whether a hit at distance `t` counts.
    #[must_use]
    pub fn contains(self, t: f64) -> bool {
        t > 0.0 && t >= self.min && t <= self.max
    }

    /// Returns whether a hit at distance `t` counts, which may be nearer by `error`.
    ///
    /// The nearest hit is then not lost because another has a smaller error.
    #[must_use]
    pub fn admits(self, t: f64, error: f64) -> bool {
        t > 0.0 && t >= self.min && t - error <= self.max && t <= f64::MAX
    }

    /// The part up to distance `t`.
    #[must_use]
    pub fn until(self, t: f64) -> Self {
        Self {
            max: self.max.min(t),
            ..self
        }
    }

    /// The part from distance `t` on.
    #[must_use]
    pub fn since(self, t: f64) -> Self {
        Self {
            min: self.min.max(t),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_excludes_its_origin_and_nonsense() {
        let span = Span::AHEAD.until(2.0).since(1.0);
        assert!(span.contains(1.0) && span.contains(2.0));
        assert!(!span.contains(0.5) && !span.contains(f64::NAN) && !span.contains(f64::INFINITY));
        assert!(!Span::AHEAD.contains(0.0) && Span::AHEAD.contains(5e-324));
    }
}
