//! Every sampler in `f32`, built at run time from parameters of any bits.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod probe {
    use core::hint::black_box;

    use microbrdf::Rgb;
    use microbrdf::arithmetic::F32;
    use microbrdf::brdf::{Lambert, PowerModel};
    use microbrdf::sampling::{
        MetalSampler, MetallicPhongSampler, PModelSampler, PatchExponentialSampler, PatchSampler,
        PhongSampler, RetroPhongSampler,
    };
    use microbrdf::table::{COSINE_KNOTS, CosineCurve};
    use microbrdf_probes::draw;

    type A = F32;

    #[allow(unsafe_code)]
    #[unsafe(no_mangle)]
    extern "C" fn _start() -> ! {
        let parameter = || f32::from_bits(black_box(0));
        let components = [0u8; 6].map(|_| parameter());
        let random = || [0u8; 2].map(|_| parameter());
        if let Ok(model) = Lambert::<A>::new(Rgb::grey(parameter())) {
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
        if let Ok(p) = PowerModel::<A>::new(parameter())
            && let Ok(sampler) = PModelSampler::<A>::with_foreshortening(parameter(), p)
        {
            draw(&sampler, components, random());
        }
        if let Ok(sampler) = PatchSampler::<A>::new(parameter()) {
            draw(&sampler, components, random());
        }
        if let Ok(sampler) = PatchExponentialSampler::<A>::new(parameter()) {
            draw(&sampler, components, random());
        }
        loop {}
    }
}
