//! Lobes and patches with a light's gain in their tables, and a sphere's
//! highlight, built at run time from parameters of any bits, to the codes of a
//! display.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod probe {
    use core::hint::black_box;

    use microbrdf::Rgb;
    use microbrdf::arithmetic::{Q15, Q31};
    use microbrdf::brdf::{
        DirectPhong, ExposedMetal, ExposedPatch, ExposedPhong, MetallicPhong, Patch,
    };
    use microbrdf::fixed::types::{I2F14, I2F30, U2F30, U32F32};
    use microbrdf::geometry::{Direction, ShadingFrame, ShortWorld, World};
    use microbrdf::shade::{LitSphere, LobeColours, Palette565, srgb8_direct};
    use microbrdf::table::{COSINE_KNOTS, CosineCurve};
    // Brings the handler.
    use microbrdf_probes as _;

    static PALETTE: Palette565 = Palette565::new([1 << 24; 3]);

    #[allow(unsafe_code)]
    #[unsafe(no_mangle)]
    extern "C" fn _start() -> ! {
        let [nx, ny, nz, lx, ly, lz, vx, vy, vz] =
            [0i16; 9].map(|_| I2F14::from_bits(black_box(0)));
        let (l, v) = (
            Direction::<Q15>::new(lx, ly, lz),
            Direction::new(vx, vy, vz),
        );
        let frame = ShadingFrame::new(l, v);
        let normal = Direction::new(nx, ny, nz);
        let world = World::new(normal, l, v);
        let short = ShortWorld::new(normal, l, v);
        let any = || U32F32::from_bits(black_box(0));
        let gain = || Rgb {
            r: any(),
            g: any(),
            b: any(),
        };
        if let Ok(lobe) = MetallicPhong::<Q15>::new(any()) {
            if let Ok(model) = ExposedPhong::new(lobe, gain()) {
                show(model.shade(&frame));
                show(model.shade(&world));
            }
            if let Ok(model) = DirectPhong::<1024>::new(&lobe, gain()) {
                show(model.shade(&frame));
                show(model.shade(&short));
            }
            let curve = CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS]));
            if let Ok(model) = ExposedMetal::<129, 65>::new(lobe, &curve, gain()) {
                show(model.shade(&frame));
                show(model.shade(&world));
            }
            if let Ok(model) = ExposedMetal::<129, 257>::new(lobe, &curve, gain()) {
                show(model.shade(&world));
            }
        }
        if let Ok(patch) = Patch::<Q15>::new(U2F30::from_bits(black_box(0)))
            && let Ok(model) = ExposedPatch::new(patch, gain())
        {
            show(model.shade(&frame));
            show(model.shade(&world));
        }
        if let Ok(colours) = LobeColours::<256>::new(any(), gain()) {
            shade(&colours);
        }
        shade(&LobeColours::<256, true>::flat(gain()));
        loop {}
    }

    fn shade<const FLAT: bool>(colours: &LobeColours<256, FLAT>) {
        let place = || I2F30::from_bits(black_box(0));
        let l = Direction::<Q31>::new(place(), place(), place());
        let lit = LitSphere::<256>::new(colours, l);
        let mut rows = lit.rows(colours, [place(), place()], [place(), place()]);
        let mut pixels = [0; 64];
        let count = black_box(64usize).min(pixels.len());
        rows.shade(
            pixels
                .split_at_mut_checked(count)
                .map_or(&mut [], |(row, _)| row),
        );
        black_box(pixels);
    }

    fn show(light: Rgb<u16>) {
        black_box(light.map(srgb8_direct));
        black_box(PALETTE.at_short(light.r));
    }
}
