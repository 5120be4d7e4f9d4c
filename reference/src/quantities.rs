//! Quantities of one or two models: composition, scalar product, distance.

use crate::brdf::Brdf;
use crate::quadrature::{Accuracy, Estimate, adaptive, hemisphere};
use crate::{Direction, albedo};
use std::f64::consts::TAU;

/// The composition ∫ f₁(L, X) f₂(X, V) cosΘX dω (1.21), in sr⁻¹: light that is reflected
/// by the first model into its whole hemisphere and from there by the second.
///
/// Semi-symmetric: C_{f₁,f₂}(L, V) = C_{f₂,f₁}(V, L) for reciprocal models.
pub fn composition<A: Brdf + ?Sized, B: Brdf + ?Sized>(
    first: &A,
    second: &B,
    l: &Direction,
    v: &Direction,
    accuracy: Accuracy,
) -> Estimate {
    // Polar coordinates about the sharper lobe.
    let (a, b) = (first.chart(l), second.chart(v));
    let (centre, chart) = if a.scale <= b.scale { (l, a) } else { (v, b) };
    hemisphere(
        centre,
        &chart,
        false,
        accuracy,
        &|x, out| {
            first.creases(l, x, out);
            second.creases(x, v, out);
        },
        &|x| first.eval(l, x) * second.eval(x, v),
    )
}

/// The self-composition C_{f,f}, which is a reciprocal, energy-conserving model again.
pub fn self_composition<B: Brdf + ?Sized>(
    brdf: &B,
    l: &Direction,
    v: &Direction,
    accuracy: Accuracy,
) -> Estimate {
    composition(brdf, brdf, l, v, accuracy)
}

/// The scalar product ∫∫ f₁ f₂ cosΘL cosΘV dω dω (5.3.2) of two isotropic models.
pub fn scalar_product<A: Brdf + ?Sized, B: Brdf + ?Sized>(
    first: &A,
    second: &B,
    tolerance: f64,
) -> Estimate {
    product(first, second, tolerance, &|a, b| a * b)
}

/// The distance ‖f₁ − f₂‖ in that scalar product (5.21), integrated from the difference.
pub fn distance<A: Brdf + ?Sized, B: Brdf + ?Sized>(
    first: &A,
    second: &B,
    tolerance: f64,
) -> Estimate {
    let square = product(first, second, tolerance, &|a, b| (a - b) * (a - b));
    let value = square.value.max(0.0).sqrt();
    Estimate {
        value,
        error: if value > 0.0 {
            square.error / (2.0 * value)
        } else {
            square.error.sqrt()
        },
    }
}

/// The scalar product of the albedos, ∫ a₁ a₂ cosΘ dω (5.3.2): equal daylight, no metric.
pub fn albedo_product<A: Brdf + ?Sized, B: Brdf + ?Sized>(
    first: &A,
    second: &B,
    tolerance: f64,
) -> Estimate {
    let accuracy = Accuracy {
        tolerance: (0.02 * tolerance).max(1e-12),
        ..Accuracy::FINE
    };
    let width = first
        .chart(&Direction::NORMAL)
        .scale
        .min(second.chart(&Direction::NORMAL).scale);
    let half = albedo::mean_of(
        &|c| {
            let l = Direction::from_cosine(c, 0.0);
            let a = albedo::directional_albedo_for(first, &l, accuracy);
            let b = albedo::directional_albedo_for(second, &l, accuracy);
            Estimate {
                value: a.value * b.value,
                error: a.error * b.value + b.error * a.value,
            }
        },
        width,
        tolerance,
    );
    half.scaled(0.5 * TAU)
}

fn product<A: Brdf + ?Sized, B: Brdf + ?Sized>(
    first: &A,
    second: &B,
    tolerance: f64,
    combine: &dyn Fn(f64, f64) -> f64,
) -> Estimate {
    let accuracy = Accuracy {
        tolerance: 0.02 * tolerance,
        outer_panels: 200,
        inner_panels: 60,
    };
    adaptive(
        &mut |c| {
            let l = Direction::from_cosine(c, 0.0);
            let (a, b) = (first.chart(&l), second.chart(&l));
            let mut chart = if a.scale <= b.scale {
                a.clone()
            } else {
                b.clone()
            };
            if a.kind == b.kind {
                let other = if a.scale <= b.scale { b } else { a };
                chart = chart.with_edges(&other.edges);
            }
            hemisphere(
                &l,
                &chart,
                first.is_isotropic() && second.is_isotropic(),
                accuracy,
                &|v, out| {
                    first.creases(&l, v, out);
                    second.creases(&l, v, out);
                },
                &|v| combine(first.eval(&l, v), second.eval(&l, v)),
            )
            .scaled(TAU * c)
        },
        &[0.0, 0.1, 1.0],
        tolerance,
        40,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{Lambert, Patch, Phong};
    use std::f64::consts::{FRAC_1_PI, PI};

    #[test]
    fn composed_with_lambert_it_is_the_albedo_over_pi() {
        let (phong, matt) = (Phong::new(15.0).unwrap(), Lambert::grey(1.0).unwrap());
        let (l, v) = (
            Direction::from_degrees(65.0, 0.0),
            Direction::from_degrees(20.0, 70.0),
        );
        let a = crate::directional_albedo(&phong, l.z).value;
        let c = composition(&phong, &matt, &l, &v, Accuracy::FINE);
        assert!((c.value - a * FRAC_1_PI).abs() < 1e-9, "{c:?} {a}");
        let swapped = composition(&matt, &phong, &v, &l, Accuracy::FINE);
        assert!((c.value - swapped.value).abs() < 1e-9, "{c:?} {swapped:?}");
    }

    #[test]
    fn composition_is_semi_symmetric() {
        let (f, g) = (Phong::new(5.0).unwrap(), Phong::new(30.0).unwrap());
        let (l, v) = (
            Direction::from_degrees(50.0, 0.0),
            Direction::from_degrees(30.0, 20.0),
        );
        let a = composition(&f, &g, &l, &v, Accuracy::COARSE).value;
        let b = composition(&g, &f, &v, &l, Accuracy::COARSE).value;
        let c = composition(&g, &f, &l, &v, Accuracy::COARSE).value;
        assert!((a - b).abs() < 1e-6, "{a} {b}");
        assert!((a - c).abs() > 1e-4, "{a} {c}");
    }

    #[test]
    fn norms_and_distances_are_those_of_known_models() {
        let (a, b) = (Lambert::grey(0.9).unwrap(), Lambert::grey(0.4).unwrap());
        // ∫∫ cos cos = π²: ⟨f, g⟩ = ρ₁ρ₂.
        assert!((scalar_product(&a, &b, 1e-10).value - 0.36).abs() < 1e-9);
        assert!((distance(&a, &b, 1e-10).value - 0.5).abs() < 1e-9);
        assert!((albedo_product(&a, &b, 1e-9).value - 0.36 * PI).abs() < 1e-8);
        // A basic patch: f² = c f, so ⟨f, f⟩ = c π A with the mean albedo A.
        let p = Patch::new(1.0).unwrap();
        let mean = 1.0 - 3.0 * 3f64.sqrt() / (4.0 * PI);
        let norm = scalar_product(&p, &p, 1e-8).value;
        assert!((norm - mean).abs() < 1e-7, "{norm} {mean}");
    }

    #[test]
    fn the_scalar_product_follows_from_norms() {
        // (5.22): a·b = (|a + b|² − |a − b|²)/4, here as |a|² + |b|² − |a − b|² = 2 a·b.
        let (a, b) = (Phong::new(3.0).unwrap(), Lambert::grey(0.7).unwrap());
        let t = 1e-8;
        let left = scalar_product(&a, &a, t).value + scalar_product(&b, &b, t).value
            - distance(&a, &b, t).value.powi(2);
        assert!((left - 2.0 * scalar_product(&a, &b, t).value).abs() < 1e-6);
    }
}
