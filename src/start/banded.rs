//! Symmetric systems where each unknown meets the three beside it, in a row or round a ring.

/// Unknowns at the end of a ring that meet the beginning: they are solved for last.
const BORDER: usize = 3;

/// A symmetric positive definite matrix of half bandwidth 3; on a ring the last three rows reach round to the first.
pub(super) struct Banded {
    count: usize,
    /// Unknowns of the band proper: all of them, or all but the border.
    inner: usize,
    /// `band[i][d]`: entry (i, i - d).
    band: Vec<[f64; 4]>,
    /// `coupling[i][b]`: entry (inner + b, i).
    coupling: Vec<[f64; BORDER]>,
    corner: [[f64; BORDER]; BORDER],
}

impl Banded {
    /// All zeros; at least four unknowns.
    pub(super) fn new(count: usize, ring: bool) -> Banded {
        let inner = if ring { count - BORDER } else { count };
        Banded {
            count,
            inner,
            band: vec![[0.0; 4]; inner],
            coupling: vec![[0.0; BORDER]; if ring { inner } else { 0 }],
            corner: [[0.0; BORDER]; BORDER],
        }
    }

    /// Adds `importance · w wᵀ`, w being the row with `weights` from column `first` on.
    pub(super) fn add_square(&mut self, first: usize, weights: &[f64; 4], importance: f64) {
        for (a, wa) in weights.iter().enumerate() {
            for (b, wb) in weights.iter().enumerate() {
                let product = importance * wa * wb;
                if product == 0.0 {
                    continue;
                }
                let (i, j) = ((first + a) % self.count, (first + b) % self.count);
                match (i < self.inner, j < self.inner) {
                    (true, true) if i >= j => self.band[i][i - j] += product,
                    (false, true) => self.coupling[j][i - self.inner] += product,
                    (false, false) => self.corner[i - self.inner][j - self.inner] += product,
                    _ => {}
                }
            }
        }
    }

    /// Solves for four right sides at once; `None` if the matrix is not positive definite.
    /// Cholesky on the band, and on what the border's Schur complement is (C - Bᵀ A⁻¹ B).
    pub(super) fn solve(mut self, mut sides: Vec<[f64; 4]>) -> Option<Vec<[f64; 4]>> {
        for i in 0..self.inner {
            for d in (0..=3.min(i)).rev() {
                let j = i - d;
                let mut value = self.band[i][d];
                for k in i.saturating_sub(3)..j {
                    value -= self.band[i][i - k] * self.band[j][j - k];
                }
                if d > 0 {
                    self.band[i][d] = value / self.band[j][0];
                } else if value > 0.0 {
                    self.band[i][0] = value.sqrt();
                } else {
                    return None;
                }
            }
        }
        let mut rest = sides.split_off(self.inner);
        self.down(&mut sides);
        if !rest.is_empty() {
            let mut lower = std::mem::take(&mut self.coupling);
            self.down(&mut lower);
            let mut corner = self.corner;
            for (row, side) in lower.iter().zip(&sides) {
                for b in 0..BORDER {
                    for c in 0..BORDER {
                        corner[b][c] -= row[b] * row[c];
                    }
                    for c in 0..4 {
                        rest[b][c] -= row[b] * side[c];
                    }
                }
            }
            let solved = dense(corner, rest)?;
            for (row, side) in lower.iter().zip(&mut sides) {
                for c in 0..4 {
                    side[c] -= (0..BORDER).map(|b| row[b] * solved[b][c]).sum::<f64>();
                }
            }
            self.up(&mut sides);
            sides.extend(solved);
        } else {
            self.up(&mut sides);
        }
        Some(sides)
    }

    /// L x = sides.
    fn down<const N: usize>(&self, sides: &mut [[f64; N]]) {
        for i in 0..self.inner {
            for c in 0..N {
                let sum: f64 = (1..=3.min(i)).map(|d| self.band[i][d] * sides[i - d][c]).sum();
                sides[i][c] = (sides[i][c] - sum) / self.band[i][0];
            }
        }
    }

    /// Lᵀ x = sides.
    fn up<const N: usize>(&self, sides: &mut [[f64; N]]) {
        for i in (0..self.inner).rev() {
            for c in 0..N {
                let sum: f64 = (1..=3.min(self.inner - 1 - i)).map(|d| self.band[i + d][d] * sides[i + d][c]).sum();
                sides[i][c] = (sides[i][c] - sum) / self.band[i][0];
            }
        }
    }
}

/// Gauss on a few unknowns of a positive definite system.
fn dense(mut matrix: [[f64; BORDER]; BORDER], mut sides: Vec<[f64; 4]>) -> Option<Vec<[f64; 4]>> {
    for i in 0..BORDER {
        if !(matrix[i][i] > 0.0) {
            return None;
        }
        for j in (0..BORDER).filter(|&j| j != i) {
            let share = matrix[j][i] / matrix[i][i];
            for k in 0..BORDER {
                matrix[j][k] -= share * matrix[i][k];
            }
            for c in 0..4 {
                sides[j][c] -= share * sides[i][c];
            }
        }
    }
    for i in 0..BORDER {
        sides[i] = sides[i].map(|x| x / matrix[i][i]);
    }
    Some(sides)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn what_is_solved_solves_it() {
        let mut rng = Rng::new(1, 7);
        for (count, ring) in
            [(4, true), (5, true), (6, true), (7, true), (30, true), (4, false), (9, false), (40, false)]
        {
            let mut system = Banded::new(count, ring);
            let mut matrix = vec![vec![0.0; count]; count];
            for first in 0..if ring { count } else { count - 3 } {
                for _ in 0..4 {
                    let weights = [0; 4].map(|_| rng.range(-1.0, 1.0));
                    system.add_square(first, &weights, 0.7);
                    for a in 0..4 {
                        for b in 0..4 {
                            matrix[(first + a) % count][(first + b) % count] += 0.7 * weights[a] * weights[b];
                        }
                    }
                }
            }
            let sides: Vec<[f64; 4]> = (0..count).map(|_| [0; 4].map(|_| rng.range(-1.0, 1.0))).collect();
            let solved = system.solve(sides.clone()).unwrap();
            for i in 0..count {
                for c in 0..4 {
                    let sum: f64 = (0..count).map(|j| matrix[i][j] * solved[j][c]).sum();
                    assert!((sum - sides[i][c]).abs() < 1e-8, "{count} {ring}");
                }
            }
        }
        assert!(Banded::new(8, true).solve(vec![[1.0; 4]; 8]).is_none());
    }
}
