//! Every model in a fixed-point arithmetic, built at run time from parameters
//! of any bits.

/// The entry of a probe: an arithmetic, the type of its components, and that
/// of its gains.
#[macro_export]
macro_rules! every_model {
    ($arithmetic:ty, $component:ty, $gain:ty) => {
        use core::hint::black_box;

        use microbrdf::Rgb;
        use microbrdf::brdf::{
            GeneralisedLambert, Lambert, Metal, MetallicPaint, MetallicPhong, PModel, Patch,
            PatchExponential, PatchMetal, PatchProfile, Phong, Plastic, PowerModel, RetroPhong,
        };
        use microbrdf::fixed::types::{U0F32, U1F31, U2F30, U32F32};
        use microbrdf::table::{
            COSINE_KNOTS, CosineCurve, PROFILE_KNOTS, ProfileCurve, SQUARE_KNOTS, SquareCurve,
        };
        use microbrdf_probes::evaluate;

        type A = $arithmetic;

        #[allow(unsafe_code)]
        #[unsafe(no_mangle)]
        extern "C" fn _start() -> ! {
            let components = [0u8; 9].map(|_| <$component>::from_bits(black_box(0)));
            let gain = <$gain>::new(U32F32::from_bits(black_box(0)));
            let parameter = || U32F32::from_bits(black_box(0));
            let share = || Rgb::grey(U1F31::from_bits(black_box(0)));
            if let Ok(model) = Lambert::<A>::new(share()) {
                evaluate(&model, components, gain);
            }
            if let Ok(model) = Phong::<A>::new(parameter()) {
                evaluate(&model, components, gain);
            }
            if let Ok(model) = RetroPhong::<A>::new(parameter()) {
                evaluate(&model, components, gain);
            }
            if let Ok(model) = MetallicPhong::<A>::new(parameter()) {
                evaluate(&model, components, gain);
                let curve = CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS]));
                evaluate(&Metal::new(model, curve), components, gain);
            }
            if let Ok(p) = PowerModel::<A>::new(U0F32::from_bits(black_box(0)))
                && let Ok(model) = PModel::<A>::with_foreshortening(parameter(), p)
            {
                evaluate(&model, components, gain);
            }
            if let Ok(model) = Patch::<A>::new(U2F30::from_bits(black_box(0))) {
                evaluate(&model, components, gain);
            }
            if let Ok(model) = PatchExponential::<A>::new(parameter()) {
                evaluate(&model, components, gain);
                let curve = CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS]));
                evaluate(&MetallicPaint::new(model, curve), components, gain);
                evaluate(&PatchMetal::new(model, curve), components, gain);
            }
            if let Ok(body) = Lambert::<A>::new(share())
                && let Ok(curve) = SquareCurve::new(black_box([0; SQUARE_KNOTS]), black_box(0))
            {
                evaluate(
                    &GeneralisedLambert::new(body, curve, parameter()),
                    components,
                    gain,
                );
            }
            if let Ok(profile) = ProfileCurve::new(black_box([0; PROFILE_KNOTS]), black_box(0)) {
                evaluate(
                    &PatchProfile::<A>::new(profile, parameter()),
                    components,
                    gain,
                );
            }
            if let Ok(model) = Plastic::<A>::new(share(), share(), parameter()) {
                evaluate(&model, components, gain);
                let curve = CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS]));
                evaluate(&model.with_fresnel(curve), components, gain);
            }
            loop {}
        }
    };
}
