#!/usr/bin/env python3
"""A second pattern writer, made from docs/pattern-format.md alone; shares no code with msis.

    python3 tests/reference/pattern_format.py LDEM_4.LBL south west [margin-samples] > pattern.inc

It reads NASA's whole-Moon 16-bit LDEM products. The golden patterns under tests/golden/patterns were compared with its output.
"""

import hashlib
import math
import os
import re
import struct
import sys

PI_OVER_180 = (0.017453292519943295, 2.9486522708701687e-19)
SINE = [
    (1.0, 0.0), (-0.16666666666666666, -9.25185853854297e-18), (0.008333333333333333, 1.1564823173178714e-19),
    (-0.0001984126984126984, -1.7209558293420705e-22), (2.7557319223985893e-06, -1.858393274046472e-22),
    (-2.505210838544172e-08, 1.448814070935912e-24), (1.6059043836821613e-10, 1.2585294588752098e-26),
    (-7.647163731819816e-13, -7.03872877733453e-30), (2.8114572543455206e-15, 1.6508842730861433e-31),
    (-8.22063524662433e-18, -2.2141894119604265e-34), (1.9572941063391263e-20, -1.3643503830087908e-36),
    (-3.868170170630684e-23, 8.843177655482344e-40), (6.446950284384474e-26, -1.9330404233703465e-42),
    (-9.183689863795546e-29, -1.4303150396787322e-45),
]
COSINE = [
    (1.0, 0.0), (-0.5, 0.0), (0.041666666666666664, 2.3129646346357427e-18),
    (-0.001388888888888889, 5.300543954373577e-20), (2.48015873015873e-05, 2.1511947866775882e-23),
    (-2.755731922398589e-07, -2.3767714622250297e-23), (2.08767569878681e-09, -1.20734505911326e-25),
    (-1.1470745597729725e-11, -2.0655512752830745e-28), (4.779477332387385e-14, 4.399205485834081e-31),
    (-1.5619206968586225e-16, -1.1910679660273754e-32), (4.110317623312165e-19, 1.4412973378659527e-36),
    (-8.896791392450574e-22, 7.911402614872376e-38), (1.6117375710961184e-24, -3.6846573564509766e-41),
    (-2.4795962632247976e-27, 1.2953730964765229e-43), (3.279889237069838e-30, 1.5117542744029879e-46),
]


def split(a):
    scaled = 134217729.0 * a
    high = scaled - (scaled - a)
    return high, a - high


def two_product(a, b):
    (a1, a2), (b1, b2) = split(a), split(b)
    p = a * b
    return p, (((a1 * b1) - p) + (a1 * b2) + (a2 * b1)) + (a2 * b2)


def two_sum(a, b):
    s = a + b
    t = s - a
    return s, (a - (s - t)) + (b - t)


def fast_two_sum(a, b):
    s = a + b
    return s, b - (s - a)


def add(a, b):
    s = two_sum(a[0], b[0])
    t = two_sum(a[1], b[1])
    v = fast_two_sum(s[0], s[1] + t[0])
    return fast_two_sum(v[0], t[1] + v[1])


def multiply(a, b):
    p = two_product(a[0], b[0])
    return fast_two_sum(p[0], p[1] + ((a[0] * b[1]) + (a[1] * b[0])))


def radians_of(n, d):
    q = n / d
    p = two_product(q, float(d))
    return multiply((q, (n - p[0] - p[1]) / d), PI_OVER_180)


def horner(series, x):
    square = multiply(x, x)
    total = series[-1]
    for coefficient in reversed(series[:-1]):
        total = add(multiply(total, square), coefficient)
    return total


def first_quarter(n, d):
    if n <= 45 * d:
        x = radians_of(n, d)
        return multiply(x, horner(SINE, x))[0]
    return horner(COSINE, radians_of(90 * d - n, d))[0]


def sine_of_degrees(n, d):
    n %= 360 * d
    quarter, rest = divmod(n, 90 * d)
    value = first_quarter(rest if quarter % 2 == 0 else 90 * d - rest, d)
    return 0.0 - value if quarter >= 2 else value


def cosine_of_degrees(n, d):
    return sine_of_degrees(n + 90 * d, d)


def lattice(radius, latitude, longitude):
    """latitude and longitude as (numerator, denominator) in degrees."""
    steps = 128.0 * radius
    equatorial = steps * cosine_of_degrees(*latitude)
    products = (equatorial * cosine_of_degrees(*longitude), equatorial * sine_of_degrees(*longitude), steps * sine_of_degrees(*latitude))
    return tuple(math.floor(value + 0.5) for value in products)


def read_model(label_path):
    text = open(label_path, encoding="latin-1").read()

    def value(keyword):
        return re.search(rf"^\s*{keyword}\s*=\s*\"?([^\s\"]+)", text, re.M).group(1)

    assert value("SAMPLE_TYPE") == "LSB_INTEGER" and value("SAMPLE_BITS") == "16"
    samples = int(value("LINE_SAMPLES"))
    image = open(os.path.join(os.path.dirname(label_path), value("FILE_NAME")), "rb").read()
    scale, offset = float(value("SCALING_FACTOR")), float(value("OFFSET"))

    def radius(line, sample):
        return offset + scale * struct.unpack_from("<h", image, 2 * (line * samples + sample % samples))[0]

    return value("PRODUCT_ID"), int(value("MAP_RESOLUTION")), radius


def pattern(product, res, radius, south, west, margin=0):
    first_line = max((90 - south - 5) * res - margin, 0)
    end_line = min((90 - south) * res + margin + 1, 180 * res)
    first_sample, samples = west * res - margin, 5 * res + 2 * margin + 1
    columns = [(first_sample + c) % (360 * res) for c in range(samples)]

    def pole(line):
        total = 0.0
        for sample in range(360 * res):
            total += radius(line, sample)
        return total / (360 * res)

    vertices = []
    if first_line == 0:
        vertices.append((pole(0), (90, 1), (0, 1)))
    for line in range(first_line, end_line):
        for sample in columns:
            vertices.append((radius(line, sample), (180 * res - 2 * line - 1, 2 * res), (2 * sample + 1, 2 * res)))
    if end_line == 180 * res:
        vertices.append((pole(180 * res - 1), (-90, 1), (0, 1)))

    faces = []
    base = 1 if first_line == 0 else 0
    if base:
        faces += [(0, c + 1, c + 2) for c in range(samples - 1)]
    for row in range(end_line - first_line - 1):
        for column in range(samples - 1):
            nw = base + row * samples + column
            faces += [(nw, nw + samples, nw + samples + 1), (nw, nw + samples + 1, nw + 1)]
    if end_line == 180 * res:
        south_pole = len(vertices) - 1
        faces += [(nw, south_pole, nw + 1) for nw in range(south_pole - samples, south_pole - 1)]

    origin = lattice(1737400.0, (2 * south + 5, 2), (2 * west + 5, 2))
    digest = hashlib.sha256(b"".join(struct.pack("<d", vertex[0]) for vertex in vertices)).hexdigest()
    lines = ["#local k=1/131072;", "mesh2{", f"vertex_vectors{{{len(vertices)},"]
    rows = []
    for vertex in vertices:
        point = lattice(*vertex)
        rows.append("<%d,%d,%d>*k" % tuple(p - o for p, o in zip(point, origin)))
    lines.append(",\n".join(rows) + "}")
    lines.append(f"face_indices{{{len(faces)},")
    lines.append(",\n".join("<%d,%d,%d>" % face for face in faces) + "}")
    lines += ["translate <%d,%d,%d>*k" % origin, "scale 1.024", "texture{moon}", "}", ""]
    body = "\n".join(lines)
    header = (
        f"// msisf-pattern 1 format=mesh2 product={product} res={res} tile=lat_{south}_{south + 5}_lon_{west}_{west + 5}"
        f" margin-samples={margin} samples-sha256={digest} vertices={len(vertices)} faces={len(faces)} bytes="
    )
    return f"{header}{len(header) + 12 + 1 + len(body):012d}\n{body}"


if __name__ == "__main__":
    model = read_model(sys.argv[1])
    sys.stdout.write(pattern(*model, *(int(text) for text in sys.argv[2:])))
