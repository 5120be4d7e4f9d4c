//! Directions of pixels of which some are not lit.

use microbrdf::arithmetic::Arithmetic;
use microbrdf::geometry::{Direction, Geometry, World};

use super::lanes::One;
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
        let lit = Lanes::of(|i| {
            if One::lit(n_dot_l.0[i], n_dot_v.0[i]) {
                n_dot_l.0[i]
            } else {
                0.0
            }
        });
        Self {
            world,
            cosines: (lit, n_dot_v),
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
