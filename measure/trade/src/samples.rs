//! The calls that an emulated core is to make, with what they must give.

use microbrdf_kernels::{Input, Kernel};
use microbrdf_tests::domain::Set;
use serde::Serialize;

use crate::errors::Samples;
use crate::sphere::{self, Place};
use crate::subject::Subject;

/// Where a kernel's arguments lie in an emulated core's RAM.
pub const BASE: u32 = 0x2000_0000;

/// One kernel's calls.
#[derive(Debug, Serialize)]
pub struct Calls {
    /// Its symbol.
    pub kernel: &'static str,
    /// Calls, in groups.
    pub groups: Vec<Group>,
}

/// Calls of one kind.
#[derive(Debug, Serialize)]
pub struct Group {
    /// `lobe`, `beyond`, `unlit`, `other`.
    pub kind: &'static str,
    /// The calls.
    pub calls: Vec<Called>,
}

/// One call.
#[derive(Debug, Serialize)]
pub struct Called {
    /// Words of the arguments, in order.
    pub arguments: Vec<u32>,
    /// Words in memory from [`BASE`] on.
    pub memory: Vec<u32>,
    /// What must come back: in the result's register, or in memory behind.
    pub results: Vec<u32>,
    /// Whether it comes back in memory.
    pub in_memory: bool,
}

/// How many calls a kernel gets of those that a quick one gets: without an
/// FPU, a call in single precision takes ten thousand instructions.
#[must_use]
pub fn count(kernel: &Kernel, count: usize) -> usize {
    if kernel.model == "sphere light" {
        count / 4
    } else if kernel.arithmetic.starts_with('q') || kernel.arithmetic == "integer" {
        count
    } else {
        (count / 4).max(16)
    }
}

/// The calls of a kernel: those within the lobe, at cosines that a picture
/// has, whose mean is reported; those beyond it; those unlit; and others that
/// may be the longest. `count` in the first group, a fourth of it in each other.
#[must_use]
pub fn of(kernel: &'static Kernel, count: usize) -> Calls {
    let groups = match Subject::new(kernel) {
        Some(subject) => model(&subject, count),
        None if kernel.takes_normal() => directions(kernel, count),
        None if kernel.model.starts_with("sphere") => sphere(kernel, count),
        None => numbers(kernel, count),
    };
    Calls {
        kernel: kernel.name,
        groups,
    }
}

fn model(subject: &Subject, count: usize) -> Vec<Group> {
    let kernel = subject.kernel;
    let mut usual = Samples::Usual.pairs(subject, 8 * count);
    // A patch ends long before what is sampled.
    usual.retain(|pair| subject.is_lit(*pair));
    usual.truncate(count);
    // Every third pair of `Outside` lies beyond the lobe, the others below
    // the horizon.
    let outside = Samples::Whole(Set::Outside).pairs(subject, 3 * count);
    let (mut beyond, mut unlit) = (Vec::new(), Vec::new());
    for pair in outside {
        let lower = pair[0][2].min(pair[1][2]);
        if lower >= 0.0 {
            beyond.push(pair);
        } else if lower < -1e-3 {
            // A cosine nearer to 0 can round to it.
            unlit.push(pair);
        }
    }
    beyond.truncate(count / 4);
    unlit.truncate(count / 4);
    let mut other = Vec::new();
    for set in [Set::Mirror, Set::Grazing, Set::Random, Set::Lobe] {
        other.extend(Samples::Whole(set).pairs(subject, count / 16));
    }
    [
        ("lobe", usual),
        ("beyond", beyond),
        ("unlit", unlit),
        ("other", other),
    ]
    .into_iter()
    .map(|(kind, pairs)| group(kernel, kind, &subject.inputs(&pairs)))
    .collect()
}

/// Random directions in world space.
fn directions(kernel: &Kernel, count: usize) -> Vec<Group> {
    let gold = microbrdf_kernels::kernels().find(|other| {
        other.arithmetic == kernel.arithmetic && other.takes_normal() && !other.fields.is_empty()
    });
    let inputs = gold
        .and_then(Subject::new)
        .map(|subject| subject.inputs(&Set::Random.pairs(1.0, 1.0, count)))
        .unwrap_or_default();
    vec![group(kernel, "lobe", &inputs)]
}

/// Pixels of a sphere, evenly over what each group has.
fn sphere(kernel: &Kernel, count: usize) -> Vec<Group> {
    [
        ("lobe", Place::Lobe, count),
        ("beyond", Place::Beyond, count / 4),
        ("unlit", Place::Unlit, count / 4),
    ]
    .into_iter()
    .map(|(kind, place, count)| {
        let points = sphere::points(kernel, place);
        group(kernel, kind, &sphere::some(&points, count))
    })
    .collect()
}

/// Linear light, evenly over the codes that it becomes.
fn numbers(kernel: &Kernel, count: usize) -> Vec<Group> {
    let inputs: Vec<_> = (0..count)
        .map(|i| {
            let encoded = (i as f64 + 0.5) / count as f64;
            let linear = microbrdf_reference::decode_srgb(encoded);
            let mut input = Input::default();
            input.vectors[0][0] = (linear * f64::from(1 << 24)).round() as u32;
            input
        })
        .collect();
    vec![group(kernel, "lobe", &inputs)]
}

fn group(kernel: &Kernel, kind: &'static str, inputs: &[Input]) -> Group {
    let calls = inputs
        .iter()
        .map(|input| {
            let run = kernel.run(input, BASE);
            Called {
                arguments: run.arguments,
                memory: run.memory,
                results: run.results,
                in_memory: run.in_memory,
            }
        })
        .collect();
    Group { kind, calls }
}

/// The calls that sum up many of the core's results in each arithmetic, with
/// what this host gives.
#[must_use]
pub fn checksums() -> Vec<Calls> {
    microbrdf_checksum::CHECKSUMS
        .iter()
        .map(|(kernel, function)| Calls {
            kernel,
            groups: vec![Group {
                kind: "all",
                calls: vec![Called {
                    arguments: vec![0],
                    memory: Vec::new(),
                    results: vec![function(0)],
                    in_memory: false,
                }],
            }],
        })
        .collect()
}
