"""Consistent overhead byte stuffing, the receiving half.

Written here because the package for it on PyPI has to be compiled on the
user's machine; the tests hold this to the bytes of the Rust crate ``cobs``.
"""


class CobsError(ValueError):
    """A code byte points past the end."""


def decode(encoded: bytes) -> bytes:
    """Decode what stood between two delimiters.

    Args:
        encoded: bytes without a 0 among them.

    Raises:
        CobsError: if the last block is cut short.
    """
    decoded = bytearray()
    position = 0
    while position < len(encoded):
        code = encoded[position]
        end = position + code
        if end > len(encoded):
            raise CobsError(f"a block of {code} bytes at byte {position} of {len(encoded)}")
        decoded += encoded[position + 1 : end]
        position = end
        # A block of 254 bytes stands for no 0, and neither does the last one.
        if code < 255 and position < len(encoded):
            decoded.append(0)
    return bytes(decoded)
