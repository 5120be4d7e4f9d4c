//! A view as the core takes it: spans, stored normals, and depths where they
//! are asked for.

use std::mem::size_of;

use microbrdf::geometry::Direction;
use microbrdf::shade::{Depths, MeshView, NoDepths, Octahedral, Span, StoredDepths, View};

use super::{SeenView, encode, greatest_error};
use crate::host::HostArithmetic;
use crate::material::Material;

/// What is left of a code for other errors, where normals are stored: three
/// quarters.
const MARGIN: f64 = 4.0;

/// A view in the numbers of `A`, owned.
#[derive(Clone, Debug, PartialEq)]
pub struct PreparedView<A: HostArithmetic> {
    /// For each row its first span, and the number of spans.
    pub rows: Vec<u32>,
    /// Spans.
    pub spans: Vec<Span>,
    /// A normal for each pixel of each span.
    pub normals: StoredNormals,
    /// Least depth, range and a code for each pixel, where a light asks.
    pub depths: Option<(A::Length, A::Length, Vec<u16>)>,
}

/// Normals, as finely as their materials need them.
#[derive(Clone, Debug, PartialEq)]
pub enum StoredNormals {
    /// Three bytes each.
    Three(Vec<[u8; 3]>),
    /// Four bytes each.
    Four(Vec<[i16; 2]>),
}

impl<A: HostArithmetic> PreparedView<A> {
    /// The table of a view; `lamps` tells whether a light asks for places.
    #[must_use]
    pub fn new(view: &SeenView, materials: &[(String, Material)], lamps: bool) -> Self {
        let mut rows = Vec::new();
        let mut spans = Vec::new();
        let mut seen = Vec::new();
        for row in view.pixels.chunks(view.width) {
            rows.push(spans.len() as u32);
            let runs = row.chunk_by(|a, b| a.map(|a| a.material) == b.map(|b| b.material));
            let mut start = 0;
            for run in runs {
                let end = start + run.len();
                if let Some(first) = run[0] {
                    let index = seen.len() as u32;
                    spans.push(Span::new(
                        start as u16,
                        end as u16,
                        index,
                        first.material as u8,
                    ));
                    seen.extend(run.iter().copied().flatten());
                }
                start = end;
            }
        }
        rows.push(spans.len() as u32);
        let tolerance = seen
            .iter()
            .map(|pixel| pixel.material)
            .collect::<std::collections::BTreeSet<_>>()
            .into_iter()
            .map(|index| tolerance(&materials[index].1))
            .fold(f64::INFINITY, f64::min);
        let normals = if tolerance >= MARGIN * greatest_error::<[u8; 3]>() {
            StoredNormals::Three(seen.iter().map(|pixel| encode(pixel.normal)).collect())
        } else {
            StoredNormals::Four(seen.iter().map(|pixel| encode(pixel.normal)).collect())
        };
        let depths = lamps.then(|| {
            let near = seen.iter().map(|s| s.depth).fold(f64::INFINITY, f64::min);
            let far = seen.iter().map(|s| s.depth).fold(0.0, f64::max);
            let near = if near.is_finite() { near } else { 0.0 };
            // So that the greatest depth has the last code.
            let (near, range) = (
                A::length(near),
                A::length((far - near) * 65_536.0 / 65_535.0),
            );
            let step = A::length_value(range) / 65_536.0;
            let code = |depth: f64| {
                let steps = (depth - A::length_value(near)) / step;
                // All at one depth: the step is 0.
                if steps.is_finite() {
                    steps.round() as u16
                } else {
                    0
                }
            };
            (near, range, seen.iter().map(|s| code(s.depth)).collect())
        });
        Self {
            rows,
            spans,
            normals,
            depths,
        }
    }

    /// Bytes of the tables.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let normals = match &self.normals {
            StoredNormals::Three(normals) => 3 * normals.len(),
            StoredNormals::Four(normals) => 4 * normals.len(),
        };
        let depths = self
            .depths
            .as_ref()
            .map_or(0, |(.., codes)| 2 * codes.len());
        4 * self.rows.len() + size_of::<Span>() * self.spans.len() + normals + depths
    }

    fn at(&self, x: usize, y: usize) -> Option<(A::Depth, Direction<A>, u8)> {
        match &self.normals {
            StoredNormals::Three(normals) => self.with_depths(normals, x, y),
            StoredNormals::Four(normals) => self.with_depths(normals, x, y),
        }
    }

    fn with_depths<N: Octahedral>(
        &self,
        normals: &[N],
        x: usize,
        y: usize,
    ) -> Option<(A::Depth, Direction<A>, u8)> {
        match &self.depths {
            None => self.with(normals, NoDepths, x, y),
            Some((near, range, codes)) => {
                let depths = StoredDepths::<A> {
                    near: *near,
                    range: *range,
                    codes,
                };
                self.with(normals, depths, x, y)
            }
        }
    }

    fn with<N: Octahedral, D: Depths<A>>(
        &self,
        normals: &[N],
        depths: D,
        x: usize,
        y: usize,
    ) -> Option<(A::Depth, Direction<A>, u8)> {
        let view = MeshView {
            rows: &self.rows,
            spans: &self.spans,
            normals,
            depths,
        };
        view.at(x, y)
    }
}

/// The core's view of a scene with meshes or without, chosen at run time.
#[derive(Clone, Copy, Debug)]
pub struct AnyView<'a, A: HostArithmetic>(pub Option<&'a PreparedView<A>>);

impl<A: HostArithmetic> View<A> for AnyView<'_, A> {
    #[inline]
    fn at(&self, x: usize, y: usize) -> Option<(A::Depth, Direction<A>, u8)> {
        self.0.and_then(|view| view.at(x, y))
    }
}

/// By how much a normal may be off, in radians, so that a share changes by at
/// most one code: 3.2e-3/√n for a lobe of exponent n, which falls by 1.21·√n a
/// radian of the normal where it is steepest. Of what is not known to fall so
/// slowly: 0.
fn tolerance(material: &Material) -> f64 {
    let lobe = |exponent: f64| 3.2e-3 / exponent.max(1.0).sqrt();
    let part = |part: &Material| match part {
        Material::Lambert { .. } => lobe(1.0),
        Material::Phong { exponent, .. } | Material::Metal { exponent, .. } => lobe(*exponent),
        _ => 0.0,
    };
    let parts = material.parts();
    parts
        .iter()
        .map(|(material, _)| part(material))
        .fold(f64::INFINITY, f64::min)
}
