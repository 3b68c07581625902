#!/usr/bin/env python3
"""Compares the states of two builds of msis: by how much do positions, attitudes, velocities and times move?

Both programs get the same orbits, trajectories and files, made by the second one. Positions and attitudes are printed as multiples of
velocity (or rate of turning) times 0.6 microseconds, about a step of a double of MJD (twice as much from 2038-04-23 on); velocities in m/s,
times in microseconds. Rounding a typed time to an MJD is half a step, an interval of times a whole one; TDB was once rounded by a tenth.

  scripts/compare-builds.py OLD/publish/msis ./msis --cspice lib/native/libcspice.so
"""
import argparse
import csv
import datetime
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

STEP = 0.6e-6  # s
MOON_RATE = 2.6617e-6  # rad/s
ROUNDING = 1e-8  # m: some 40 ulps of a place in orbit; a smaller change is none
TURN_ROUNDING = 1e-14  # rad
KEPLER = ['--kepler-set', '{1.838E6,0.01,0.7,1.1,0.9,2.0}']
VECTORS = ['--state-vectors', '{1.2E6,-1.3E6,5.94E5,507.3,-1024.1,-1156.2}']
TURNING = ['--attitude', '{0.5,0.5,0.5,0.5}', '--attitude-transition', '{0.01,-0.02,0.005}']
SCAN = 'width: 16\nheight: 1\nfocal-length-px: 300\nscan:\n  kind: line-scan\n  period: 0.0123\n'


def run(program, words, engine, cspice):
    """What a program prints."""
    environment = dict(os.environ, **({'MSISF_CSPICE': cspice} if cspice else {}))
    done = subprocess.run([program, *words, '--ephemeris', engine], capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        sys.exit(f'{program} {" ".join(words)}: {done.stderr.strip()}')
    return done.stdout


def table(text):
    """The states of a CSV: rows of numbers by column."""
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith('#'))
    return [{name: float(number) for name, number in row.items()} for row in rows]


def oem_times(folder):
    """The times of an OEM, in microseconds."""
    times = []
    for line in (pathlib.Path(folder) / 'states.oem').read_text().splitlines():
        found = re.match(r'(\d{4}-\d\d-\d\dT\d\d:\d\d:)(\d\d)\.(\d+) ', line)
        if found:
            minute = datetime.datetime.fromisoformat(found[1] + '00') - datetime.datetime(2000, 1, 1)
            times.append(minute / datetime.timedelta(microseconds=1) + 1e6 * int(found[2]) + int(found[3]) / 10 ** (len(found[3]) - 6))
    return times


def meta(folder):
    """The states of meta files, as rows of a CSV; they have no motion."""
    rows = []
    for path in sorted(pathlib.Path(folder).glob('*.xml')):
        text = path.read_text()
        place = re.search(r'<CameraPosition unit="m">\s*<Vector3D x="(.*?)" y="(.*?)" z="(.*?)"', text)
        turn = re.search(r'<Quaternion r="(.*?)" x="(.*?)" y="(.*?)" z="(.*?)"', text)
        numbers = [float(n) for n in (*place.groups(), *turn.groups())]
        rows.append(dict(zip(['x', 'y', 'z', 'qw', 'qx', 'qy', 'qz'], numbers),
                         time=float(re.search(r'<MJD>(.*?)<', text)[1])))
    return rows


def difference(a, b, names):
    return math.dist([a[n] for n in names], [b[n] for n in names])


def turn(a, b):
    """The angle between two attitudes, rad."""
    names = ['qx', 'qy', 'qz', 'qw']
    sign = math.copysign(1.0, sum(a[n] * b[n] for n in names))
    return 4.0 * math.asin(min(1.0, 0.5 * math.dist([a[n] for n in names], [sign * b[n] for n in names])))


def compare(old, new, motion):
    """The greatest changes: positions and attitudes in steps of the motion, velocities (m/s), times (us)."""
    if len(old) != len(new):
        sys.exit(f'{len(old)} states of the old program, {len(new)} of the new one')
    places = turns = speeds = times = 0.0
    for a, b, m in zip(old, new, motion):
        way = STEP * math.hypot(m['vx'], m['vy'], m['vz'])
        angle = STEP * (math.hypot(m['wx'], m['wy'], m['wz']) + MOON_RATE)
        moved, turned = difference(a, b, 'xyz'), turn(a, b)
        places = max(places, moved / way if moved > ROUNDING else 0.0)
        turns = max(turns, turned / angle if turned > TURN_ROUNDING else 0.0)
        times = max(times, abs(a['time'] - b['time']) * 86400e6)
        if 'vx' in a and 'vx' in b:
            speeds = max(speeds, difference(a, b, ['vx', 'vy', 'vz']))
    return places, turns, speeds, times


def cases(day, new, engine, cspice, folder):
    """Names with options; files are written by the new program."""
    def at(seconds):
        return f'{day}T{seconds // 3600:02}:{seconds % 3600 // 60:02}:{seconds % 60:02}'
    times = ['--times', '{' + ','.join(f'{at(600 + 211 * i)}.{123 + 37 * i:03}Z' for i in range(22)) + '}']
    epoch = ['--epoch', at(0) + 'Z']
    for frame in ['moon-me', 'moon-me-epoch', 'j2000']:
        yield f'Kepler, {frame}', [*KEPLER, *epoch, '--orbit-frame', frame, *TURNING, *times], True
        yield f'state vectors, {frame}', [*VECTORS, *epoch, '--orbit-frame', frame, *times], True
    yield 'Kepler, interval', [*KEPLER, *epoch, '--orbit-frame', 'j2000', '--time-interval', f'[{at(60)}.123Z:61.7s:{at(5400)}Z]'], True
    dense = [*KEPLER, *epoch, '--orbit-frame', 'j2000', '--time-interval', f'[{at(0)}Z:10s:{at(6000)}Z]']
    run(new, ['states', '--format', 'oem', '--to', folder, *dense], engine, cspice)
    run(new, ['states', '--format', 'spice', '--to', folder + '/k', *dense], engine, cspice)
    run(new, ['states', '--format', 'csv', '--to', folder + '/b.csv', *dense], engine, cspice)
    rows = table(pathlib.Path(folder, 'b.csv').read_text())
    names = ['x', 'y', 'z', 'qx', 'qy', 'qz', 'qw', 'vx', 'vy', 'vz', 'wx', 'wy', 'wz']
    with open(folder + '/s.csv', 'w') as file:
        file.write(f'# msis: epoch={at(0)}Z\nseconds,{",".join(names)}\n')
        for i, row in enumerate(rows):
            file.write(','.join([str(10 * i), *(repr(row[n]) for n in names)]) + '\n')
    oem = ['--oem', folder + '/states.oem']
    yield 'OEM', [*oem, '--look-at', 'nadir', *times], True
    yield 'OEM, LVLH', [*oem, '--attitude', '{0,0,0,1}', '--attitude-frame', 'lvlh', *times], True
    yield 'OEM with AEM', [*oem, '--aem', folder + '/states.aem', *times], True
    yield 'SPK', ['--spk', folder + '/k/states.bsp', '--spacecraft', '-999', '--look-at', 'nadir', *times], True
    yield 'batch file', ['--batch-file', folder + '/b.csv'], True
    yield 'batch file, seconds', ['--batch-file', folder + '/s.csv'], True
    yield 'samples', ['--trajectory', folder + '/b.csv', '--trajectory-attitudes', 'slerp', *times], True
    pathlib.Path(folder, 'scan.yaml').write_text(SCAN)
    line = [*KEPLER, *epoch, '--orbit-frame', 'j2000', '--camera', folder + '/scan.yaml', '--renderer', 'native', '--lines', '64']
    yield 'scan', [*line, '--time', at(4321) + '.123Z'], False


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('old', help='a program msis')
    parser.add_argument('new', help='another one')
    parser.add_argument('--dates', nargs='+', default=['2026-03-04'], metavar='YYYY-MM-DD', help='days of the orbits (default: 2026-03-04)')
    parser.add_argument('--engines', nargs='+', default=['builtin', 'cspice'], help='ephemeris engines (default: both)')
    parser.add_argument('--kernels', metavar='FILE', help='meta-kernel of both programs (default: that of each)')
    parser.add_argument('--ldem', metavar='LBL', help='elevation model with which images are drawn, to compare their meta files too')
    parser.add_argument('--cspice', metavar='LIBRARY', help='libcspice.so of both programs')
    options = parser.parse_args()
    always = ['--kernels', options.kernels] if options.kernels else []
    print(f'{"day":10} {"engine":8} {"case":28} {"places":>7} {"turns":>7} {"m/s":>9} {"us":>7} {"us OEM":>7}')
    for day in options.dates:
        for engine in options.engines:
            with tempfile.TemporaryDirectory() as folder:
                def ask(program, *words):
                    return run(program, [*words, *always], engine, options.cspice)
                for name, words, has_oem in cases(day, options.new, engine, options.cspice, folder):
                    old, new = (table(ask(p, 'states', '--format', 'csv', *words)) for p in (options.old, options.new))
                    results, oem = compare(old, new, new), ''
                    if has_oem:
                        for index, program in enumerate((options.old, options.new)):
                            ask(program, 'states', '--format', 'oem', '--to', f'{folder}/oem{index}', *words)
                        pairs = zip(oem_times(folder + '/oem0'), oem_times(folder + '/oem1'), strict=True)
                        oem = f'{max(abs(a - b) for a, b in pairs):7.3f}'
                    print_row(day, engine, name, results, oem)
                    if options.ldem and name == 'Kepler, j2000':
                        sides = []
                        for index, program in enumerate((options.old, options.new)):
                            images = ['--ldem', options.ldem, '--res', '4', '--width', '8', '--height', '8', '--renderer', 'native']
                            ask(program, *words, *images, '--output-dir', f'{folder}/images{index}')
                            sides.append(meta(f'{folder}/images{index}'))
                        print_row(day, engine, 'meta files', compare(*sides, new), '')


def print_row(day, engine, name, results, oem):
    places, turns, speeds, times = results
    print(f'{day:10} {engine:8} {name:28} {places:7.2f} {turns:7.2f} {speeds:9.1e} {times:7.3f} {oem}', flush=True)


if __name__ == '__main__':
    main()
