//! Directional albedo of what is shipped: quadrature over the core's own
//! outputs against the reference's integrals, two-sided.

use microbrdf::brdf::Brdf;
use microbrdf_reference as reference;
use microbrdf_scene::Material;
use microbrdf_sim::energy::Shipped;
use microbrdf_tests::arithmetic::Tested;
use microbrdf_tests::{in_every_arithmetic, registry};
use reference::models::MetallicPhong;

in_every_arithmetic!(
    every_model_keeps_the_references_albedo,
    broad_lobes_overshoot_as_published,
    strict_energy_removes_the_overshoot,
    no_lobe_from_two_on_overshoots,
    the_albedo_at_the_horizon_is_the_closed_form,
    the_albedo_of_narrow_lobes_is_the_closed_form,
);

/// What the arithmetic's picture of a material reflects, its own peak
/// included.
struct Albedo<A: Tested> {
    shipped: Shipped<A>,
    exact: Box<dyn reference::Brdf + Send + Sync>,
    peak_error: f64,
}

impl<A: Tested> Albedo<A> {
    fn new(toml: &str) -> Self {
        let material = Material::from_argument(toml)
            .expect("a material")
            .rounded::<A>();
        let exact = material.reference();
        let peak = A::scale_value(material.model::<A>().expect("a material").peak());
        Self {
            shipped: Shipped::new(&material).expect("a material"),
            peak_error: peak / exact.peak(),
            exact,
        }
    }

    fn lobe(n: f64) -> Self {
        Self::new(&format!("model = \"metallic-phong\", exponent = {n}"))
    }

    fn at_cosine(&self, cosine: f64) -> [f64; 3] {
        self.shipped.albedo(cosine).map(|a| a * self.peak_error)
    }

    /// At an angle in degrees.
    fn at(&self, degrees: f64) -> f64 {
        self.at_cosine(degrees.to_radians().cos())[0]
    }

    fn exact_at(&self, cosine: f64) -> [f64; 3] {
        reference::directional_albedo_rgb(&*self.exact, cosine).map(|estimate| estimate.value)
    }

    /// The greatest albedo and its angle in degrees: a scan, then golden
    /// sections.
    fn greatest(&self) -> (f64, f64) {
        const STEP: f64 = 3.0;
        let mut best = (0.0, self.at(0.0));
        for step in 1..30 {
            let degrees = STEP * f64::from(step);
            let albedo = self.at(degrees);
            if albedo > best.1 {
                best = (degrees, albedo);
            }
        }
        if best.0 == 0.0 {
            return best;
        }
        let (mut low, mut high) = (best.0 - STEP, best.0 + STEP);
        let ratio = 0.5 * (5f64.sqrt() - 1.0);
        let inner = |low: f64, high: f64| high - ratio * (high - low);
        let outer = |low: f64, high: f64| low + ratio * (high - low);
        let mut at = [inner(low, high), outer(low, high)].map(|degrees| self.at(degrees));
        while high - low > 0.02 {
            if at[0] > at[1] {
                high = outer(low, high);
                at = [self.at(inner(low, high)), at[0]];
            } else {
                low = inner(low, high);
                at = [at[1], self.at(outer(low, high))];
            }
        }
        let middle = 0.5 * (low + high);
        (middle, self.at(middle))
    }
}

/// How far a lobe's albedo may be off for its table or function, and for
/// rounded directions.
fn room<A: Tested>(n: f64) -> f64 {
    A::LOBE_ERROR / 3.0 + A::DIRECTION_NOISE * n.sqrt() * A::COMPONENT_ERROR
}

/// Whether a direction's step is far below a lobe's width.
fn resolved<A: Tested>(n: f64) -> bool {
    n.sqrt() * A::COMPONENT_ERROR < 5e-3
}

/// How far the albedo may be off: a bound for each arithmetic and family.
///
/// A chord that is shifted by half of its greatest error, so that ±e is left,
/// lies e/3 too high on the mean: the energy of a tabulated lobe is off by a
/// third of the lobe's error, and single precision's rounding averages out.
/// Rounded directions shift a lobe by a share √n of a component's error of its
/// width, of which the quadrature, with a hundred nodes across, sees a
/// hundredth.
/// A Fresnel curve adds half a step of its entries, 2⁻¹⁶, and its own chords.
fn bound<A: Tested>(entry: &registry::Entry) -> f64 {
    let lobe = room::<A>(entry.n);
    match entry.model {
        "lambert" | "patch" => {
            4.0 * A::UNIT_STEP + A::DIRECTION_NOISE * entry.n.sqrt().max(1.0) * A::COMPONENT_ERROR
        }
        // As the mixture, with a Fresnel curve.
        "patch-metal" | "metallic-paint" => {
            lobe + 2.5e-5 + 2.0 * A::COMPONENT_ERROR * entry.n.sqrt() * 8f64.sqrt()
        }
        // A third of the table's error, which all directions share near the
        // clip alone.
        "generalised-lambert" => lobe + 4.0 * A::UNIT_STEP + 1e-4,
        "metal" | "plastic with index" => lobe + 4.0 * A::UNIT_STEP + 2e-5,
        // e^(−s·m) with the error of m times s.
        "patch-exponential" => {
            lobe + 5e-8 + 2.0 * A::COMPONENT_ERROR * entry.n.sqrt() * 8f64.sqrt()
        }
        // The error of m times the slope of ξ, below √(2n).
        "profile" => lobe + 4.0 * A::UNIT_STEP + 2.0 * A::COMPONENT_ERROR * (2.0 * entry.n).sqrt(),
        "plastic" if entry.n > 1e5 => f64::INFINITY,
        _ => lobe + 4.0 * A::UNIT_STEP,
    }
}

fn every_model_keeps_the_references_albedo<A: Tested>() {
    let mut faults = Vec::new();
    let mut found = std::collections::BTreeMap::<_, f64>::new();
    for entry in registry::all() {
        // One exponent shows a metal's colours, and what surrounds the lobe.
        let few = match entry.model {
            "metal" => entry.n == 20.0 || entry.n == 40.0,
            "phong" | "retro-phong" | "plastic" | "plastic with index" => {
                [1.0, 20.0, 5e3, 1e8].contains(&entry.n)
            }
            _ => true,
        };
        if !few || !resolved::<A>(entry.n) {
            continue;
        }
        let albedo = Albedo::<A>::new(&entry.toml);
        let bound = bound::<A>(&entry);
        for degrees in [0.0f64, 20.0, 45.0, 70.0, 85.0, 89.0, 89.9] {
            let cosine = degrees.to_radians().cos();
            let (shipped, exact) = (albedo.at_cosine(cosine), albedo.exact_at(cosine));
            for channel in 0..3 {
                let error = shipped[channel] - exact[channel];
                if error.abs() > bound {
                    faults.push(format!(
                        "{} at {degrees}: {error:+.2e} of {:.4}, bound {bound:.1e}",
                        entry.toml, exact[channel]
                    ));
                }
                if bound.is_finite() {
                    let share = found.entry(entry.model).or_default();
                    *share = share.max(error.abs() / bound);
                }
            }
        }
    }
    println!("{}: shares of the bounds: {found:.2?}", A::NAME);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The excess over 1 and its angle in degrees, from papers' c_n as published.
const OVERSHOOTS: [(f64, f64, f64); 4] = [
    (1.0, 2.886e-4, 12.9),
    (0.5, 1.064e-2, 30.0),
    (0.25, 3.4e-2, 38.5),
    (0.0, 8.6e-2, 45.0),
];

fn overshoots<A: Tested>() -> impl Iterator<Item = (f64, f64, f64)> {
    OVERSHOOTS
        .into_iter()
        .filter(|(n, ..)| A::FRACTIONAL_EXPONENTS || n.fract() == 0.0)
}

/// What an arithmetic adds to the albedo of a broad lobe, whose table or
/// function is exact in `f32` and `q31`.
fn inexact<A: Tested>() -> f64 {
    if A::LOBE_ERROR < 1e-3 {
        0.0
    } else {
        room::<A>(2.0)
    }
}

fn broad_lobes_overshoot_as_published<A: Tested>() {
    for (n, excess, angle) in overshoots::<A>() {
        let (degrees, albedo) = Albedo::<A>::lobe(n).greatest();
        println!("{}, n = {n}: {:.4e} at {degrees:.2}", A::NAME, albedo - 1.0);
        // Half of the last printed digit.
        let digit = if excess < 1e-3 {
            5e-8
        } else if excess < 2e-2 {
            5e-6
        } else {
            5e-4
        };
        assert!(
            (albedo - 1.0 - excess).abs() <= digit + 4.0 * A::UNIT_STEP + inexact::<A>(),
            "n = {n}: {albedo}"
        );
        // An error of the albedo moves a flat maximum far.
        if inexact::<A>() == 0.0 {
            assert!((degrees - angle).abs() <= 0.06, "n = {n}: at {degrees}");
        }
    }
}

fn strict_energy_removes_the_overshoot<A: Tested>() {
    // One is enough: finding the greatest albedo takes the reference seconds.
    let n = if A::FRACTIONAL_EXPONENTS { 0.5 } else { 0.0 };
    let strict = Albedo::<A>::new(&format!(
        "model = \"metallic-phong\", exponent = {n}, energy = \"strict\""
    ));
    let (_, albedo) = strict.greatest();
    assert!(
        (albedo - 1.0).abs() <= 1e-7 + inexact::<A>(),
        "n = {n}: {albedo}"
    );
}

fn no_lobe_from_two_on_overshoots<A: Tested>() {
    for n in [2.0, 3.7, 20.0, 500.0, 5e3] {
        let (degrees, albedo) = Albedo::<A>::lobe(n).greatest();
        let room = room::<A>(n);
        assert!(
            degrees == 0.0 || albedo - 1.0 <= inexact::<A>(),
            "n = {n}: {albedo} at {degrees}"
        );
        assert!((albedo - 1.0).abs() <= room, "n = {n}: {albedo}");
    }
}

/// (n + 2)/(2n + 2) (3.27).
fn the_albedo_at_the_horizon_is_the_closed_form<A: Tested>() {
    for n in [0.0, 1.0, 2.0, 20.0, 500.0, 1e5] {
        let albedo = Albedo::<A>::lobe(n).at_cosine(0.0)[0];
        let closed = MetallicPhong::grazing_albedo(n);
        let room = room::<A>(n) + 4.0 * A::UNIT_STEP;
        if !resolved::<A>(n) {
            continue;
        }
        assert!(
            (albedo - closed).abs() <= room,
            "n = {n}: {albedo} for {closed}"
        );
    }
}

fn the_albedo_of_narrow_lobes_is_the_closed_form<A: Tested>() {
    for n in [500.0, 1e4, 1e6, 1e8] {
        if !resolved::<A>(n) {
            continue;
        }
        let albedo = Albedo::<A>::lobe(n);
        for degrees in [10.0f64, 60.0, 85.0, 89.0, 89.9] {
            let cosine = degrees.to_radians().cos();
            let (found, closed) = (
                albedo.at_cosine(cosine)[0],
                MetallicPhong::albedo_for_large_exponents(n, cosine),
            );
            let room = 0.601 / n + room::<A>(n) + 4.0 * A::UNIT_STEP;
            assert!(
                (found - closed).abs() <= room,
                "n = {n}, {degrees}: {found} for {closed}"
            );
        }
    }
}
