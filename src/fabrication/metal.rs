//! What wire is made of, and how it bends.

use serde::Serialize;
use std::f64::consts::{FRAC_PI_2, PI};

/// A metal that wire can be bought in, soft enough for hands.
///
/// | metal | as bought | density, g/cm³ | elongation | E, GPa | K, MPa | n |
/// |---|---|---|---|---|---|---|
/// | copper | C11000, annealed | 8.89 | 45% | 115 | 315 | 0.54 |
/// | aluminium | 1350 or 1100, annealed | 2.70 | 23% | 69 | 180 | 0.20 |
/// | steel | AISI 1010, low in carbon | 7.87 | 28% | 200 | 530 | 0.26 |
///
/// Density, elongation at break and Young's modulus E: ASM Handbook, volumes 1 and 2. K and n of the flow curve
/// σ = K εⁿ: Kalpakjian and Schmid, *Manufacturing Engineering and Technology*, table of strength coefficients.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Metal {
    /// Soft and heavy: the easiest to bend.
    #[default]
    Copper,
    /// Light; springs back the most, and cracks in tight bends.
    Aluminium,
    /// The stiffest: hard work for hands when it is thick.
    Steel,
}

struct Properties {
    density_g_per_cm3: f64,
    elongation: f64,
    young_mpa: f64,
    strength_mpa: f64,
    hardening: f64,
}

impl Metal {
    /// All of them.
    pub const ALL: [Metal; 3] = [Metal::Copper, Metal::Aluminium, Metal::Steel];

    /// Where the numbers are from, for who is told them.
    pub const SOURCE: &str = "ASM Handbook, volumes 1 and 2 (density, elongation, stiffness); Kalpakjian and Schmid, Manufacturing \
                              Engineering and Technology (flow curves; least bend radius from elongation)";

    /// As people write it.
    pub fn name(self) -> &'static str {
        match self {
            Metal::Copper => "copper",
            Metal::Aluminium => "aluminium",
            Metal::Steel => "steel",
        }
    }

    /// The metal of that name.
    pub fn named(name: &str) -> Option<Metal> {
        Metal::ALL.into_iter().find(|metal| metal.name() == name)
    }

    fn properties(self) -> Properties {
        let [density_g_per_cm3, elongation, young_mpa, strength_mpa, hardening] = match self {
            Metal::Copper => [8.89, 0.45, 115e3, 315.0, 0.54],
            Metal::Aluminium => [2.70, 0.23, 69e3, 180.0, 0.20],
            Metal::Steel => [7.87, 0.28, 200e3, 530.0, 0.26],
        };
        Properties { density_g_per_cm3, elongation, young_mpa, strength_mpa, hardening }
    }

    /// Least radius at the inside of a bend, as a multiple of the diameter d: where the outermost fibre is stretched as far as
    /// the metal bears. Its strain is 1 / (2 R/d + 1) (Kalpakjian and Schmid, bending of sheet and rod).
    pub fn least_inside_radius(self) -> f64 {
        0.5 * (1.0 / self.properties().elongation - 1.0)
    }

    /// Least radius of the wire's centre line, mm, for a gauge in mm.
    pub fn least_radius_mm(self, gauge_mm: f64) -> f64 {
        (self.least_inside_radius() + 0.5) * gauge_mm
    }

    /// Mass in grams of so much wire.
    pub fn mass_g(self, length_mm: f64, gauge_mm: f64) -> f64 {
        self.properties().density_g_per_cm3 * 1e-3 * length_mm * 0.25 * PI * gauge_mm * gauge_mm
    }

    /// How much farther to bend than a bend of `radius_mm` (of the centre line) is to be: its angle times this, 1 or more.
    ///
    /// Spring-back takes M / (E I) off a curvature κ, where M is the moment of σ = K (κ y)ⁿ over the round section: for
    /// radius r, (K / E) (κ r)ⁿ 4 j / (π r) with j = 4 ∫ sinⁿ⁺¹φ cos²φ dφ over a right angle (bending theory with a hardening metal, after
    /// Hosford and Caddell, *Metal Forming*).
    pub fn overbend(self, radius_mm: f64, gauge_mm: f64) -> f64 {
        let Properties { young_mpa, strength_mpa, hardening: n, .. } = self.properties();
        let (wanted, r) = (1.0 / radius_mm, 0.5 * gauge_mm);
        let lost = |curvature: f64| strength_mpa / young_mpa * (curvature * r).powf(n) * 4.0 * shape(n) / (PI * r);
        // The right side grows slower than the left, so this comes to rest.
        let mut bent = wanted;
        for _ in 0..60 {
            bent = wanted + lost(bent);
        }
        bent / wanted
    }
}

/// 4 ∫ sinⁿ⁺¹φ cos²φ dφ over a right angle, by Simpson's rule.
fn shape(n: f64) -> f64 {
    const STEPS: usize = 32;
    let at = |i: usize| {
        let (sin, cos) = (FRAC_PI_2 * i as f64 / STEPS as f64).sin_cos();
        sin.powf(n + 1.0) * cos * cos
    };
    let weight = |i: usize| if i.is_multiple_of(STEPS) { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
    4.0 * FRAC_PI_2 / (3.0 * STEPS as f64) * (0..=STEPS).map(|i| weight(i) * at(i)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn soft_metals_bend_tighter_and_spring_back_less() {
        let [copper, aluminium, steel] = Metal::ALL.map(Metal::least_inside_radius);
        assert!(copper < steel && steel < aluminium, "{copper} {aluminium} {steel}");
        assert!((Metal::Copper.least_radius_mm(2.0) - 2.0 * (0.611 + 0.5)).abs() < 1e-2);
        let over = Metal::ALL.map(|metal| metal.overbend(10.0, 1.6));
        assert!(over[0] < over[2] && over[2] < over[1], "{over:?}");
        assert!((1.005..1.03).contains(&over[0]), "{over:?}");
        for metal in Metal::ALL {
            assert!(metal.overbend(100.0, 1.6) > metal.overbend(10.0, 1.6), "gentle bends spring back more");
            assert!(metal.overbend(1e6, 1.6).is_finite());
            assert_eq!(Metal::named(metal.name()), Some(metal));
        }
        assert_eq!(Metal::named("gold"), None);
    }

    #[test]
    fn a_metal_that_does_not_harden_has_the_plastic_moment() {
        // d³/6 over π d⁴/64, as for a section that yields everywhere: j = 4/3.
        assert!((shape(0.0) - 4.0 / 3.0).abs() < 1e-5);
        // An elastic one loses all its curvature: j = π/4.
        assert!((shape(1.0) - PI / 4.0).abs() < 1e-9);
    }

    #[test]
    fn a_metre_of_copper_weighs_what_it_weighs() {
        assert!((Metal::Copper.mass_g(1000.0, 1.6) - 17.87).abs() < 0.01);
    }
}
