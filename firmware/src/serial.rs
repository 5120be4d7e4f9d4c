//! The serial line as the application sees it: a queue that an interrupt empties.

use core::convert::Infallible;

use embedded_io::{ErrorType, Write};
use heapless::spsc::{Consumer, Producer, Queue};

/// The queue as its writer sees it.
pub trait Enqueue {
    /// Puts in as many bytes as there is room for, and says how many.
    fn enqueue(&mut self, bytes: &[u8]) -> usize;

    /// Whether all bytes have been taken out.
    fn is_empty(&self) -> bool;
}

/// The queue as whatever empties it sees it.
pub trait Dequeue {
    /// Takes out the oldest byte.
    fn dequeue(&mut self) -> Option<u8>;
}

impl Enqueue for Producer<'_, u8> {
    fn enqueue(&mut self, bytes: &[u8]) -> usize {
        let fits = |byte: &&u8| Producer::enqueue(self, **byte).is_ok();
        bytes.iter().take_while(fits).count()
    }

    fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Dequeue for Consumer<'_, u8> {
    fn dequeue(&mut self) -> Option<u8> {
        Consumer::dequeue(self)
    }
}

/// Not split in two, a queue knows its size: with a power of two a byte comes
/// and goes without a division.
impl<const N: usize> Dequeue for Queue<u8, N> {
    fn dequeue(&mut self) -> Option<u8> {
        Queue::dequeue(self)
    }
}

/// The other end of the queue.
pub trait Drain {
    /// Makes the transmit interrupt run soon. It is called after each write, and
    /// again and again by a writer that waits: so a lost interrupt of the
    /// UART's own delays bytes, but never strands them.
    fn wake(&mut self);

    /// Whether the UART has sent all that it was given.
    fn is_idle(&mut self) -> bool;
}

/// The writing end of a queue of bytes; whatever empties it runs at the same time.
///
/// A write returns as soon as its bytes are in the queue. While that is full it
/// waits: no byte is ever lost.
pub struct QueuedSerial<Q, D> {
    queue: Q,
    drain: D,
}

impl<Q: Enqueue, D: Drain> QueuedSerial<Q, D> {
    /// The writing end of `queue`, which `drain` empties.
    pub fn new(queue: Q, drain: D) -> Self {
        Self { queue, drain }
    }
}

impl<Q, D> ErrorType for QueuedSerial<Q, D> {
    type Error = Infallible;
}

impl<Q: Enqueue, D: Drain> Write for QueuedSerial<Q, D> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        loop {
            let taken = self.queue.enqueue(bytes);
            self.drain.wake();
            if taken > 0 || bytes.is_empty() {
                return Ok(taken);
            }
        }
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        while !self.queue.is_empty() || !self.drain.is_idle() {
            self.drain.wake();
        }
        Ok(())
    }
}
