//! How a kernel is called, and what is known of it.

#[cfg(not(target_os = "none"))]
use crate::sphere_row::{HIGH, Tile, WIDE};

/// Three components of 32 bits, an `f32` or a fixed-point number, behind a
/// pointer.
pub type Vector<'a> = &'a [u32; 3];

/// Three components of 16 bits, by value.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Short {
    /// First component.
    pub x: i16,
    /// Second component.
    pub y: i16,
    /// Third component.
    pub z: i16,
}

/// N, L and V of 16 bits, by value: without gaps, which Arm's cores are given in
/// the words of [`Shorts`].
#[cfg(target_arch = "arm")]
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Three {
    /// N.
    pub n: Short,
    /// L.
    pub l: Short,
    /// V.
    pub v: Short,
}

/// N, L and V of 16 bits without gaps: words of two components each, the first in
/// the lower half, and of the last one.
#[cfg(not(target_os = "none"))]
pub type Shorts = extern "C" fn(u32, u32, u32, u32, u32) -> u64;

#[cfg(not(target_arch = "arm"))]
impl Short {
    /// N, L and V of a call's words.
    #[inline(always)]
    #[must_use]
    pub fn of_words([a, b, c, d, e]: [u32; 5]) -> [Self; 3] {
        let (low, high) = (|word: u32| word as i16, |word: u32| (word >> 16) as i16);
        let short = |x, y, z| Self { x, y, z };
        [
            short(low(a), high(a), low(b)),
            short(high(b), low(c), high(c)),
            short(low(d), high(d), low(e)),
        ]
    }
}

#[cfg(not(target_os = "none"))]
impl Short {
    /// From the components' bits.
    fn new([x, y, z]: [u32; 3]) -> Self {
        let [x, y, z] = [x, y, z].map(|bits| bits as i16);
        Self { x, y, z }
    }

    /// The words that a call passes it in.
    fn words(self) -> [u32; 2] {
        let low = |component: i16| u32::from(component as u16);
        [low(self.x) | low(self.y) << 16, low(self.z)]
    }
}

/// Linear red, green and blue, 24 fraction bits.
pub type Light = [u32; 3];

/// A kernel's signature, with the function.
#[cfg(not(target_os = "none"))]
#[derive(Clone, Copy, Debug)]
pub enum Call {
    /// L and V in the shading frame to one channel.
    Grey(for<'a> extern "C" fn(Vector<'a>, Vector<'a>) -> u32),
    /// L and V in the shading frame to three channels.
    Colour(for<'a> extern "C" fn(Vector<'a>, Vector<'a>, &mut Light)),
    /// N, L and V in world space to three channels, or three numbers.
    World(for<'a> extern "C" fn(Vector<'a>, Vector<'a>, Vector<'a>, &mut Light)),
    /// As [`Self::Grey`], with components of 16 bits.
    ShortGrey(extern "C" fn(Short, Short) -> u32),
    /// As [`Self::Colour`], with components of 16 bits.
    ShortColour(extern "C" fn(Short, Short, &mut Light)),
    /// As [`Self::ShortColour`], to three channels of 16 bits in two registers.
    ShortPacked(extern "C" fn(Short, Short) -> u64),
    /// One channel of that.
    ShortSingle(extern "C" fn(Short, Short) -> u32),
    /// As [`Self::ShortWorld`], to such channels.
    ShortWorldPacked(extern "C" fn(Short, Short, Short) -> u64),
    /// The same in fewer words.
    ShortsPacked(Shorts),
    /// As [`Self::World`], with components of 16 bits.
    ShortWorld(extern "C" fn(Short, Short, Short, &mut Light)),
    /// The upper 16 of a number's 24 bits to a number.
    Half(extern "C" fn(u16) -> u32),
    /// As [`Self::Half`], the same for three channels.
    Halves(extern "C" fn(u16, u16, u16) -> u32),
    /// A point in the middle, as [`Self::Number`] takes one, to rows of pixels under
    /// a light, 14 fraction bits.
    Rows(extern "C" fn(u32, &mut Tile), [i16; 3]),
    /// A number to a number.
    Number(extern "C" fn(u32) -> u32),
}

/// A kernel and what it computes.
#[cfg(not(target_os = "none"))]
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Its symbol.
    pub name: &'static str,
    /// The arithmetic whose directions it takes.
    pub arithmetic: &'static str,
    /// What sets it apart from others of the same arithmetic.
    pub variant: &'static str,
    /// The model, as in material files; or a step's name.
    pub model: &'static str,
    /// The material's fields, as in material files.
    pub fields: &'static str,
    /// Exponent of a lobe that is about as wide: where samples are taken.
    pub width: f64,
    /// The exposure, in words: `1` or `c`.
    pub exposure: &'static str,
    /// The exposure K.
    pub k: f64,
    /// The function.
    pub call: Call,
}

/// What a kernel is given: words in the order of its parameters.
#[cfg(not(target_os = "none"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Input {
    /// N, L and V, or of these what the kernel takes; or its number in the
    /// first place.
    pub vectors: [[u32; 3]; 3],
}

/// Registers and memory of a call, for an emulator.
#[cfg(not(target_os = "none"))]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// Words of the arguments, in order.
    pub arguments: Vec<u32>,
    /// Words that lie in memory from the base on.
    pub memory: Vec<u32>,
    /// What comes back: in the result's register, or from the memory after
    /// the given words.
    pub results: Vec<u32>,
    /// Whether it comes back in memory.
    pub in_memory: bool,
}

#[cfg(not(target_os = "none"))]
impl Kernel {
    /// Whether the kernel takes N beside L and V.
    #[must_use]
    pub fn takes_normal(&self) -> bool {
        matches!(
            self.call,
            Call::World(_)
                | Call::ShortWorld(_)
                | Call::ShortWorldPacked(_)
                | Call::ShortsPacked(_)
        )
    }

    /// The linear light of a call's results, 24 fraction bits: of 16 bits the
    /// middle of a step.
    #[must_use]
    pub fn light(&self, results: &[u32]) -> Vec<u32> {
        match (self.call, results) {
            (
                Call::ShortPacked(_) | Call::ShortWorldPacked(_) | Call::ShortsPacked(_),
                &[first, second],
            ) => [first, first >> 16, second].map(middle).to_vec(),
            (Call::ShortSingle(_), &[only]) => vec![middle(only)],
            _ => results.to_vec(),
        }
    }

    /// How many pixels a call shades.
    #[must_use]
    pub fn pixels(&self) -> usize {
        match self.call {
            Call::Rows(..) => WIDE * HIGH,
            _ => 1,
        }
    }

    /// Calls the kernel here, and says how an emulator would call it with its
    /// memory at `base`.
    #[must_use]
    pub fn run(&self, input: &Input, base: u32) -> Run {
        let [n, l, v] = &input.vectors;
        let mut light = Light::default();
        let pointers = |count: u32| (0..=count).map(|i| base + 12 * i).collect();
        let (arguments, memory, results) = match self.call {
            Call::Grey(function) => {
                let result = function(l, v);
                (vec![base, base + 12], [*l, *v].concat(), vec![result])
            }
            Call::Colour(function) => {
                function(l, v, &mut light);
                (pointers(2), [*l, *v].concat(), light.to_vec())
            }
            Call::World(function) => {
                function(n, l, v, &mut light);
                (pointers(3), [*n, *l, *v].concat(), light.to_vec())
            }
            Call::ShortGrey(function) => {
                let [l, v] = [*l, *v].map(Short::new);
                let words = [l, v].map(Short::words).concat();
                (words, Vec::new(), vec![function(l, v)])
            }
            Call::ShortColour(function) => {
                let [l, v] = [*l, *v].map(Short::new);
                function(l, v, &mut light);
                let words = [l, v].map(Short::words).concat();
                ([words, vec![base]].concat(), Vec::new(), light.to_vec())
            }
            Call::ShortPacked(function) => {
                let [l, v] = [*l, *v].map(Short::new);
                let words = [l, v].map(Short::words).concat();
                (words, Vec::new(), halves(function(l, v)))
            }
            Call::ShortSingle(function) => {
                let [l, v] = [*l, *v].map(Short::new);
                let words = [l, v].map(Short::words).concat();
                (words, Vec::new(), vec![function(l, v)])
            }
            Call::ShortWorldPacked(function) => {
                let [n, l, v] = input.vectors.map(Short::new);
                let words = [n, l, v].map(Short::words).concat();
                (words, Vec::new(), halves(function(n, l, v)))
            }
            Call::ShortsPacked(function) => {
                let component = |i: usize| input.vectors.as_flattened()[i] as u16;
                let word =
                    |i: usize| u32::from(component(2 * i)) | u32::from(component(2 * i + 1)) << 16;
                let [a, b, c, d] = [0, 1, 2, 3].map(word);
                let e = u32::from(component(8));
                (
                    vec![a, b, c, d, e],
                    Vec::new(),
                    halves(function(a, b, c, d, e)),
                )
            }
            Call::ShortWorld(function) => {
                let [n, l, v] = input.vectors.map(Short::new);
                function(n, l, v, &mut light);
                let words = [n, l, v].map(Short::words).concat();
                ([words, vec![base]].concat(), Vec::new(), light.to_vec())
            }
            Call::Half(function) => {
                let half = (n[0] >> 8).min(0xFFFF);
                (vec![half], Vec::new(), vec![function(half as u16)])
            }
            Call::Halves(function) => {
                let half = (n[0] >> 8).min(0xFFFF);
                let result = function(half as u16, half as u16, half as u16);
                (vec![half; 3], Vec::new(), vec![result])
            }
            Call::Rows(function, _) => {
                let mut pixels = [[0; WIDE]; HIGH];
                function(n[0], &mut pixels);
                let words = pixels
                    .as_flattened()
                    .chunks(2)
                    .map(|pair| u32::from(pair[0]) | u32::from(pair[1]) << 16);
                (vec![n[0], base], Vec::new(), words.collect())
            }
            Call::Number(function) => (vec![n[0]], Vec::new(), vec![function(n[0])]),
        };
        Run {
            arguments,
            memory,
            in_memory: results.len() > 2,
            results,
        }
    }
}

/// The middle of a step of 16 bits, with 24.
#[cfg(not(target_os = "none"))]
fn middle(channel: u32) -> u32 {
    (channel & 0xFFFF) << 8 | 0x80
}

/// The words of a result in two registers.
#[cfg(not(target_os = "none"))]
fn halves(packed: u64) -> Vec<u32> {
    vec![packed as u32, (packed >> 32) as u32]
}
