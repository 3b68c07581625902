#!/usr/bin/env python3
"""Reference orbits from NAIF's CSPICE: conics_c, oscelt_c, prop2b_c.

usage: conics.py OUTPUT_FOLDER [path/to/libcspice.so]     (or the path in MSISF_CSPICE)

Writes conics.csv, oscelt.csv and prop2b.csv. CSPICE takes any consistent units; here m, s and rad. The inputs are drawn with
a fixed seed and printed with repr, so that a reader gets the same doubles.
"""
import ctypes
import math
import os
import pathlib
import random
import sys

MU = 4.902801076e12  # m3/s2, thesis section 6.2.2
SEED = 20120222
DEGENERATE_INCLINATIONS = [0.0, math.pi / 2, math.pi]
ANOMALIES = [0.0, math.pi / 2, math.pi, 2 * math.pi]


class CSpice:
    def __init__(self, path):
        self.lib = ctypes.CDLL(path)
        self.lib.tkvrsn_c.restype = ctypes.c_char_p
        self.lib.erract_c(b"SET", 0, ctypes.create_string_buffer(b"RETURN"))
        self.lib.errprt_c(b"SET", 0, ctypes.create_string_buffer(b"NONE"))
        self.version = self.lib.tkvrsn_c(b"TOOLKIT").decode()

    def check(self, inputs):
        if self.lib.failed_c():
            text = ctypes.create_string_buffer(1841)
            self.lib.getmsg_c(b"LONG", 1841, text)
            raise RuntimeError(f"{text.value.decode()} for {inputs}")

    def conics(self, a, e, omega, node, i, m0, dt):
        elements = (ctypes.c_double * 8)(a * (1.0 - e), e, i, node, omega, m0, 0.0, MU)
        state = (ctypes.c_double * 6)()
        self.lib.conics_c(elements, ctypes.c_double(dt), state)
        self.check((a, e, omega, node, i, m0, dt))
        return list(state)

    def oscelt(self, state):
        elements = (ctypes.c_double * 8)()
        self.lib.oscelt_c((ctypes.c_double * 6)(*state), ctypes.c_double(0.0), ctypes.c_double(MU), elements)
        self.check(state)
        rp, e, i, node, omega, m0 = list(elements)[:6]
        return [rp, e, omega, node, i, m0]

    def prop2b(self, state, dt):
        result = (ctypes.c_double * 6)()
        self.lib.prop2b_c(ctypes.c_double(MU), (ctypes.c_double * 6)(*state), ctypes.c_double(dt), result)
        self.check((state, dt))
        return list(result)


def orbits(rng):
    """a, e, omega, Omega, i, M0, dt: the case of docs/deviations.md row 1, the degenerate ones, 400 drawn ones."""
    yield 1.9e6, 0.05, 0.7, 1.1, 0.9, 2.0, 0.0
    for i in DEGENERATE_INCLINATIONS:
        for e in [0.0, 1e-12, 0.3, 0.95]:
            for m0 in ANOMALIES:
                yield 2.5e6, e, 0.7, 1.1, i, m0, 0.0
    for e in [0.99, 0.999, 0.9999]:
        for m0 in [1e-6, 1e-3, 1.0, 3.0, 3.5, 6.0]:
            yield 1.8e6 / (1.0 - e), e, 0.3, 5.0, 2.5, m0, 0.0
    for _ in range(400):
        turn = 2.0 * math.pi
        yield (
            10.0 ** rng.uniform(math.log10(1.75e6), 8.0), rng.uniform(0.0, 0.95), rng.uniform(0.0, turn),
            rng.uniform(0.0, turn), rng.uniform(0.0, math.pi), rng.uniform(0.0, turn), rng.uniform(-1e5, 1e5))


def states(rng):
    """States of ellipses without going through elements: a position, and a velocity of 0.3 to 1.3 times the circular speed."""
    circular = math.sqrt(MU / 2e6)
    yield [2e6, 0.0, 0.0, 0.0, circular, 0.0]            # circular, equatorial
    yield [2e6, 0.0, 0.0, 0.0, -circular, 0.0]           # retrograde
    yield [0.0, 0.0, 2e6, circular, 0.0, 0.0]            # polar, over the pole
    yield [0.0, -2e6, 0.0, 1.2 * circular, 0.0, 0.0]     # eccentric, equatorial, at the periapsis
    yield [0.0, 2e6, 0.0, 0.8 * circular, 0.0, 0.0]      # eccentric, equatorial, retrograde, at the apoapsis
    yield [2e6, 0.0, 0.0, 10.0, 0.0, circular]           # polar
    for _ in range(300):
        position = direction(rng, 10.0 ** rng.uniform(math.log10(1.75e6), 8.0))
        radius = math.sqrt(sum(x * x for x in position))
        velocity = direction(rng, rng.uniform(0.3, 1.3) * math.sqrt(MU / radius))
        yield position + velocity


def direction(rng, length):
    vector = [rng.gauss(0.0, 1.0) for _ in range(3)]
    scale = length / math.sqrt(sum(x * x for x in vector))
    return [scale * x for x in vector]


def write(path, header, rows):
    path.write_text("\n".join([header] + [",".join(map(repr, row)) for row in rows]) + "\n", newline="\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    spice = CSpice(sys.argv[2] if len(sys.argv) > 2 else os.environ["MSISF_CSPICE"])
    rng = random.Random(SEED)
    drawn_orbits = [list(map(float, orbit)) for orbit in orbits(rng)]
    drawn_states = list(states(rng))
    times = [rng.uniform(-2e5, 2e5) for _ in drawn_states]
    write(folder / "conics.csv", "a,e,omega,Omega,i,M0,dt,rx,ry,rz,drx,dry,drz",
          [orbit + spice.conics(*orbit) for orbit in drawn_orbits])
    write(folder / "oscelt.csv", "rx,ry,rz,drx,dry,drz,rp,e,omega,Omega,i,M0",
          [state + spice.oscelt(state) for state in drawn_states])
    write(folder / "prop2b.csv", "rx,ry,rz,drx,dry,drz,dt,rx(dt),ry(dt),rz(dt),drx(dt),dry(dt),drz(dt)",
          [state + [dt] + spice.prop2b(state, dt) for state, dt in zip(drawn_states, times)])
    print(f"{spice.version}: {len(drawn_orbits)} orbits, {len(drawn_states)} states")


if __name__ == "__main__":
    main()
