//! A whole pixel in `q31`: ray, shapes, material, lights, sky and every
//! encoding, of any bits.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(not(target_os = "none"))]
fn main() {}

#[cfg(target_os = "none")]
mod probe {
    use core::hint::black_box;

    use microbrdf::Rgb;
    use microbrdf::arithmetic::{Gain31, Q31};
    use microbrdf::brdf::MetallicPhong;
    use microbrdf::fixed::types::{I2F30, I8F24, I24F40, U32F32};
    use microbrdf::geometry::Direction;
    use microbrdf::shade::{AlbedoDaylight, Camera, Coat, Linear, Plane, Scene, Sphere, grey16};
    use microbrdf::table::{COSINE_KNOTS, CosineCurve};
    // Brings the handler.
    use microbrdf_probes as _;

    type A = Q31<64>;

    #[allow(unsafe_code)]
    #[unsafe(no_mangle)]
    extern "C" fn _start() -> ! {
        let fine = || [0u8; 3].map(|_| I24F40::from_bits(black_box(0)));
        let length = || I8F24::from_bits(black_box(0));
        let component = || I2F30::from_bits(black_box(0));
        let direction = || Direction::<A>::new(component(), component(), component());
        let gain = || Rgb::grey(Gain31::new(U32F32::from_bits(black_box(0))));
        let Ok(model) = MetallicPhong::<A>::new(U32F32::from_bits(black_box(0))) else {
            loop {}
        };
        let coat = Coat {
            model,
            gains: &[gain(), gain()],
            daylight: AlbedoDaylight {
                albedo: CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS])),
                gain: gain(),
            },
        };
        let scene = Scene {
            camera: Camera {
                width: black_box(0),
                height: black_box(0),
                forward: fine(),
                right: fine(),
                up: fine(),
            },
            view: microbrdf::shade::NoView,
            spheres: &[Sphere {
                eye: [length(), length(), length()],
                radius: length(),
                material: black_box(0),
            }],
            planes: &[Plane {
                normal: direction(),
                height: length(),
                material: black_box(0),
            }],
            lights: &[direction(), direction()],
            materials: &[coat],
            background: Linear::from_raw(black_box(0), 0, 0),
        };
        scene.shade_row(black_box(0), |x, pixel| {
            black_box((x, pixel.srgb8(), pixel.rgb565()));
            black_box(grey16(pixel.luminance(), x, black_box(0)));
        });
        loop {}
    }
}
