//! Directions of pixels of which some are not lit.

use microbrdf::geometry::{Direction, Geometry, World};

use super::arithmetic::lit;
use super::{Lanes, Wide};

/// N, L and V, with N·L = 0 where no light arrives or is seen: there a share is 0
/// times its lobe.
pub(super) struct Lit {
    world: World<Wide>,
    cosines: (Lanes, Lanes),
}

impl Lit {
    /// A normal, a direction to the light, one to the viewer, and N·V.
    #[inline(always)]
    pub(super) fn new(
        n: Direction<Wide>,
        l: Direction<Wide>,
        v: Direction<Wide>,
        n_dot_v: Lanes,
    ) -> Self {
        let world = World::with_cosine(n, l, v, n_dot_v);
        let n_dot_l = world.cosines().0;
        let n_dot_l = lit(n_dot_l, n_dot_v).or_zero(n_dot_l);
        Self {
            world,
            cosines: (n_dot_l, n_dot_v),
        }
    }
}

impl Geometry<Wide> for Lit {
    #[inline(always)]
    fn cosines(&self) -> (Lanes, Lanes) {
        self.cosines
    }

    #[inline(always)]
    fn versine(&self) -> Lanes {
        self.world.versine()
    }

    #[inline(always)]
    fn retro_versine(&self) -> Lanes {
        self.world.retro_versine()
    }

    #[inline(always)]
    fn separation(&self) -> Lanes {
        self.world.separation()
    }
}

#[cfg(test)]
mod tests {
    use microbrdf::Rgb;
    use microbrdf::arithmetic::Arithmetic;
    use microbrdf::brdf::{Brdf, Flat, Metallic, MetallicPhong, Mirror, Phong, PhongLobe};
    use microbrdf::geometry::{Direction, World};

    use super::super::lanes::{One, WIDTH, all};
    use super::{Lanes, Lit, Wide};
    use crate::host::HostModels;

    /// Cosines of the light and of the viewer, those of each side beside each other.
    const COSINES: [[f32; 2]; WIDTH] = [
        [0.8, 0.6],
        [0.8, -0.1],
        [-0.3, 0.5],
        [-0.2, -0.9],
        [0.5, 0.0],
        [0.0, 0.7],
        [0.3, -1e-8],
        [1.0, 1.0],
    ];

    fn along(x: f32, z: f32) -> Direction<One> {
        Direction::new(x * (1.0 - z * z).sqrt(), 0.0, z)
    }

    fn same<M: Brdf<One>, W: Brdf<Wide>>(single: &M, wide: &W) {
        let n: Direction<One> = Direction::new(0.0, 0.0, 1.0);
        let l = COSINES.map(|[l, _]| along(1.0, l));
        let v = COSINES.map(|[_, v]| along(-1.0, v));
        let wide_n = all(n);
        let [wide_l, wide_v] = [l, v].map(|each| {
            let [x, z] = [each.map(|d| d.x), each.map(|d| d.z)];
            Direction::new(Lanes::of(|i| x[i]), Lanes::ZERO, Lanes::of(|i| z[i]))
        });
        let geometry = Lit::new(wide_n, wide_l, wide_v, Wide::dot(&wide_n, &wide_v));
        let found = wide.share(&geometry).r.array();
        let expected: [f32; WIDTH] =
            std::array::from_fn(|i| single.share(&World::new(n, l[i], v[i])).r);
        assert_eq!(found, expected);
        let lit = expected.map(|share| share > 0.0);
        assert_eq!(lit, [true, false, false, false, true, false, false, true]);
        let none = Rgb::grey(0.0);
        assert_eq!(wide.shade(&none, &geometry), Rgb::default());
    }

    /// Each pixel as it is by itself, whatever stands beside it.
    #[test]
    fn pixels_that_are_not_lit_are_0_beside_others() {
        let single: MetallicPhong<One> = One::lobe(2.0, Metallic).expect("n");
        let wide: PhongLobe<Wide, Mirror, _> = Wide::lobe(2.0, Metallic).expect("n");
        same(&single, &wide);
        let single: Phong<One> = One::lobe(2.0, Flat).expect("n");
        let wide: PhongLobe<Wide, Mirror, _> = Wide::lobe(2.0, Flat).expect("n");
        same(&single, &wide);
    }
}
