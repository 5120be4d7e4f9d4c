//! Polar coordinates on the hemisphere that follow a model's lobe.

use crate::Direction;

/// What the polar coordinates are centred on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChartKind {
    /// V about N; radius t = tan(Θ/2).
    Cosine,
    /// V about R; radius t = tan(α/2).
    Mirror,
    /// V about L; radius t = tan(angle/2).
    Retro,
    /// H about N; radius t = tanδ.
    Half,
    /// V's projection about R's on the base plane; radius t = m.
    Plane,
    /// V's projection about L's on the base plane.
    RetroPlane,
}

/// A chart: where to look, at what scale, and at which radii f jumps or bends.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// The centre and the meaning of the radius.
    pub kind: ChartKind,
    /// The radius that belongs to the middle of the radial variable: the lobe's width.
    pub scale: f64,
    /// Radii at which f is not smooth.
    pub edges: Vec<f64>,
}

impl Chart {
    /// For broad models: polar coordinates about the normal.
    pub fn cosine() -> Self {
        Self::new(ChartKind::Cosine, 1.0)
    }

    /// A chart with the given width and no edges.
    pub fn new(kind: ChartKind, scale: f64) -> Self {
        Self {
            kind,
            scale: scale.clamp(1e-9, 1.0),
            edges: Vec::new(),
        }
    }

    /// The chart of a lobe cosⁿ about R or L, with the edge at 90°, where the lobe ends.
    pub fn power(kind: ChartKind, exponent: f64) -> Self {
        let mut chart = Self::new(kind, 0.7 / (exponent + 1.0).sqrt());
        chart.edges.push(1.0);
        chart
    }

    /// With edges at the given radii.
    pub fn with_edges(mut self, edges: &[f64]) -> Self {
        self.edges.extend_from_slice(edges);
        self
    }
}

impl Chart {
    /// The radius and azimuth (−π … π) of V in the chart placed at L. For L = N the azimuth
    /// is counted from +x.
    ///
    /// Azimuth 0 is towards the normal (Mirror, Retro), towards the middle of the base
    /// circle (Plane, RetroPlane) or towards L (Cosine, Half).
    pub fn coordinates(&self, l: &Direction, v: &Direction) -> (f64, f64) {
        let placed = Placed::new(self, l);
        let (cx, cy) = placed.e1;
        let (s, c) = (placed.sin_l, l.z);
        let (along, across) = (v.x * cx + v.y * cy, v.y * cx - v.x * cy);
        match self.kind {
            ChartKind::Cosine => {
                let sine = v.x.hypot(v.y);
                (sine / (1.0 + v.z), across.atan2(along))
            }
            ChartKind::Mirror | ChartKind::Retro => {
                let side = if self.kind == ChartKind::Mirror {
                    -1.0
                } else {
                    1.0
                };
                let (da, dz) = (along - side * s, v.z - c);
                let chord2 = da * da + across * across + dz * dz;
                let u = s * dz - side * c * da;
                ((chord2 / (4.0 - chord2)).max(0.0).sqrt(), across.atan2(u))
            }
            ChartKind::Half => {
                let h = (along + s, across, v.z + c);
                (h.0.hypot(h.1) / h.2, h.1.atan2(h.0))
            }
            ChartKind::Plane | ChartKind::RetroPlane => {
                let side = if self.kind == ChartKind::Plane {
                    -1.0
                } else {
                    1.0
                };
                let u = s - side * along;
                (u.hypot(across), across.atan2(u))
            }
        }
    }
}

/// A chart placed at a direction L.
pub(crate) struct Placed<'a> {
    chart: &'a Chart,
    l: Direction,
    /// Unit vector along L's projection, and the one at right angles to it.
    e1: (f64, f64),
    sin_l: f64,
    greatest: f64,
}

/// A point of a chart: the direction and the density of projected solid angle
/// per radius and azimuth.
pub(crate) struct Point {
    pub v: Direction,
    /// Positive above the horizon; a smooth function across it.
    pub above: f64,
    /// cosΘV dω = `measure` dq dφ, in the radial variable q of 0 … 1.
    pub measure: f64,
}

impl<'a> Placed<'a> {
    pub fn new(chart: &'a Chart, l: &Direction) -> Self {
        let sin_l = l.x.hypot(l.y);
        let e1 = if sin_l > 0.0 {
            (l.x / sin_l, l.y / sin_l)
        } else {
            (1.0, 0.0)
        };
        let greatest = match chart.kind {
            ChartKind::Cosine => 1.0,
            ChartKind::Plane | ChartKind::RetroPlane => 1.0 + sin_l,
            ChartKind::Mirror | ChartKind::Retro | ChartKind::Half => f64::INFINITY,
        };
        Self {
            chart,
            l: *l,
            e1,
            sin_l,
            greatest,
        }
    }

    /// The radius at q, its derivative; 0 … `greatest` for q = 0 … 1.
    fn radius(&self, q: f64) -> (f64, f64) {
        let s = self.chart.scale;
        if self.greatest.is_infinite() {
            let r = 1.0 - q;
            return (s * q / r, s / (r * r));
        }
        let r = s / self.greatest + 1.0 - q;
        (s * q / r, s * (s / self.greatest + 1.0) / (r * r))
    }

    /// The q that belongs to a radius, if it is inside.
    pub fn q_of_radius(&self, t: f64) -> Option<f64> {
        let s = self.chart.scale;
        let q = if self.greatest.is_infinite() {
            t / (s + t)
        } else {
            t * (s / self.greatest + 1.0) / (s + t)
        };
        (q > 0.0 && q < 1.0).then_some(q)
    }

    fn in_frame(&self, along: f64, across: f64, z: f64) -> Direction {
        let (cx, cy) = self.e1;
        Direction::new(along * cx - across * cy, along * cy + across * cx, z)
    }

    /// The circle of all points at radial variable q.
    pub fn circle(&self, q: f64) -> Circle<'_> {
        let (t, dt) = self.radius(q);
        let d = 1.0 + t * t;
        let (sine, versine, cosine) = match self.chart.kind {
            ChartKind::Cosine | ChartKind::Mirror | ChartKind::Retro => {
                (2.0 * t / d, 2.0 * t * t / d, (1.0 - t) * (1.0 + t) / d)
            }
            ChartKind::Half => (t / d.sqrt(), 0.0, 1.0 / d.sqrt()),
            ChartKind::Plane | ChartKind::RetroPlane => (t, 0.0, 0.0),
        };
        Circle {
            placed: self,
            d,
            dt,
            sine,
            versine,
            cosine,
        }
    }

    /// The point at radial variable q and azimuth φ about the centre.
    #[cfg(test)]
    pub fn at(&self, q: f64, phi: f64) -> Point {
        self.circle(q).at(phi)
    }
}

/// A circle about a chart's centre: what its points have in common.
pub(crate) struct Circle<'a> {
    placed: &'a Placed<'a>,
    /// 1 + t², and the derivative of t.
    d: f64,
    dt: f64,
    /// Of the angle from the centre; on the plane the first is the radius itself.
    sine: f64,
    versine: f64,
    cosine: f64,
}

impl Circle<'_> {
    /// The point at azimuth φ.
    pub fn at(&self, phi: f64) -> Point {
        self.toward(phi.sin_cos())
    }

    /// The point at the azimuth of this sine and cosine.
    pub fn toward(&self, (sin_phi, cos_phi): (f64, f64)) -> Point {
        let placed = self.placed;
        let (s, c) = (placed.sin_l, placed.l.z);
        let (sine, versine, cosine) = (self.sine, self.versine, self.cosine);
        match placed.chart.kind {
            ChartKind::Cosine => Point {
                v: placed.in_frame(sine * cos_phi, sine * sin_phi, cosine),
                above: cosine,
                measure: cosine * sine * 2.0 / self.d * self.dt,
            },
            ChartKind::Mirror | ChartKind::Retro => {
                let side = if placed.chart.kind == ChartKind::Mirror {
                    -1.0
                } else {
                    1.0
                };
                // axis = (side·s, 0, c); e = (−side·c, 0, s) is towards the normal.
                let (u, w) = (sine * cos_phi, sine * sin_phi);
                let along = side * (s * (1.0 - versine) - c * u);
                let z = c * (1.0 - versine) + s * u;
                Point {
                    v: placed.in_frame(along, w, z),
                    above: z,
                    measure: z * sine * 2.0 / self.d * self.dt,
                }
            }
            ChartKind::Half => {
                let h = (sine * cos_phi, sine * sin_phi, cosine);
                let lh = h.0 * s + h.2 * c;
                // V = 2 (L·H) H − L, so V.z = c cos 2δ + s cosφ sin 2δ.
                let z = c * (1.0 - 2.0 * sine * sine) + 2.0 * s * h.0 * cosine;
                let above = if lh > 0.0 { z } else { -1.0 };
                Point {
                    v: placed.in_frame(2.0 * lh * h.0 - s, 2.0 * lh * h.1, z),
                    above,
                    measure: z * 4.0 * lh * sine / self.d * self.dt,
                }
            }
            ChartKind::Plane | ChartKind::RetroPlane => {
                let side = if placed.chart.kind == ChartKind::Plane {
                    -1.0
                } else {
                    1.0
                };
                let t = sine;
                let (u, w) = (t * cos_phi, t * sin_phi);
                // φ = 0 points to the middle of the base circle.
                let above = c * c - t * t + 2.0 * s * u;
                Point {
                    v: placed.in_frame(side * (s - u), w, above.max(0.0).sqrt()),
                    above,
                    measure: t * self.dt,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_invert_the_points() {
        let l = Direction::from_degrees(55.0, 130.0);
        for kind in [
            ChartKind::Cosine,
            ChartKind::Mirror,
            ChartKind::Retro,
            ChartKind::Half,
            ChartKind::Plane,
            ChartKind::RetroPlane,
        ] {
            let chart = Chart::new(kind, 0.3);
            let placed = Placed::new(&chart, &l);
            for (q, phi) in [(0.2, 0.5), (0.4, -2.0), (0.1, 3.0)] {
                let point = placed.at(q, phi);
                assert!(point.above > 0.0);
                let (t, azimuth) = chart.coordinates(&l, &point.v);
                let (expected, _) = placed.radius(q);
                assert!((t - expected).abs() < 1e-12, "{kind:?}: {t} {expected}");
                assert!((azimuth - phi).abs() < 1e-11, "{kind:?}: {azimuth} {phi}");
            }
        }
    }

    #[test]
    fn the_measure_is_projected_solid_angle() {
        // Over a small cell the midpoint rule must give the same area in every chart.
        let l = Direction::from_degrees(35.0, 20.0);
        let v = Direction::from_degrees(50.0, 170.0);
        let (d, n) = (1e-4, v);
        for kind in [
            ChartKind::Cosine,
            ChartKind::Mirror,
            ChartKind::Half,
            ChartKind::Plane,
        ] {
            let chart = Chart::new(kind, 0.5);
            let placed = Placed::new(&chart, &l);
            let (t, phi) = chart.coordinates(&l, &n);
            let q = placed.q_of_radius(t).unwrap();
            let corner = |a: f64, b: f64| placed.at(q + a * d, phi + b * d).v;
            let (p, r, s) = (corner(-0.5, -0.5), corner(0.5, -0.5), corner(-0.5, 0.5));
            let area = ((r.x - p.x) * (s.y - p.y) - (r.y - p.y) * (s.x - p.x)).abs();
            let measure = placed.at(q, phi).measure * d * d;
            assert!(
                (area / measure - 1.0).abs() < 1e-3,
                "{kind:?}: {area} {measure}"
            );
        }
    }
}
