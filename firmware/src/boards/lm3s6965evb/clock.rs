//! The chip's clock: the board's crystal of 8 MHz, without the PLL.

use cortex_m::delay::Delay;
use cortex_m::peripheral::SYST;
use tock_registers::interfaces::ReadWriteable;

use super::registers::{ClockGate1, ClockGate2, RunModeClock, system_control};

/// Frequency of the processor, UART0 and SSI0.
pub const HZ: u32 = 8_000_000;

/// Cycles that the crystal is given to swing in, at the internal oscillator's 12 MHz: 0.13 s.
const SETTLING_CYCLES: u32 = 1_572_864;

/// Changes over to the crystal, switches on the clocks of the blocks in use,
/// and gives a delay by the system timer.
pub fn start(timer: SYST) -> Delay {
    let system = system_control();
    let clock = &system.run_mode_clock;
    clock.modify(RunModeClock::CRYSTAL::Mhz8 + RunModeClock::MAIN_OSCILLATOR_OFF::CLEAR);
    cortex_m::asm::delay(SETTLING_CYCLES);
    clock.modify(RunModeClock::SOURCE::MainOscillator);

    system
        .clock_gate_1
        .modify(ClockGate1::UART0::SET + ClockGate1::SSI0::SET);
    system
        .clock_gate_2
        .modify(ClockGate2::PORT_A::SET + ClockGate2::PORT_C::SET + ClockGate2::PORT_D::SET);
    // A block must not be touched in the first three cycles of its clock.
    cortex_m::asm::delay(3);
    Delay::new(timer, HZ)
}
