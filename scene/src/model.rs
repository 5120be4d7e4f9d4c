//! Materials as models: the core's, chosen at run time, and the reference's.

use std::sync::{Mutex, PoisonError};

use microbrdf::ParameterError;
use microbrdf::Rgb;
use microbrdf::arithmetic::Arithmetic;
use microbrdf::brdf::{
    Axis, Brdf, Flat, Foreshortening, GeneralisedLambert, Lambert, Metal, Metallic, MetallicPaint,
    MetallicPhong, Mirror, PModel, Patch, PatchExponential, PatchMetal, PatchProfile, Phong,
    PhongLobe, Plastic, PowerModel, Retro, RetroPhong,
};
use microbrdf::geometry::Geometry;
use microbrdf_reference as reference;
use reference::models as exact;

use crate::curve::cosine_curve;
use crate::host::{HostArithmetic, HostModels};
use crate::material::{Material, PatchShape, Reflectance};
use crate::square::SquareProfile;

/// Any of the core's models.
#[derive(Clone, Debug)]
pub enum AnyModel<A: Arithmetic> {
    /// Lambert.
    Lambert(Box<Lambert<A>>),
    /// cosⁿα.
    Phong(Box<Phong<A>>),
    /// cosⁿα / cosΘmin.
    MetallicPhong(Box<MetallicPhong<A>>),
    /// cosⁿα / cosᵖΘmin.
    PModel(Box<PModel<A>>),
    /// The retro-reflective forms.
    RetroFlat(Box<PhongLobe<A, Retro, Flat>>),
    /// p = 1.
    RetroPhong(Box<RetroPhong<A>>),
    /// 0 < p < 1.
    RetroPModel(Box<PhongLobe<A, Retro, PowerModel<A>>>),
    /// Basic patch.
    Patch(Box<Patch<A>>),
    /// Exponential mixture.
    PatchExponential(Box<PatchExponential<A>>),
    /// Mixture of any profile.
    PatchProfile(Box<PatchProfile<A>>),
    /// cosⁿα / g(Θmin).
    Metal(Box<Metal<A>>),
    /// Basic patch with Fresnel's factor.
    BasicPatchMetal(Box<PatchMetal<Patch<A>>>),
    /// Exponential mixture with Fresnel's factor.
    PatchMetal(Box<PatchMetal<PatchExponential<A>>>),
    /// The same at θ'.
    MetallicPaint(Box<MetallicPaint<A>>),
    /// Darkens less towards the rim than Lambert.
    GeneralisedLambert(Box<GeneralisedLambert<A>>),
    /// Diffuser and highlight.
    Plastic(Box<Plastic<A>>),
    /// The same with Fresnel's factor.
    FresnelPlastic(Box<Plastic<A, Metal<A>>>),
}

/// `$result` with `$model` naming the model, whichever it is.
macro_rules! each {
    ($any:expr, $model:ident => $result:expr) => {
        each!($any, $model => $result,
            Lambert Phong MetallicPhong PModel RetroFlat RetroPhong RetroPModel
            Patch PatchExponential PatchProfile Metal BasicPatchMetal PatchMetal
            MetallicPaint GeneralisedLambert Plastic FresnelPlastic)
    };
    ($any:expr, $model:ident => $result:expr, $($variant:ident)+) => {
        match $any {
            $(AnyModel::$variant(model) => {
                let $model = &**model;
                $result
            })+
        }
    };
}

impl<A: Arithmetic> Brdf<A> for AnyModel<A> {
    fn peak(&self) -> A::Scale {
        each!(self, model => Brdf::<A>::peak(model))
    }

    fn share(&self, geometry: &impl Geometry<A>) -> Rgb<A::Unit> {
        each!(self, model => Brdf::<A>::share(model, geometry))
    }

    fn brdf(&self, geometry: &impl Geometry<A>) -> Rgb<A::Value> {
        each!(self, model => Brdf::<A>::brdf(model, geometry))
    }

    fn reflect(&self, geometry: &impl Geometry<A>) -> Rgb<A::Radiance> {
        each!(self, model => Brdf::<A>::reflect(model, geometry))
    }
}

impl<A: Arithmetic> AnyModel<A> {
    /// Bytes that the model takes: those of a microcontroller, for there are
    /// no pointers in it.
    #[must_use]
    pub fn bytes(&self) -> usize {
        each!(self, model => std::mem::size_of_val(model))
    }
}

impl Material {
    /// The core's model of this material.
    ///
    /// # Errors
    /// A parameter that this arithmetic does not take: a fractional exponent
    /// below 1 in fixed point.
    pub fn model<A: HostArithmetic>(&self) -> Result<AnyModel<A>, ParameterError> {
        let Self::Plastic {
            albedo,
            specular,
            exponent,
            index,
        } = self
        else {
            return self.part();
        };
        let plastic = A::plastic(albedo.rgb(), specular.rgb(), *exponent)?;
        Ok(match index {
            None => AnyModel::Plastic(Box::new(plastic)),
            Some(index) => AnyModel::FresnelPlastic(Box::new(
                plastic.with_fresnel(Reflectance::dielectric(*index).curve()),
            )),
        })
    }

    /// The core's model of a material that is one part ([`Self::parts`]).
    ///
    /// # Errors
    /// A parameter that this arithmetic does not take: a fractional exponent
    /// below 1 in fixed point; a plastic, which is two parts.
    pub(crate) fn part<A: HostModels>(&self) -> Result<AnyModel<A>, ParameterError> {
        Ok(match self {
            Self::Lambert { albedo } => AnyModel::Lambert(Box::new(A::lambert(albedo.rgb())?)),
            Self::Phong {
                exponent, p, retro, ..
            } => self.lobe(*exponent, *p, *retro)?,
            Self::Patch { radius } => AnyModel::Patch(Box::new(A::patch(*radius)?)),
            Self::PatchExponential { sharpness } => {
                AnyModel::PatchExponential(Box::new(A::patch_exponential(*sharpness)?))
            }
            Self::PatchProfile { profile } => {
                let peak = A::scale(self.reference().peak());
                AnyModel::PatchProfile(Box::new(PatchProfile::new(profile.curve(), peak)))
            }
            Self::Metal {
                exponent,
                reflectance,
            } => {
                let lobe = A::lobe::<Mirror, _>(*exponent, Metallic)?;
                AnyModel::Metal(Box::new(Metal::new(lobe, reflectance.curve())))
            }
            Self::PatchMetal { shape, reflectance } => {
                let curve = reflectance.curve();
                match *shape {
                    PatchShape::Basic { radius } => AnyModel::BasicPatchMetal(Box::new(
                        PatchMetal::new(A::patch(radius)?, curve),
                    )),
                    PatchShape::Exponential { sharpness } => AnyModel::PatchMetal(Box::new(
                        PatchMetal::new(A::patch_exponential(sharpness)?, curve),
                    )),
                }
            }
            Self::MetallicPaint {
                sharpness,
                reflectance,
            } => AnyModel::MetallicPaint(Box::new(MetallicPaint::new(
                A::patch_exponential(*sharpness)?,
                reflectance.curve(),
            ))),
            Self::GeneralisedLambert {
                albedo,
                smoothness,
                clip,
            } => AnyModel::GeneralisedLambert(Box::new(GeneralisedLambert::new(
                A::lambert(albedo.rgb())?,
                generalised_profile(*smoothness, *clip).curve(),
                A::scale(self.reference().peak()),
            ))),
            Self::Plastic { .. } => {
                return Err(ParameterError {
                    parameter: "model",
                    accepted: "one of a plastic's parts",
                });
            }
        })
    }

    fn lobe<A: HostModels>(
        &self,
        n: f64,
        p: f64,
        retro: bool,
    ) -> Result<AnyModel<A>, ParameterError> {
        Ok(match (retro, p) {
            (false, 0.0) => AnyModel::Phong(self.energy(A::lobe::<Mirror, _>(n, Flat)?)),
            (false, 1.0) => {
                AnyModel::MetallicPhong(self.energy(A::lobe::<Mirror, _>(n, Metallic)?))
            }
            (false, _) => {
                AnyModel::PModel(self.energy(A::lobe::<Mirror, _>(n, A::power_model(p)?)?))
            }
            (true, 0.0) => AnyModel::RetroFlat(self.energy(A::lobe::<Retro, _>(n, Flat)?)),
            (true, 1.0) => AnyModel::RetroPhong(self.energy(A::lobe::<Retro, _>(n, Metallic)?)),
            (true, _) => {
                AnyModel::RetroPModel(self.energy(A::lobe::<Retro, _>(n, A::power_model(p)?)?))
            }
        })
    }

    /// The lobe with the peak that this material's `energy` asks for.
    fn energy<A: HostModels, X: Axis, P: Foreshortening<A>>(
        &self,
        lobe: PhongLobe<A, X, P>,
    ) -> Box<PhongLobe<A, X, P>> {
        Box::new(match self {
            Self::Phong {
                energy: reference::Energy::Strict,
                ..
            } => lobe.with_peak(A::scale(self.reference().peak())),
            _ => lobe,
        })
    }

    /// The reference's model of this material.
    ///
    /// # Panics
    /// Never: the ranges were checked when the material was read.
    #[must_use]
    pub fn reference(&self) -> Box<dyn reference::Brdf + Send + Sync> {
        const CHECKED: &str = "the ranges were checked when the material was read";
        match self.clone() {
            Self::Lambert { albedo } => {
                Box::new(exact::lambert::Lambert::new(albedo.rgb()).expect(CHECKED))
            }
            Self::Phong {
                exponent,
                p,
                retro: true,
                energy,
            } => Box::new(exact::retro_phong::RetroPhong::new(exponent, p, energy).expect(CHECKED)),
            Self::Phong {
                exponent,
                p,
                energy,
                ..
            } => Box::new(exact::p_model::PModel::new(exponent, p, energy).expect(CHECKED)),
            Self::Patch { radius } => Box::new(exact::patch::Patch::new(radius).expect(CHECKED)),
            Self::PatchExponential { sharpness } => {
                Box::new(exact::patch_exponential::PatchExponential::new(sharpness).expect(CHECKED))
            }
            Self::PatchProfile { profile } => Box::new(
                exact::patch_profile::PatchProfile::new(
                    move |m: f64| profile.at(m),
                    exact::Metric::EUCLIDEAN,
                )
                .expect(CHECKED),
            ),
            Self::Metal {
                exponent,
                reflectance: Reflectance::Named(metal),
            } => Box::new(exact::metal::Metal::named(exponent, metal).expect(CHECKED)),
            Self::Metal {
                exponent,
                reflectance: Reflectance::Index { eta, k },
            } => Box::new(exact::metal::Metal::from_indices(exponent, eta, k).expect(CHECKED)),
            Self::PatchMetal { shape, reflectance } => {
                let tint = reflectance.tint();
                let metal = match shape {
                    PatchShape::Basic { radius } => exact::PatchMetal::basic(radius, tint),
                    PatchShape::Exponential { sharpness } => {
                        exact::PatchMetal::exponential(sharpness, tint)
                    }
                };
                Box::new(metal.expect(CHECKED))
            }
            Self::MetallicPaint {
                sharpness,
                reflectance,
            } => Box::new(exact::MetallicPaint::new(sharpness, reflectance.tint()).expect(CHECKED)),
            Self::GeneralisedLambert {
                albedo,
                smoothness,
                clip,
            } => Box::new(
                generalised(smoothness, clip)
                    .with_albedo(albedo.rgb())
                    .expect(CHECKED),
            ),
            Self::Plastic {
                albedo,
                specular,
                exponent,
                index: None,
            } => Box::new(
                exact::plastic::Plastic::new(albedo.rgb(), specular.rgb(), exponent)
                    .expect(CHECKED),
            ),
            Self::Plastic {
                albedo,
                specular,
                exponent,
                index: Some(index),
            } => {
                let index = reference::fresnel::Index::new(index, 0.0).expect(CHECKED);
                Box::new(
                    exact::PlasticFresnel::new(albedo.rgb(), specular.rgb(), exponent, index)
                        .expect(CHECKED),
                )
            }
        }
    }

    /// This material with its parameters as the arithmetic rounds them: what
    /// an arithmetic error is measured against.
    #[must_use]
    pub fn rounded<A: HostArithmetic>(&self) -> Self {
        let mut material = self.clone();
        match &mut material {
            Self::Phong { exponent, .. }
            | Self::Metal { exponent, .. }
            | Self::Plastic { exponent, .. } => *exponent = A::exponent_value(*exponent),
            Self::Patch { radius }
            | Self::PatchMetal {
                shape: PatchShape::Basic { radius },
                ..
            } => *radius = A::radius_value(*radius),
            Self::PatchExponential { sharpness }
            | Self::MetallicPaint { sharpness, .. }
            | Self::PatchMetal {
                shape: PatchShape::Exponential { sharpness },
                ..
            } => *sharpness = A::exponent_value(*sharpness),
            Self::Lambert { .. } | Self::PatchProfile { .. } | Self::GeneralisedLambert { .. } => {}
        }
        material
    }
}

/// The reference's model of albedo 1.
fn generalised(smoothness: f64, clip: f64) -> exact::GeneralisedLambert {
    static KNOWN: Mutex<Vec<exact::GeneralisedLambert>> = Mutex::new(Vec::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    // Its constant is an integral: once is enough.
    if let Some(model) = known.iter().find(|model| model.is_of(smoothness, clip)) {
        return *model;
    }
    let model = exact::GeneralisedLambert::new(smoothness, clip)
        .expect("the ranges were checked when the material was read");
    known.push(model);
    model
}

/// ξ/ξmax of generalised Lambert (4.59) over m², for a smoothness from 0 to 1
/// and a clip of m from 1 to 1.9.
#[must_use]
pub fn generalised_profile(smoothness: f64, clip: f64) -> SquareProfile {
    let model = generalised(smoothness, clip);
    SquareProfile::new(
        |square| model.profile(square) / model.greatest_profile(),
        clip,
    )
}

impl Reflectance {
    /// The reference's of it.
    fn tint(&self) -> exact::Tint {
        match self {
            Self::Named(metal) => exact::Tint::named(*metal),
            Self::Index { eta, k } => exact::Tint::from_indices(*eta, *k)
                .expect("the ranges were checked when the material was read"),
        }
    }

    /// That of a real index of refraction.
    #[must_use]
    pub fn dielectric(index: f64) -> Self {
        Self::Index {
            eta: [index; 3],
            k: [0.0; 3],
        }
    }

    /// The Fresnel factor at a cosine, per channel.
    ///
    /// # Panics
    /// Never: the ranges were checked when the material was read.
    #[must_use]
    pub fn at(&self, cosine: f64) -> [f64; 3] {
        match self {
            Self::Named(metal) => reference::metal_rgb(*metal, cosine),
            Self::Index { eta, k } => [0, 1, 2]
                .map(|channel| reference::fresnel::conductor(eta[channel], k[channel], cosine)),
        }
    }

    /// The table of it.
    #[must_use]
    pub fn curve(&self) -> microbrdf::table::CosineCurve {
        cosine_curve(&|cosine| self.at(cosine))
    }
}
