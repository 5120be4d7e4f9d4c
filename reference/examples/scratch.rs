//! scratch
use microbrdf_reference::*;
use models::*;
use quadrature::*;
fn main() {
    let m = PatchElliptic::new(0.4, 0.5).unwrap();
    for d in [0.0, 30.0, 60.0, 85.0, 89.9] {
        for phi in [25.0] {
            let l = Direction::from_degrees(d, phi);
            let a = albedo::directional_albedo_for(&m, &l, Accuracy::FINE);
            // brute force plane
            let n = 2000;
            let mut s = 0u64;
            for i in 0..n {
                for j in 0..n {
                    let x = -1.0 + 2.0 * (i as f64 + 0.5) / n as f64;
                    let y = -1.0 + 2.0 * (j as f64 + 0.5) / n as f64;
                    if x * x + y * y < 1.0 {
                        let u = 0.5 * (x + l.x);
                        let w = y + l.y;
                        if u * u + w * w <= 0.16 {
                            s += 1;
                        }
                    }
                }
            }
            let b = s as f64 * 4.0 / (n * n) as f64 * m.peak();
            println!("{d} {phi} {a:?} brute {b}");
        }
    }
    let m = ToblerPower::new(10.0).unwrap();
    for d in [0.0, 30.0, 60.0, 85.0, 89.9] {
        println!("tobler {d} {:?}", directional_albedo_at(&m, d));
    }
    for e in ALL {
        if let Some(s) = e.sampler {
            for d in [0.0, 30.0, 60.0, 85.0, 89.9] {
                let v = Direction::from_degrees(d, 25.0);
                s(v, &mut |b, s| {
                    let mut ch = b.chart(&v);
                    ch.edges.push(0.1);
                    let h = hemisphere(
                        &v,
                        &ch,
                        false,
                        Accuracy {
                            tolerance: 1e-9,
                            outer_panels: 100,
                            inner_panels: 60,
                        },
                        &|l, o| b.creases(&v, l, o),
                        &|l| if l.z > 0.0 { s.pdf(l) / l.z } else { 0.0 },
                    );
                    if h.value > 1.0 + 1e-6 {
                        println!("{} {d} {:?}", e.name, h);
                    }
                });
            }
        }
    }
}
