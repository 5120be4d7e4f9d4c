//! A bad line, on purpose.

use embedded_io::{ErrorType, Write};

use crate::bounded::Bounded;
use crate::format::MAX_WIRE;
use crate::wire::DELIMITER;

/// What is to go wrong, and how often.
///
/// Chances are in parts per million and hold for every packet by itself;
/// [`Faults::default`] is a perfect line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// Where the dice start. The same seed and the same bytes give the same damage.
    pub seed: u64,
    /// Chance that a packet does not arrive.
    pub drop_ppm: u32,
    /// Chance that a packet arrives twice.
    pub duplicate_ppm: u32,
    /// Chance that one bit of a packet is flipped; its delimiter may be hit too.
    pub flip_ppm: u32,
    /// Chance that one byte of a packet is lost; its delimiter may be hit too.
    pub lose_byte_ppm: u32,
    /// Number of bytes after which the line is dead.
    pub cut_after: Option<u64>,
}

/// What did go wrong.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Damage {
    /// Packets that passed through, hurt or not.
    pub packets: u64,
    /// Packets that did not arrive.
    pub dropped: u64,
    /// Packets that arrived twice.
    pub duplicated: u64,
    /// Packets with a flipped bit.
    pub flipped: u64,
    /// Packets with a byte lost.
    pub bytes_lost: u64,
    /// Bytes swallowed since the line is dead.
    pub bytes_cut: u64,
}

/// A sink that damages packets on their way to another one.
///
/// Bytes wait here until their delimiter comes, or until `flush`, which passes
/// on undamaged what has none.
pub struct FaultInjector<W> {
    sink: W,
    faults: Faults,
    damage: Damage,
    dice: Dice,
    passed: u64,
    packet: Bounded<MAX_WIRE>,
}

impl<W: Write> FaultInjector<W> {
    /// A line to `sink` with these faults.
    pub fn new(sink: W, faults: Faults) -> Self {
        Self {
            sink,
            faults,
            damage: Damage::default(),
            dice: Dice(faults.seed),
            passed: 0,
            packet: Bounded::new(),
        }
    }

    /// What has gone wrong so far.
    pub fn damage(&self) -> Damage {
        self.damage
    }

    /// Gives the sink back; bytes that still wait for their delimiter are lost.
    pub fn into_inner(self) -> W {
        self.sink
    }

    fn deliver_packet(&mut self) -> Result<(), W::Error> {
        let packet = core::mem::take(&mut self.packet);
        if packet.as_slice() == [DELIMITER] {
            return self.pass(packet.as_slice());
        }
        count(&mut self.damage.packets);
        if self.dice.falls(self.faults.drop_ppm) {
            count(&mut self.damage.dropped);
            return Ok(());
        }
        let twice = self.dice.falls(self.faults.duplicate_ppm);
        let flip = self.dice.falls(self.faults.flip_ppm);
        let lose = self.dice.falls(self.faults.lose_byte_ppm);
        let length = packet.as_slice().len();
        let flip_at = flip.then(|| self.dice.below(length));
        let lose_at = lose.then(|| self.dice.below(length));
        let mask = 1 << self.dice.below(8);

        let mut hurt = Bounded::<MAX_WIRE>::new();
        for (index, &byte) in packet.as_slice().iter().enumerate() {
            let byte = if flip_at == Some(index) {
                byte ^ mask
            } else {
                byte
            };
            if lose_at != Some(index) {
                // It has the size of what it is made from.
                let _ = hurt.push(byte);
            }
        }
        for (happened, counter) in [
            (twice, &mut self.damage.duplicated),
            (flip, &mut self.damage.flipped),
            (lose, &mut self.damage.bytes_lost),
        ] {
            if happened {
                count(counter);
            }
        }
        self.pass(hurt.as_slice())?;
        if twice {
            self.pass(hurt.as_slice())?;
        }
        Ok(())
    }

    /// Writes bytes to the sink as far as the line is not cut.
    fn pass(&mut self, bytes: &[u8]) -> Result<(), W::Error> {
        let length = bytes.len() as u64;
        let left = match self.faults.cut_after {
            None => length,
            Some(limit) => limit.saturating_sub(self.passed).min(length),
        };
        self.passed = self.passed.saturating_add(left);
        self.damage.bytes_cut = self
            .damage
            .bytes_cut
            .saturating_add(length.saturating_sub(left));
        let alive = usize::try_from(left).ok().and_then(|n| bytes.get(..n));
        self.sink.write_all(alive.unwrap_or(bytes))
    }
}

impl<W: Write> ErrorType for FaultInjector<W> {
    type Error = W::Error;
}

impl<W: Write> Write for FaultInjector<W> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Self::Error> {
        for &byte in bytes {
            let full = self.packet.push(byte).is_err();
            if full || byte == DELIMITER {
                self.deliver_packet()?;
            }
            if full {
                // The buffer is empty now.
                let _ = self.packet.push(byte);
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Self::Error> {
        let tail = core::mem::take(&mut self.packet);
        self.pass(tail.as_slice())?;
        self.sink.flush()
    }
}

/// SplitMix64 (Steele, Lea and Flood, 2014): small, seeded, good enough to
/// choose whom to hurt.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number from 0 to `bound` − 1; 0 if `bound` is 0. The bias is below
    /// `bound` / 2⁶⁴.
    fn below(&mut self, bound: usize) -> usize {
        let remainder = self.next().checked_rem(bound as u64).unwrap_or(0);
        usize::try_from(remainder).unwrap_or(0)
    }

    /// Whether something with this chance happens now.
    fn falls(&mut self, ppm: u32) -> bool {
        self.next() % 1_000_000 < u64::from(ppm)
    }
}

fn count(counter: &mut u64) {
    *counter = counter.saturating_add(1);
}
