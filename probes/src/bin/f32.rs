//! Every model in `f32`, built at run time from parameters of any bits.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod probe {
    use core::hint::black_box;

    use microbrdf::Rgb;
    use microbrdf::arithmetic::F32;
    use microbrdf::brdf::{
        GeneralisedLambert, Lambert, Metal, MetallicPaint, MetallicPhong, PModel, Patch,
        PatchExponential, PatchMetal, PatchProfile, Phong, Plastic, PowerModel, RetroPhong,
    };
    use microbrdf::table::{
        COSINE_KNOTS, CosineCurve, PROFILE_KNOTS, ProfileCurve, SQUARE_KNOTS, SquareCurve,
    };
    use microbrdf_probes::evaluate;

    #[allow(unsafe_code)]
    #[unsafe(no_mangle)]
    extern "C" fn _start() -> ! {
        let any = || f32::from_bits(black_box(0));
        let components = [0u8; 9].map(|_| any());
        if let Ok(model) = Lambert::<F32>::new(Rgb::grey(any())) {
            evaluate(&model, components, any());
        }
        if let Ok(model) = Phong::<F32>::new(any()) {
            evaluate(&model, components, any());
        }
        if let Ok(model) = RetroPhong::<F32>::new(any()) {
            evaluate(&model, components, any());
        }
        if let Ok(model) = MetallicPhong::<F32>::new(any()) {
            evaluate(&model, components, any());
            let curve = CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS]));
            evaluate(&Metal::new(model, curve), components, any());
        }
        if let Ok(p) = PowerModel::<F32>::new(any())
            && let Ok(model) = PModel::<F32>::with_foreshortening(any(), p)
        {
            evaluate(&model, components, any());
        }
        if let Ok(model) = Patch::<F32>::new(any()) {
            evaluate(&model, components, any());
        }
        if let Ok(model) = PatchExponential::<F32>::new(any()) {
            evaluate(&model, components, any());
            let curve = CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS]));
            evaluate(&MetallicPaint::new(model, curve), components, any());
            evaluate(&PatchMetal::new(model, curve), components, any());
        }
        if let Ok(body) = Lambert::<F32>::new(Rgb::grey(any()))
            && let Ok(curve) = SquareCurve::new(black_box([0; SQUARE_KNOTS]), black_box(0))
        {
            evaluate(
                &GeneralisedLambert::new(body, curve, any()),
                components,
                any(),
            );
        }
        if let Ok(profile) = ProfileCurve::new(black_box([0; PROFILE_KNOTS]), black_box(0)) {
            evaluate(&PatchProfile::<F32>::new(profile, any()), components, any());
        }
        if let Ok(model) = Plastic::<F32>::new(Rgb::grey(any()), Rgb::grey(any()), any()) {
            evaluate(&model, components, any());
            let curve = CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS]));
            evaluate(&model.with_fresnel(curve), components, any());
        }
        loop {}
    }
}
