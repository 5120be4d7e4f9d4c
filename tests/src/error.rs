//! Arithmetic error: against the reference at the rounded directions.

use microbrdf::Rgb;
use microbrdf::brdf::Brdf as _;
use microbrdf::geometry::{Direction, ShadingFrame};
use microbrdf_reference as reference;
use microbrdf_scene::{AnyModel, HostArithmetic, Material};

use crate::domain::Pair;

/// The errors of a set of samples, in sRGB codes.
#[derive(Clone, Copy, Debug, Default)]
pub struct CodeError {
    /// Greatest |code − exact code|.
    pub lsb_max: f64,
    /// Greatest |code − rounded exact code|.
    pub code_max: u8,
    /// Share of codes off by one, of those whose exact code is 1 … 254.
    pub off_by_one: f64,
    /// Share off by more.
    pub off_by_more: f64,
    /// Channels counted in the shares.
    pub counted: u32,
}

/// A material in one arithmetic beside the reference of the same, rounded,
/// parameters.
pub struct Subject<A: HostArithmetic> {
    /// The core's.
    pub model: AnyModel<A>,
    /// The reference's.
    pub exact: Box<dyn reference::Brdf + Send + Sync>,
}

impl<A: HostArithmetic> Subject<A> {
    /// The material in arithmetic `A`.
    ///
    /// # Panics
    /// If the arithmetic does not take it.
    pub fn new(material: &Material) -> Self {
        let rounded = material.rounded::<A>();
        let model = rounded
            .model()
            .expect("a material within the arithmetic's range");
        Self {
            model,
            exact: rounded.reference(),
        }
    }

    /// Rounds a pair to the arithmetic's directions.
    pub fn geometry(pair: Pair) -> ShadingFrame<A> {
        let [l, v] =
            pair.map(|[x, y, z]| Direction::new(A::component(x), A::component(y), A::component(z)));
        ShadingFrame::new(l, v)
    }

    /// The values of rounded directions.
    pub fn rounded(geometry: &ShadingFrame<A>) -> [reference::Direction; 2] {
        [geometry.l, geometry.v].map(|d| {
            reference::Direction::new(
                A::component_value(d.x),
                A::component_value(d.y),
                A::component_value(d.z),
            )
        })
    }

    /// The code that is displayed at exposure K, and the exact one.
    pub fn codes(&self, pair: Pair, exposure: f64) -> ([u8; 3], [f64; 3]) {
        let geometry = Self::geometry(pair);
        let gain = Rgb::grey(A::gain(exposure));
        let shown = A::linear(self.model.shade(&gain, &geometry)).srgb8();
        let [l, v] = Self::rounded(&geometry);
        let exact = self
            .exact
            .rho(&l, &v)
            .map(|rho| 255.0 * reference::encode_srgb((exposure * rho).clamp(0.0, 1.0)));
        (shown, exact)
    }

    /// The errors over many pairs at exposure K.
    pub fn code_error(&self, pairs: &[Pair], exposure: f64) -> CodeError {
        let mut error = CodeError::default();
        let (mut one, mut more) = (0u32, 0u32);
        for pair in pairs {
            let (shown, exact) = self.codes(*pair, exposure);
            for channel in 0..3 {
                let rounded = exact[channel].round() as u8;
                let distance = (f64::from(shown[channel]) - exact[channel]).abs();
                error.lsb_max = error.lsb_max.max(distance);
                let steps = shown[channel].abs_diff(rounded);
                error.code_max = error.code_max.max(steps);
                if (1..=254).contains(&rounded) {
                    error.counted += 1;
                    one += u32::from(steps == 1);
                    more += u32::from(steps > 1);
                }
            }
        }
        let counted = f64::from(error.counted.max(1));
        error.off_by_one = f64::from(one) / counted;
        error.off_by_more = f64::from(more) / counted;
        error
    }
}
