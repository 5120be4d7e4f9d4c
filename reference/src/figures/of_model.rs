//! Curves of any model: albedo, lobe, reflected radiance.

use super::curve;
use crate::albedo::directional_albedo_for;
use crate::quadrature::Accuracy;
use crate::{Brdf, Direction};

/// A hundredth of a pixel's height in a picture.
const ACCURACY: Accuracy = Accuracy {
    tolerance: 1e-5,
    ..Accuracy::COARSE
};

/// The direction in the plane of incidence at `degrees` from the normal, −90 … 90:
/// above 0 on the side of the mirror direction, opposite the light.
pub fn in_plane(degrees: f64) -> Direction {
    Direction::from_degrees(degrees.abs(), if degrees < 0.0 { 0.0 } else { 180.0 })
}

/// a(Θ) over the angle of incidence in degrees, 0 … 90.
///
/// `tolerance` (here and below) is how far, in y, the middle between two points may
/// lie off their line.
pub fn albedo<B: Brdf + ?Sized>(model: &B, tolerance: f64) -> Vec<(f64, f64)> {
    curve(&[0.0, 90.0], tolerance, &mut |degrees| {
        let l = Direction::from_degrees(degrees, 0.0);
        directional_albedo_for(model, &l, ACCURACY).value
    })
}

/// a(Θ) over the elevation 90° − Θ in degrees, from `from` down to `to` (both above 0),
/// at points that are evenly spread over its logarithm.
pub fn albedo_near_the_horizon<B: Brdf + ?Sized>(
    model: &B,
    from: f64,
    to: f64,
    tolerance: f64,
) -> Vec<(f64, f64)> {
    let points = curve(&[from.log10(), to.log10()], tolerance, &mut |power| {
        let l = Direction::from_cosine(10f64.powf(power).to_radians().sin(), 0.0);
        directional_albedo_for(model, &l, ACCURACY).value
    });
    points
        .into_iter()
        .map(|(p, a)| (10f64.powf(p), a))
        .collect()
}

/// f(L, V) in sr⁻¹ over the viewing angle of [`in_plane`], L at `incidence` degrees (0 … 90).
pub fn lobe<B: Brdf + ?Sized>(model: &B, incidence: f64, tolerance: f64) -> Vec<(f64, f64)> {
    over_viewing_angles(incidence, tolerance, &|l, v| model.eval(l, v))
}

/// f(L, V) cosΘL in sr⁻¹ over the viewing angle: the radiance that a light of normal
/// irradiance 1 at `incidence` degrees leaves.
pub fn radiance<B: Brdf + ?Sized>(model: &B, incidence: f64, tolerance: f64) -> Vec<(f64, f64)> {
    over_viewing_angles(incidence, tolerance, &|l, v| {
        crate::brdf::luminance(model.reflect(l, v))
    })
}

fn over_viewing_angles(
    incidence: f64,
    tolerance: f64,
    value: &dyn Fn(&Direction, &Direction) -> f64,
) -> Vec<(f64, f64)> {
    let l = Direction::from_degrees(incidence, 0.0);
    // Lobes stand about R or about L.
    let mut breaks = vec![-90.0, -incidence, incidence, 90.0];
    breaks.dedup();
    curve(&breaks, tolerance, &mut |degrees| {
        value(&l, &in_plane(degrees))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::{Lambert, MetallicPhong, Phong, RetroPhong};
    use crate::{Energy, directional_albedo_at};

    fn at(points: &[(f64, f64)], x: f64) -> f64 {
        points.iter().find(|p| p.0 == x).expect("a point there").1
    }

    #[test]
    fn the_albedo_is_the_models() {
        let m = MetallicPhong::new(20.0, Energy::Published).unwrap();
        let points = albedo(&m, 1e-3);
        for degrees in [0.0, 45.0, 90.0] {
            let exact = directional_albedo_at(&m, degrees).value;
            assert!((at(&points, degrees) - exact).abs() < 1e-6, "{degrees}");
        }
        let near = albedo_near_the_horizon(&m, 10.0, 1e-4, 1e-3);
        let (elevation, a) = near[near.len() / 2];
        let exact = directional_albedo_at(&m, 90.0 - elevation).value;
        assert!((a - exact).abs() < 1e-6, "{elevation}");
        assert!((near[0].0 - 10.0).abs() < 1e-9 && near[0].0 > near[1].0);
    }

    #[test]
    fn the_lobe_peaks_at_the_mirror_direction_and_the_retro_lobe_at_the_light() {
        let forward = lobe(&Phong::new(1e6).unwrap(), 42.0, 1.0);
        let back = lobe(
            &RetroPhong::new(1e6, 1.0, Energy::Published).unwrap(),
            42.0,
            1.0,
        );
        let peak = (1e6 + 2.0) / std::f64::consts::TAU;
        assert!((at(&forward, 42.0) / peak - 1.0).abs() < 1e-9);
        assert!(at(&forward, -42.0) < 1e-9);
        let raised = peak / 42f64.to_radians().cos();
        assert!((at(&back, -42.0) / raised - 1.0).abs() < 1e-9);
        assert!(at(&back, 42.0) < 1e-9);
    }

    #[test]
    fn radiance_has_the_cosine_and_every_incidence_works() {
        let matt = Lambert::grey(1.0).unwrap();
        for incidence in [0.0, 30.0, 90.0] {
            let points = radiance(&matt, incidence, 1e-3);
            assert!(points.windows(2).all(|p| p[0].0 < p[1].0), "{incidence}");
            let l = Direction::from_degrees(incidence, 0.0);
            let expected = l.z * std::f64::consts::FRAC_1_PI;
            assert_eq!(points[0].0, -90.0);
            assert!((points[points.len() / 2].1 - expected).abs() < 1e-12);
        }
    }
}
