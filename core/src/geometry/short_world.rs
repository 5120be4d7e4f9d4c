//! World space in 16 bits, by sums of products.

use super::{Direction, Geometry, ShadingFrame};
use crate::arithmetic::short::{product_of_cosines, sum_of_products};
use crate::arithmetic::{Arithmetic as _, Q15};

/// From the fraction bits of a sum of two components' products to a cosine's.
const COSINE_SHIFT: u32 = 2;

/// N, L and V in world space as [`World`](super::World) has them, for the 16-bit
/// directions of [`Q15`]: 1 − R·V and m² are made of sums of products that are
/// exact in integers, not coordinate by coordinate.
///
/// It is quicker on every core that is measured (1 − R·V in `docs/trade.md`), and tells
/// less of an N whose length is wrong: from 2⁻¹³ off on the light is any. 1 − R·V and m²
/// are within 2⁻²⁴ and 2.4e-4 of their values; `tests` here. Components may have any bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShortWorld<const KNOTS: usize = 129> {
    normal: Direction<Q15<KNOTS>>,
    l: Direction<Q15<KNOTS>>,
    v: Direction<Q15<KNOTS>>,
    products: (i32, i32),
}

impl<const KNOTS: usize> ShortWorld<KNOTS> {
    /// The pair of `l`, to the light, and `v`, to the viewer, at a surface
    /// with normal `n`.
    #[inline(always)]
    pub fn new(
        n: Direction<Q15<KNOTS>>,
        l: Direction<Q15<KNOTS>>,
        v: Direction<Q15<KNOTS>>,
    ) -> Self {
        let products = if cfg!(long_multiply) {
            products
        } else {
            products_by_sum
        };
        Self {
            normal: n,
            l,
            v,
            products: products(n.bits(), l.bits(), v.bits()),
        }
    }

    /// |L + V|²|N|² − 4p, for 4p, with 28 fraction bits: sums of products of components
    /// are exact, so that nothing cancels that was rounded. With p = (N·L)(N·V) it is
    /// twice 1 − R·V, with p = ((N·L + N·V)/2)² it is m², of an N as long as it is; the
    /// square of that length is within 2.4e-4 of 1. Never negative.
    #[inline(always)]
    fn without(&self, four_p: i32) -> u32 {
        let (n, l, v) = (&self.normal, &self.l, &self.v);
        let sum = |a, b| Q15::<KNOTS>::sum(a, b);
        let square = Q15::<KNOTS>::square([sum(l.z, v.z), sum(l.y, v.y), sum(l.x, v.x)]) as i32;
        // |N|² − 1, of a length within 2⁻¹⁴ of 1 below 2⁻¹²: 16 bits, of which the last has 27
        // fraction bits.
        let excess = (sum_of_products(n.bits(), n.bits()) << 15) >> 16;
        let scaled = square.wrapping_add(((square >> 16) * excess) >> 11);
        scaled.wrapping_sub(four_p).max(0) as u32
    }
}

impl<const KNOTS: usize> Geometry<Q15<KNOTS>> for ShortWorld<KNOTS> {
    #[inline(always)]
    fn cosines(&self) -> (i32, i32) {
        (cosine(self.products.0), cosine(self.products.1))
    }

    #[inline(always)]
    fn versine(&self) -> u32 {
        let (a, b) = self.products;
        // 28 fraction bits of 4p are 30 of p, of which 26 are formed.
        self.without(product_of_cosines::<26>(a, b) << 4)
    }

    #[inline(always)]
    fn retro_versine(&self) -> u32 {
        super::retro_versine(&self.l, &self.v)
    }

    #[inline(always)]
    fn separation(&self) -> u32 {
        let height = self.products.0.wrapping_add(self.products.1);
        // Of m² a root is taken, which shows its last bits.
        self.without(product_of_cosines::<28>(height, height))
    }
}

/// What else a lobe in look-ups alone
/// ([`DirectPhong`](crate::brdf::DirectPhong)) asks of two 16-bit directions.
pub trait Products<const KNOTS: usize>: Geometry<Q15<KNOTS>> {
    /// Whether [`Geometry::versine`] takes so long that a core without a long
    /// multiply had better ask first whether anything is lit.
    const DEAR: bool;

    /// N·L and N·V with 28 fraction bits.
    fn products(&self) -> (i32, i32);
}

impl<const KNOTS: usize> Products<KNOTS> for ShortWorld<KNOTS> {
    const DEAR: bool = true;

    #[inline(always)]
    fn products(&self) -> (i32, i32) {
        self.products
    }
}

impl<const KNOTS: usize> Products<KNOTS> for ShadingFrame<Q15<KNOTS>> {
    const DEAR: bool = false;

    #[inline(always)]
    fn products(&self) -> (i32, i32) {
        let (n_dot_l, n_dot_v) = self.cosines();
        (n_dot_l >> COSINE_SHIFT, n_dot_v >> COSINE_SHIFT)
    }
}

#[inline(always)]
fn cosine(product: i32) -> i32 {
    product << COSINE_SHIFT
}

/// N·L and N·V.
#[inline(always)]
fn products(n: [i32; 3], l: [i32; 3], v: [i32; 3]) -> (i32, i32) {
    (sum_of_products(n, l), sum_of_products(n, v))
}

/// The same bits, N·V as N·(L + V) − N·L: of V nothing is kept then beside its sum
/// with L.
#[inline(always)]
fn products_by_sum(n: [i32; 3], l: [i32; 3], v: [i32; 3]) -> (i32, i32) {
    let both = [l[0] + v[0], l[1] + v[1], l[2] + v[2]];
    let n_dot_l = sum_of_products(n, l);
    let n_dot_v = sum_of_products(n, both).wrapping_sub(n_dot_l);
    (n_dot_l, n_dot_v)
}

#[cfg(test)]
mod tests {
    use fixed::types::I2F14;

    use super::{ShortWorld, cosine, products_by_sum};
    use crate::arithmetic::{Arithmetic as _, Q15};
    use crate::geometry::{Direction, Geometry as _, World};

    type A = Q15;

    fn direction([x, y, z]: [i16; 3]) -> Direction<A> {
        let [x, y, z] = [x, y, z].map(I2F14::from_bits);
        Direction::new(x, y, z)
    }

    fn dot(a: [i16; 3], b: [i16; 3]) -> i128 {
        (0..3).map(|i| i128::from(a[i]) * i128::from(b[i])).sum()
    }

    /// |h|²·|N|² − 4(N·L)(N·V) over |N|², and |h|² − (N·h)²/|N|²: of any lengths,
    /// exact, in units of 2⁻²⁸.
    fn exact(n: [i16; 3], l: [i16; 3], v: [i16; 3]) -> [f64; 2] {
        let (a, b, nn) = (dot(n, l), dot(n, v), dot(n, n));
        let square = dot(l, l) + dot(v, v) + 2 * dot(l, v);
        [4 * a * b, (a + b) * (a + b)].map(|part| (square * nn - part) as f64 / nn as f64)
    }

    fn found(n: [i16; 3], l: [i16; 3], v: [i16; 3]) -> [u32; 2] {
        let world = ShortWorld::new(direction(n), direction(l), direction(v));
        [world.versine(), world.separation()]
    }

    /// A number in (−1, 1).
    fn draw(state: &mut u64) -> f64 {
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (*state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn unit(c: [f64; 3]) -> [f64; 3] {
        let length = c.iter().map(|c| c * c).sum::<f64>().sqrt();
        c.map(|c| c / length)
    }

    /// Of a length within 2⁻¹⁴ of 1, rounded.
    fn rounded(c: [f64; 3], off: f64) -> [i16; 3] {
        c.map(|c| (c * (1.0 + off / 16_384.0) * 16_384.0).round() as i16)
    }

    /// Both are what integers of any width give: for directions anywhere, for
    /// those near the mirror direction, and for lengths that are off.
    #[test]
    fn world_space_loses_no_digits() {
        let mut state = 7;
        let (mut worst, mut exactly, mut skipped) = ([0.0f64; 2], 0, 0);
        for i in 0..200_000 {
            let vector = |state: &mut u64| unit([draw(state), draw(state), draw(state)]);
            let (n, l) = (vector(&mut state), vector(&mut state));
            let cosine: f64 = (0..3).map(|i| n[i] * l[i]).sum();
            let near = 0.5f64.powi(i % 15);
            let aside = vector(&mut state);
            let v = unit([0, 1, 2].map(|i| 2.0 * cosine * n[i] - l[i] + near * aside[i]));
            let [n, l, v] = [n, l, v].map(|c| rounded(c, draw(&mut state)));
            if [n, l, v]
                .iter()
                .any(|c| (dot(*c, *c) - (1 << 28)).abs() > 1 << 16)
            {
                skipped += 1;
                continue;
            }
            let (found, swapped) = (found(n, l, v), found(n, v, l));
            assert_eq!(found, swapped, "{n:?}, {l:?}, {v:?}");
            let pairs = found.into_iter().zip(exact(n, l, v));
            for ((found, exact), worst) in pairs.zip(&mut worst) {
                let off = (f64::from(found) - exact).abs() - exact * 2.4e-4;
                *worst = worst.max(off);
                exactly += u32::from(off <= 64.0);
            }
        }
        // 2⁻²⁸ each.
        assert!((16.0..=32.0).contains(&worst[0]), "{worst:?}");
        assert!((4.0..=16.0).contains(&worst[1]), "{worst:?}");
        assert!(exactly > 100_000 && skipped == 0, "{exactly}, {skipped}");
    }

    /// Mirrored, grazing, along the normal, opposite, and where L + V has a
    /// component of 2.
    #[test]
    fn world_space_at_its_corners() {
        const ONE: i16 = 1 << 14;
        let axes = [
            [ONE, 0, 0],
            [0, ONE, 0],
            [0, 0, ONE],
            [-ONE, 0, 0],
            [0, -ONE, 0],
            [0, 0, -ONE],
            // 3-4-5, in the steps of a component almost a unit vector.
            [9_830, 0, 13_107],
            [-9_830, 0, 13_107],
            [1, 0, ONE],
            [ONE, 0, 1],
            [-ONE, 0, 1],
        ];
        for n in axes {
            for l in axes {
                for v in axes {
                    let close = dot(n, n) == 1 << 28;
                    for (found, exact) in found(n, l, v).into_iter().zip(exact(n, l, v)) {
                        let off = (f64::from(found) - exact).abs();
                        let most = if close {
                            64.0
                        } else {
                            96.0 + exact.abs() * 2e-4
                        };
                        assert!(off <= most, "{n:?}, {l:?}, {v:?}: {found} for {exact}");
                    }
                }
            }
        }
        for axis in axes.into_iter().take(6) {
            assert_eq!(found(axis, axis, axis), [0, 0]);
        }
        // 1 − R·V = 2 with 29 fraction bits.
        assert_eq!(found([0, 0, ONE], [ONE, 0, 0], [ONE, 0, 0])[0], 1 << 30);
    }

    /// Directions of any length: overflow checks are on.
    #[test]
    fn nothing_wraps_unasked() {
        let ends = [i16::MIN, -16_384, -1, 0, 1, 12_345, i16::MAX];
        let all = || ends.into_iter().flat_map(|x| ends.map(|y| [x, y, 777]));
        for n in all() {
            for l in all() {
                for v in all() {
                    let (found, swapped) = (found(n, l, v), found(n, v, l));
                    if [dot(n, l), dot(n, v)].iter().all(|dot| dot.abs() < 1 << 29) {
                        assert_eq!(found, swapped);
                    }
                    let [n, l, v] = [n, l, v].map(direction);
                    let (by_sum, dots) = (
                        products_by_sum(n.bits(), l.bits(), v.bits()),
                        [A::dot(&n, &l), A::dot(&n, &v)],
                    );
                    assert_eq!([by_sum.0, by_sum.1].map(cosine), dots);
                    let world = ShortWorld::new(n, l, v);
                    assert_eq!(world.cosines(), (dots[0], dots[1]));
                    let retro = World::new(n, l, v).retro_versine();
                    assert_eq!(world.retro_versine(), retro);
                }
            }
        }
    }
}
