"""A second source for Cortex-M0+: rp2040js, an emulator of the RP2040 that counts cycles."""
