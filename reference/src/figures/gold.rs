//! Figure 3.7: the albedo of gold over angle and wavelength.

use super::{Axis, Figure, Panel, Series, curve, of_model};
use crate::ParameterError;
use crate::albedo::directional_albedo_for;
use crate::brdf::Channel;
use crate::colour::{MetalName, metal_index};
use crate::models::Metal;
use crate::quadrature::Accuracy;

/// n, which the thesis does not state.
const EXPONENT: f64 = 20.0;
/// Wavelengths in nm of the left-hand diagram.
const WAVELENGTHS: [f64; 7] = [400.0, 450.0, 500.0, 550.0, 600.0, 650.0, 700.0];
/// Angles in degrees of the right-hand one.
const ANGLES: [f64; 6] = [0.0, 40.0, 60.0, 75.0, 85.0, 90.0];

/// Metallic Phong with gold's Fresnel reflectance at one wavelength.
fn gold(nm: f64) -> Result<Channel<Metal>, ParameterError> {
    let (eta, k) = metal_index(MetalName::Gold, nm);
    Ok(Channel(Metal::from_indices(EXPONENT, [eta; 3], [k; 3])?, 0))
}

/// Figure 3.7.
pub fn albedo() -> Result<Figure, ParameterError> {
    let mut over_angle = Vec::new();
    for (i, nm) in WAVELENGTHS.into_iter().enumerate() {
        let points = of_model::albedo(&gold(nm)?, 1e-3);
        over_angle.push(Series::new(format!("{nm} nm"), i, points));
    }
    let mut over_wavelength = Vec::new();
    for (i, degrees) in ANGLES.into_iter().enumerate() {
        let l = crate::Direction::from_degrees(degrees, 0.0);
        let points = curve(&[380.0, 516.6, 780.0], 4e-3, &mut |nm| match gold(nm) {
            Ok(model) => directional_albedo_for(&model, &l, Accuracy::COARSE).value,
            Err(_) => f64::NAN,
        });
        over_wavelength.push(Series::new(format!("Θ = {degrees}°"), i, points));
    }
    Ok(Figure {
        number: "3.7",
        title: "Albedo of gold over the angle of incidence and the wavelength (3.29)",
        notes: vec![
            format!(
                "The exponent is chosen here, n = {EXPONENT}: the thesis does not state its own. \
                 The albedo is that of the whole BRDF, Fresnel's factor at Θmin included."
            ),
            "Index of refraction: Hagemann, Gudat and Kunz 1974 (data/metals.csv), not the \
             thesis' source. Cuts through what the thesis may show as one surface."
                .to_owned(),
        ],
        panels: vec![
            Panel::cartesian(
                "over the angle",
                Axis::angle("angle of incidence Θ [°]"),
                Axis::linear("albedo a(Θ)", 0.0, 1.0),
                over_angle,
            ),
            Panel::cartesian(
                "over the wavelength",
                Axis::linear("wavelength [nm]", 380.0, 780.0),
                Axis::linear("albedo a(Θ)", 0.0, 1.0),
                over_wavelength,
            ),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fresnel::conductor;
    use crate::models::MetallicPhong;

    #[test]
    fn the_albedo_is_golds() {
        let figure = albedo().unwrap();
        let [angle, wavelength] = &figure.panels[..] else {
            panic!("two diagrams");
        };
        for (i, nm) in WAVELENGTHS.into_iter().enumerate() {
            let (eta, k) = metal_index(MetalName::Gold, nm);
            let fresnel = conductor(eta, k, 1.0);
            // At the normal Θmin is 0 for every V.
            let normal = angle.series[i].at(0.0).unwrap();
            assert!((normal - fresnel).abs() < 1e-6, "{nm} nm: {normal}");
            // At the horizon Θmin is V's angle: between F(0) and 1 times the white albedo.
            let white = MetallicPhong::grazing_albedo(EXPONENT);
            let grazing = angle.series[i].at(90.0).unwrap();
            assert!(
                grazing > fresnel * white && grazing < white,
                "{nm} nm: {grazing}"
            );
            for (k, degrees) in ANGLES.into_iter().enumerate() {
                let a = angle.series[i].at(degrees).unwrap();
                let b = wavelength.series[k].at(nm).unwrap();
                assert!((a - b).abs() < 8e-3, "{nm} nm, {degrees}°: {a} {b}");
            }
        }
        let normal = &wavelength.series[0];
        assert!(normal.at(700.0).unwrap() > 2.0 * normal.at(450.0).unwrap());
    }
}
