//! A whole pixel in a fixed-point arithmetic: ray, shapes, materials, lights,
//! sky and every encoding, of any bits.

/// The entry of a probe: an arithmetic, the type of its components, and that
/// of its gains.
#[macro_export]
macro_rules! every_pixel {
    ($arithmetic:ty, $component:ty, $gain:ty) => {
        use core::hint::black_box;

        use microbrdf::Rgb;
        use microbrdf::brdf::MetallicPhong;
        use microbrdf::fixed::types::{I8F24, I24F40, U32F32};
        use microbrdf::geometry::Direction;
        use microbrdf::shade::{
            AlbedoDaylight, Camera, Checker, Coat, Dimmed, Extent, FloodLight, FourSamples, Light,
            Linear, NoView, OneSample, Placing, Plane, PointLight, Scene, Shadowed, Sphere,
            Tracing, Unshadowed, grey16,
        };
        use microbrdf::table::{COSINE_KNOTS, CosineCurve};
        // Brings the handler.
        use microbrdf_probes as _;

        type A = $arithmetic;

        /// A light of any kind, as a baked scene has them.
        enum Lamp {
            Directional(Direction<A>),
            Point(PointLight<A>),
            Flood(FloodLight<A>),
        }

        impl Light<A> for Lamp {
            type Beam = Dimmed<A>;

            fn beam(&self, place: impl Fn() -> <A as Placing>::Place) -> Dimmed<A> {
                match self {
                    Self::Directional(direction) => (*direction).into(),
                    Self::Point(lamp) => lamp.beam(place),
                    Self::Flood(lamp) => lamp.beam(place),
                }
            }

            fn lamp(&self) -> Option<&[<A as Tracing>::Length; 3]> {
                match self {
                    Self::Directional(light) => light.lamp(),
                    Self::Point(light) => light.lamp(),
                    Self::Flood(light) => light.lamp(),
                }
            }
        }

        fn seen(x: usize, pixel: Linear) {
            black_box((x, pixel.srgb8(), pixel.rgb565()));
            black_box(pixel.rgb565_dithered(x, black_box(0)));
            black_box(grey16(pixel.luminance(), x, black_box(0)));
        }

        #[allow(unsafe_code)]
        #[unsafe(no_mangle)]
        extern "C" fn _start() -> ! {
            let fine = || [0u8; 3].map(|_| I24F40::from_bits(black_box(0)));
            let length = || I8F24::from_bits(black_box(0));
            let lengths = || [length(), length(), length()];
            let component = || <$component>::from_bits(black_box(0));
            let direction = || Direction::<A>::new(component(), component(), component());
            let gain = || Rgb::grey(<$gain>::new(U32F32::from_bits(black_box(0))));
            let parameter = || U32F32::from_bits(black_box(0));
            let lamp = || PointLight::<A> {
                position: lengths(),
                near: length(),
            };
            let (Ok(model), Ok(flood)) = (
                MetallicPhong::<A>::new(parameter()),
                FloodLight::<A>::new(lamp(), direction(), parameter()),
            ) else {
                loop {}
            };
            let coat = Coat {
                model,
                gains: &[gain(), gain(), gain()],
                daylight: AlbedoDaylight {
                    albedo: CosineCurve::from_entries(black_box([[0; 3]; COSINE_KNOTS])),
                    gain: gain(),
                },
            };
            let plane = || Plane::<A> {
                normal: direction(),
                height: length(),
                material: black_box(0),
            };
            let sphere = || Sphere::<A> {
                eye: lengths(),
                radius: length(),
                material: black_box(0),
                extent: Extent {
                    columns: black_box([0; 2]),
                    rows: black_box([0; 2]),
                },
            };
            let camera = Camera {
                width: black_box(0),
                height: black_box(0),
                forward: fine(),
                right: fine(),
                up: fine(),
            };
            let background = Linear::from_raw(black_box(0), 0, 0);
            let scene = Scene {
                camera,
                view: NoView,
                spheres: &[sphere()],
                planes: &[plane()],
                lights: &[direction(), direction()],
                materials: &[coat],
                background,
                shadows: Unshadowed,
                samples: OneSample,
            };
            scene.shade_row(black_box(0), seen);
            // All that a scene can ask for besides.
            let scene = Scene {
                camera,
                view: NoView,
                spheres: &[sphere(), sphere()],
                planes: &[Checker {
                    plane: plane(),
                    odd: black_box(0),
                    eye: [I24F40::from_bits(black_box(0)); 2],
                    across: [fine(), fine()],
                }],
                lights: &[
                    Lamp::Directional(direction()),
                    Lamp::Point(lamp()),
                    Lamp::Flood(flood),
                ],
                materials: &[coat],
                background,
                shadows: Shadowed,
                samples: FourSamples,
            };
            scene.shade_row(black_box(0), seen);
            loop {}
        }
    };
}
