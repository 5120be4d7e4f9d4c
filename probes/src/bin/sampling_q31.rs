//! Every sampler in `q31`, built at run time from parameters of any bits.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod probe {
    use core::hint::black_box;

    use microbrdf::Rgb;
    use microbrdf::arithmetic::Q31;
    use microbrdf::brdf::{Lambert, PowerModel};
    use microbrdf::fixed::types::{I2F30, U0F32, U1F31, U2F30, U32F32};
    use microbrdf::sampling::{
        MetalSampler, MetallicPhongSampler, PModelSampler, PatchExponentialSampler, PatchSampler,
        PhongSampler, RetroPhongSampler,
    };
    use microbrdf::table::{COSINE_KNOTS, CosineCurve};
    use microbrdf_probes::draw;

    type A = Q31<64>;

    #[allow(unsafe_code)]
    #[unsafe(no_mangle)]
    extern "C" fn _start() -> ! {
        let components = [0u8; 6].map(|_| I2F30::from_bits(black_box(0)));
        let random = || [0u8; 2].map(|_| U0F32::from_bits(black_box(0)));
        let parameter = || U32F32::from_bits(black_box(0));
        if let Ok(model) = Lambert::<A>::new(Rgb::grey(U1F31::from_bits(black_box(0)))) {
            draw(&model, components, random());
        }
        if let Ok(sampler) = PhongSampler::<A>::new(parameter()) {
            draw(&sampler, components, random());
            draw(&sampler.with_peak(parameter()), components, random());
        }
        if let Ok(sampler) = RetroPhongSampler::<A>::new(parameter()) {
            draw(&sampler, components, random());
        }
        if let Ok(sampler) = MetallicPhongSampler::<A>::new(parameter()) {
            draw(&sampler, components, random());
            let curve = CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS]));
            draw(&MetalSampler::new(sampler, curve), components, random());
        }
        if let Ok(p) = PowerModel::<A>::new(U0F32::from_bits(black_box(0)))
            && let Ok(sampler) = PModelSampler::<A>::with_foreshortening(parameter(), p)
        {
            draw(&sampler, components, random());
        }
        if let Ok(sampler) = PatchSampler::<A>::new(U2F30::from_bits(black_box(0))) {
            draw(&sampler, components, random());
        }
        if let Ok(sampler) = PatchExponentialSampler::<A>::new(parameter()) {
            draw(&sampler, components, random());
        }
        loop {}
    }
}
