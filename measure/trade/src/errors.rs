//! Arithmetic error of a kernel's displayed code.

use microbrdf::shade::srgb8;
use microbrdf_kernels::{Input, Kernel};
use microbrdf_tests::domain::{Pair, Set};
use serde::{Deserialize, Serialize};

use crate::subject::Subject;

/// Pairs in each set.
const COUNT: usize = 2000;

/// A set of samples, as `trade.json` names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Samples {
    /// A set of the tests.
    Whole(Set),
    /// `lobe`, where the larger cosine is at least 1e-3; for world-space
    /// kernels both.
    Usual,
}

impl Samples {
    /// All of them.
    pub const ALL: [(&'static str, Self); 6] = [
        ("lobe", Self::Whole(Set::Lobe)),
        ("lobe, cosines from 1e-3", Self::Usual),
        ("mirror", Self::Whole(Set::Mirror)),
        ("grazing", Self::Whole(Set::Grazing)),
        ("random", Self::Whole(Set::Random)),
        ("outside", Self::Whole(Set::Outside)),
    ];

    /// `count` pairs for a subject's lobe.
    #[must_use]
    pub fn pairs(self, subject: &Subject, count: usize) -> Vec<Pair> {
        let kernel = subject.kernel;
        // Beyond τ = 9 + ln K the code is 0.
        let reach = 9.0 + kernel.k.max(1.0).ln();
        let mut pairs = match self {
            Self::Whole(set) => set.pairs(kernel.width, reach, count),
            // 3/8 of the logarithms of cosines are from −3 to 0.
            Self::Usual => Set::Lobe
                .pairs(kernel.width, reach, 8 * count)
                .into_iter()
                .filter(|[l, v]| {
                    // World space does not resolve cosines near 0: one of
                    // them falls on either side of the horizon.
                    let counts = if kernel.takes_normal() {
                        l[2].min(v[2])
                    } else {
                        l[2].max(v[2])
                    };
                    counts >= 1e-3
                })
                .take(count)
                .collect(),
        };
        if kernel.model == "retro-phong" {
            // Its lobe is about L, where the others' is about R.
            for [_, v] in &mut pairs {
                *v = [-v[0], -v[1], v[2]];
            }
        }
        pairs
    }
}

/// The errors over one set, in codes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// The set.
    pub samples: String,
    /// Greatest |code − 255 · encoded reference|.
    pub lsb_error_max: f64,
    /// Greatest |code − rounded encoded reference|.
    pub code_error_max: u8,
    /// Share of codes off by one, of those whose exact code is 1 … 254.
    pub code_error_share: f64,
    /// Share of codes off by more.
    pub code_error_over_one_share: f64,
}

/// The errors of the encoding of one channel, over every 61st linear value.
#[must_use]
pub fn encoding(kernel: &Kernel) -> Errors {
    let mut tally = Tally::new("lobe");
    for linear in (0..=1 << 24).step_by(61) {
        let mut input = Input::default();
        input.vectors[0][0] = linear;
        let exact = f64::from(linear) / f64::from(1 << 24);
        let code = kernel.run(&input, 0).results[0] as u8;
        tally.add(code, 255.0 * microbrdf_reference::encode_srgb(exact));
    }
    tally.errors()
}

/// The errors of a kernel over every set.
#[must_use]
pub fn measure(subject: &Subject) -> Vec<Errors> {
    Samples::ALL
        .into_iter()
        .filter(|(name, _)| {
            !subject.kernel.takes_normal()
                || !matches!(*name, "lobe" | "mirror" | "grazing" | "random")
        })
        .map(|(name, samples)| {
            let pairs = samples.pairs(subject, COUNT);
            over(subject, name, &pairs)
        })
        .collect()
}

fn over(subject: &Subject, name: &str, pairs: &[Pair]) -> Errors {
    let mut tally = Tally::new(name);
    for input in subject.inputs(pairs) {
        let exact = subject.codes(&input);
        let results = subject.kernel.run(&input, 0).results;
        for (linear, exact) in subject.kernel.light(&results).into_iter().zip(exact) {
            tally.add(srgb8(linear), exact);
        }
    }
    tally.errors()
}

/// Errors, being counted.
pub(crate) struct Tally {
    errors: Errors,
    counted: u32,
    one: u32,
    more: u32,
}

impl Tally {
    pub(crate) fn new(samples: &str) -> Self {
        let errors = Errors {
            samples: samples.to_owned(),
            ..Errors::default()
        };
        Self {
            errors,
            counted: 0,
            one: 0,
            more: 0,
        }
    }

    fn add(&mut self, code: u8, exact: f64) {
        self.add_level(code, exact, u8::MAX);
    }

    /// A level of a display that has them up to `greatest`.
    pub(crate) fn add_level(&mut self, code: u8, exact: f64, greatest: u8) {
        let errors = &mut self.errors;
        let rounded = exact.round() as u8;
        errors.lsb_error_max = errors.lsb_error_max.max((f64::from(code) - exact).abs());
        let steps = code.abs_diff(rounded);
        errors.code_error_max = errors.code_error_max.max(steps);
        if (1..greatest).contains(&rounded) {
            self.counted += 1;
            self.one += u32::from(steps == 1);
            self.more += u32::from(steps > 1);
        }
    }

    pub(crate) fn errors(self) -> Errors {
        let counted = f64::from(self.counted.max(1));
        Errors {
            code_error_share: f64::from(self.one) / counted,
            code_error_over_one_share: f64::from(self.more) / counted,
            ..self.errors
        }
    }
}
