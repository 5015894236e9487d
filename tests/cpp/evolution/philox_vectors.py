"""Known answers of Philox4x64-10 from numpy, as the lines of a C++ initialiser list.

    python3 philox_vectors.py > philox_vectors.inc

A line is {{key0, key1}, {c0, c1, c2, c3}, {r0, r1, r2, r3}}: the block that the generator makes
of this key and this counter.
"""

import numpy as np

TOP = 2**64 - 1

# (key, counter): as the library uses them, key = (seed, 0) and counter = (iteration, task,
# particle, dimension), then every word at its extremes, carries, and digits of pi.
INPUTS = [
    ((0, 0), (0, 0, 0, 0)),
    ((0, 0), (1, 0, 0, 0)),
    ((1, 0), (0, 0, 0, 0)),
    ((1, 0), (100, 1, 49, 5)),
    ((42, 0), (7, 0, 3, 2)),
    ((TOP, 0), (99, 1, 0, 0)),
    ((2**63, 0), (2**32, 2**33, 2**34, 2**35)),
    ((0, TOP), (0, TOP, 0, TOP)),
    ((TOP, TOP), (TOP, TOP, TOP, TOP)),
    ((12345, 0), (0, 1, 0, 0)),
    ((0x0123456789ABCDEF, 0), (TOP, 0, 0, 0)),
    (
        (0x452821E638D01377, 0xBE5466CF34E90C6C),
        (0x243F6A8885A308D3, 0x13198A2E03707344, 0xA4093822299F31D0, 0x082EFA98EC4E6C89),
    ),
    ((2**53 + 1, 0), (3, 1, 17, 4)),
]


def block(key, counter):
    """numpy counts up before it makes its first block, so it is started one below (mod 2^256)."""
    whole = sum(word << (64 * i) for i, word in enumerate(counter))
    before = (whole - 1) % 2**256
    words = [(before >> (64 * i)) & TOP for i in range(4)]
    generator = np.random.Philox(
        key=np.array(key, dtype=np.uint64), counter=np.array(words, dtype=np.uint64)
    )
    return [int(word) for word in generator.random_raw(4)]


def braces(words):
    return "{" + ", ".join(f"0x{word:016X}ULL" for word in words) + "}"


if __name__ == "__main__":
    for key, counter in INPUTS:
        print("{" + ", ".join([braces(key), braces(counter), braces(block(key, counter))]) + "},")
