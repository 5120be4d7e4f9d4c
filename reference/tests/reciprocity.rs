//! f(L, V) = f(V, L) for every model that claims it, and a counter-example for the others.

use microbrdf_reference::Direction;
use microbrdf_reference::models::ALL;
use microbrdf_reference::sampling::Random;

/// Pairs all over the hemisphere, near the mirror direction, near the light, and grazing.
fn pairs() -> Vec<(Direction, Direction)> {
    let mut random = Random::new(7);
    let mut pairs = Vec::new();
    for i in 0..2000 {
        let l = Direction::from_cosine(random.uniform(), 6.3 * random.uniform());
        let mut v = Direction::from_cosine(random.uniform(), 6.3 * random.uniform());
        let near = 10f64.powf(-6.0 * random.uniform());
        let centre = match i % 4 {
            0 => None,
            1 => Some(l),
            2 => Some(l.mirrored()),
            _ => Some(Direction::from_cosine(near, 6.3 * random.uniform())),
        };
        if let Some(c) = centre {
            let step = |x: f64, r: f64| x + near * (r - 0.5);
            v = Direction::new(
                step(c.x, random.uniform()),
                step(c.y, random.uniform()),
                (c.z + near * 0.5 * random.uniform()).abs(),
            )
            .normalised();
        }
        pairs.push((l, v));
    }
    pairs
}

#[test]
fn models_that_claim_reciprocity_have_it_to_1e_12() {
    let pairs = pairs();
    for entry in ALL.iter().filter(|m| m.reciprocal) {
        for example in (entry.examples)() {
            let mut seen = 0;
            for (l, v) in &pairs {
                let (a, b) = (example.model.eval_rgb(l, v), example.model.eval_rgb(v, l));
                for i in 0..3 {
                    let scale = a[i].abs().max(b[i].abs());
                    assert!(
                        (a[i] - b[i]).abs() <= 1e-12 * scale,
                        "{} ({}): {l:?} {v:?}: {} {}",
                        entry.name,
                        example.parameters,
                        a[i],
                        b[i]
                    );
                    seen += usize::from(scale > 0.0);
                }
            }
            let dark = entry.name == "mirror";
            assert!(
                dark || seen > 30,
                "{}: only {seen} pairs are not 0",
                entry.name
            );
        }
    }
}

#[test]
fn models_that_do_not_claim_it_have_a_counter_example() {
    let pairs = pairs();
    let mut names = Vec::new();
    for entry in ALL.iter().filter(|m| !m.reciprocal) {
        names.push(entry.name);
        for example in (entry.examples)() {
            let found = pairs.iter().any(|(l, v)| {
                let (a, b) = (example.model.eval(l, v), example.model.eval(v, l));
                a > 0.0 && (a / b - 1.0).abs() > 0.1
            });
            assert!(found, "{}: reciprocal after all?", entry.name);
        }
    }
    assert_eq!(names, ["blinn_original", "phong_original"]);
}
