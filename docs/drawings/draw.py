#!/usr/bin/env python3
"""Makes the drawings of the docs from the constants in the code.

    python3 docs/drawings/draw.py [FOLDER]      writes FOLDER/*.svg; without FOLDER into docs/drawings

The constants are read from the C# sources, and the stages that are drawn must be folders there: a drawing never shows what the
code does not have. tests/scripts/docs.test.sh compares the committed drawings with what this script makes.
"""
import math
import pathlib
import re
import sys

from svg import BLUE, GREEN, GREY, INK, ORANGE, PALE, RED, Drawing

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ROOT / "src"


def constant(type_name, name):
    """The number that a constant of a C# type has."""
    paths = list(SOURCES.rglob(f"{type_name}.cs"))
    if len(paths) != 1:
        sys.exit(f"draw.py: {len(paths)} files {type_name}.cs under src, 1 expected")
    found = re.search(rf"\bconst \w+ {name} = ([0-9_.eE+-]+);", paths[0].read_text(encoding="utf-8"))
    if not found:
        sys.exit(f"draw.py: {type_name}.cs has no constant {name} with a plain number")
    return float(found[1].replace("_", ""))


def enumeration(type_name):
    """The names of the members of a C# enumeration."""
    texts = (path.read_text(encoding="utf-8") for path in sorted(SOURCES.rglob("*.cs")))
    body = next(found[1] for found in (re.search(rf"\benum {type_name}\n{{(.*?)^}}", text, re.MULTILINE | re.DOTALL) for text in texts) if found)
    return re.findall(r"^    (\w+),$", body, re.MULTILINE)


def stage(name):
    """A stage of the data's way, which must be a folder of the core."""
    if not (SOURCES / "Msisf.Core" / name).is_dir():
        sys.exit(f"draw.py: src/Msisf.Core/{name} is no folder")
    return name.split("/")[-1]


def data_flow():
    drawing = Drawing(960, 408, "The way of the data through the program")
    rows = (60, 165, 270, 365)

    def box(column, row, title, words="", colour=INK, width=150, height=62):
        drawing.box(20 + column * 192, row - height / 2, width, height, title, words, colour)

    drawing.text(20, 20, "input", GREY)
    drawing.text(212, 20, "where, when, what ground", GREY)
    drawing.text(596, 20, "an image", GREY)
    drawing.text(788, 20, "output", GREY)
    box(0, rows[0], "states or orbit", "options, batch file", GREY)
    box(0, rows[1], "SPICE kernels", "kernels/", GREY)
    box(0, rows[2], "elevation model", "LDEM label, image", GREY)
    box(1, rows[0], f"{stage('Orbit')}, {stage('Attitude')}", "a state for each time")
    box(1, rows[1], stage("Ephemeris"), "Sun, Moon's axes")
    box(1, rows[2], stage("Terrain"), "heights on a grid")
    box(2, rows[2], f"{stage('Surface')}, {stage('Lod')}", "facets, levels")
    box(2, rows[0], stage("Camera"), "rays of the pixels")
    box(2, rows[3], stage("Tiles"), "which, patterns", BLUE)
    box(3, rows[3], stage("Scene"), ".pov, POV-Ray", BLUE)
    drawing.rectangle(596, 88, 150, 226, ORANGE, PALE[ORANGE], corner=6)
    drawing.text(671, 108, "native renderer", ORANGE, "middle", bold=True)
    for index, (name, words) in enumerate((("Visibility", "facet of a pixel"), ("Shadows", "sunlit or not"), ("Shading", "cosine, normal"), ("Photometry", "reflectance law"))):
        y = 118 + 48 * index
        drawing.rectangle(606, y, 130, 40, ORANGE, "white", 1, 4)
        drawing.text(671, y + 17, stage(f"Render/{name}"), INK, "middle", 12, bold=True)
        drawing.text(671, y + 33, words, INK, "middle", 11)
        if index:
            drawing.arrow((671, y - 8), (671, y), colour=ORANGE)
    box(4, rows[1] + 38, "image", ".png", GREEN)
    box(4, rows[0], stage("Metadata"), "pixels in .xml", GREEN)
    box(4, rows[3], stage("Layers"), "ground truth, .fits", GREEN)
    for row in rows[:3]:
        drawing.arrow((170, row), (212, row))
    drawing.arrow((362, rows[0]), (404, rows[0]))                                # state -> camera
    drawing.arrow((554, rows[0]), (788, rows[0]))                                # camera -> metadata
    drawing.arrow((479, rows[0] + 31), (479, 125), (596, 125))                   # camera -> native
    drawing.arrow((362, rows[1]), (596, rows[1]))                                # Sun -> native
    drawing.arrow((362, rows[2]), (404, rows[2]))
    drawing.arrow((554, rows[2]), (596, rows[2]))                                # mesh -> native
    drawing.arrow((479, rows[2] + 31), (479, rows[3] - 31), colour=BLUE)         # mesh -> tiles
    drawing.arrow((554, rows[3]), (596, rows[3]), colour=BLUE)
    drawing.arrow((726, rows[3] - 31), (766, rows[3] - 68), (766, rows[1] + 52), (788, rows[1] + 52), colour=BLUE)
    drawing.arrow((746, rows[1] + 24), (788, rows[1] + 24), colour=ORANGE)
    drawing.arrow((746, 296), (863, 296), (863, rows[3] - 31), colour=ORANGE)
    return drawing


def camera():
    drawing = Drawing(960, 380, "Camera axes and pixel convention")
    # Left: an oblique view of the camera's axes. A camera vector (x, y, z) becomes x * ex + y * ey + z * ez on the paper.
    ex, ey, ez = (-0.92, 0.10), (-0.42, 0.40), (0.0, -1.0)
    origin = (130.0, 175.0)

    def paper(x, y, z):
        return origin[0] + x * ex[0] + y * ey[0] + z * ez[0], origin[1] + x * ex[1] + y * ey[1] + z * ez[1]

    drawing.text(20, 24, "Camera axes", bold=True)
    half_width, half_height, distance = 100.0, 62.5, 240.0
    corners = [paper(-distance, y, z) for y, z in ((-half_width, half_height), (half_width, half_height), (half_width, -half_height), (-half_width, -half_height))]
    drawing.path(corners, BLUE, fill=PALE[BLUE], closed=True)
    for corner in corners:
        drawing.path([origin, corner], GREY, 1)
    drawing.arrow(paper(0, 0, 0), paper(-distance, 0, 0), colour=INK, width=2)
    drawing.arrow(paper(0, 0, 0), paper(0, 75, 0), colour=RED, width=2)
    drawing.arrow(paper(0, 0, 0), paper(0, 0, 95), colour=GREEN, width=2)
    drawing.dot(*origin, 4)
    end = paper(-distance, 0, 0)
    drawing.text(end[0] + 10, end[1] + 5, "-x: line of sight")
    end = paper(0, 75, 0)
    drawing.text(end[0] - 6, end[1] + 16, "y: right", RED, "middle")
    end = paper(0, 0, 95)
    drawing.text(end[0], end[1] - 8, "z: up", GREEN, "middle")
    drawing.text(origin[0] - 8, origin[1] + 4, "camera", INK, "end")
    end = paper(-distance, -half_width, half_height)
    drawing.text(end[0] + 8, end[1] + 16, "image", BLUE)
    drawing.text(20, 320, "The state's quaternion turns camera axes into Moon axes (MOON_ME):")
    drawing.text(20, 342, "v(Moon) = q v(camera) q*, with q = (qx, qy, qz, q0), q0 the scalar.", INK)
    drawing.text(20, 364, "(0, 0, 0, 1) looks along the Moon's -x axis, north is up.", GREY)

    # Right: the pixels.
    columns, lines, size = 8, 5, 42.0
    left, top = 560.0, 70.0
    drawing.text(520, 24, f"Pixels of an image, here {columns} x {lines}", bold=True)
    for line in range(lines):
        for column in range(columns):
            drawing.rectangle(left + column * size, top + line * size, size, size, GREY, "white", 1)

    def centre(x, y):
        return left + (x - 0.5) * size, top + (y - 0.5) * size

    for x, y in ((1, 1), (columns, 1), (1, lines), (columns, lines)):
        drawing.rectangle(left + (x - 1) * size, top + (y - 1) * size, size, size, BLUE, PALE[BLUE], 1)
        px, py = centre(x, y)
        drawing.text(px, py + 4, f"{x}, {y}", BLUE, "middle", 12)
    middle = centre((1 + columns) / 2, (1 + lines) / 2)
    drawing.dot(*middle, 4, RED)
    drawing.text(middle[0], middle[1] + 28, f"line of sight: {(1 + columns) / 2:g}, {(1 + lines) / 2:g}", RED, "middle", 12)
    drawing.arrow((left, top - 16), (left + 120, top - 16), colour=INK)
    drawing.text(left + 128, top - 12, "x, h: right", INK)
    drawing.arrow((left - 16, top), (left - 16, top + 110), colour=INK)
    drawing.text(left - 22, top + 128, "y, v:\ndown", INK, "end")
    drawing.text(520, 320, "Pixels are counted from 1; whole numbers are pixel centres.")
    drawing.text(520, 342, "The line of sight is at (1 + width) / 2, (1 + height) / 2.")
    drawing.text(520, 364, "--fov is the angle between the left and the right edge.")
    return drawing


def illumination():
    drawing = Drawing(960, 380, "Illumination direction")
    drawing.text(20, 24, "On the ground", bold=True)
    ground = [(30 + t * 4.1, 250 + 0.0011 * (t * 4.1 - 205) ** 2) for t in range(101)]
    drawing.path(ground, INK, 2)
    point = ground[50]
    drawing.arrow(point, (point[0], point[1] - 130), colour=GREY)
    drawing.text(point[0] - 6, point[1] - 138, "zenith", GREY, "middle")
    elevation = math.radians(25.0)
    drawing.path([point, (point[0] + 190 * math.cos(elevation), point[1] - 190 * math.sin(elevation))], ORANGE, 1.5, "5 4")
    drawing.arrow((point[0] + 60 * math.cos(elevation), point[1] - 60 * math.sin(elevation)), (point[0] + 190 * math.cos(elevation), point[1] - 190 * math.sin(elevation)), colour=ORANGE)
    drawing.text(point[0] + 196 * math.cos(elevation), point[1] - 196 * math.sin(elevation) + 6, "to the Sun", ORANGE)
    drawing.arrow(point, (point[0] + 150, point[1]), colour=RED, width=2.5)
    drawing.text(point[0] + 150, point[1] + 76, "along the ground to the Sun:\nthis direction, seen in the image", RED, "middle")
    arc = [(point[0] + 62 * math.sin(a), point[1] - 62 * math.cos(a)) for a in (math.radians(k) for k in range(0, 66, 5))]
    drawing.path(arc, GREY, 1)
    drawing.text(point[0] + 20, point[1] - 92, "incidence angle (another one)", GREY, size=12)
    drawing.dot(*point, 4)
    drawing.text(point[0], point[1] + 22, "point", INK, "end")

    # Right: the dial in the image plane: angle a is counter-clockwise from straight down.
    x, y, radius = 690.0, 198.0, 112.0

    def dial(degrees, length):
        return x + length * math.sin(math.radians(degrees)), y + length * math.cos(math.radians(degrees))

    drawing.text(500, 24, "In the image", bold=True)
    drawing.rectangle(500, 44, 380, 312, GREY, PALE[INK], 1)
    drawing.circle(x, y, radius, GREY, 1)
    for degrees, anchor, (dx, dy) in ((0, "middle", (0, 18)), (90, "start", (8, 4)), (180, "middle", (0, -8)), (270, "end", (-8, 4))):
        px, py = dial(degrees, radius)
        drawing.path([dial(degrees, radius - 6), dial(degrees, radius + 4)], INK)
        drawing.text(px + dx, py + dy, {0: "0, down", 90: "90, right", 180: "180, up", 270: "270, left"}[degrees], INK, anchor)
    example = 130
    drawing.arrow((x, y), dial(example, radius - 4), colour=RED, width=2.5)
    drawing.path([dial(k, 40) for k in range(0, example - 6, 4)], INK, 1.2, arrow=True)
    px, py = dial(62, 62)
    drawing.text(px, py + 8, f"{example}", INK, "middle")
    # a crater lit from there: its far wall is bright, the near one in shadow
    lit = [dial(k, 26) for k in range(example + 90, example + 271, 6)]
    dark = [dial(k, 26) for k in range(example - 90, example + 91, 6)]
    drawing.path(lit, INK, 1, fill="#ffffff", closed=True)
    drawing.path(dark, INK, 1, fill="#555555", closed=True)
    drawing.text(690, 376, "counter-clockwise, as the viewer sees it", GREY, "middle", 12)
    return drawing


def attitude_frames():
    words = [word.lower() for word in enumeration("AttitudeFrame")]
    if words != ["moonme", "moonmeepoch", "j2000", "lvlh"]:
        sys.exit(f"draw.py: AttitudeFrame has {words}; draw the new ones too")
    drawing = Drawing(960, 356, "The axes of --attitude-frame")
    turned = math.radians(40.0)  # of the Moon since the epoch; a day is 13
    radius, y = 62.0, 165.0

    def towards(x, angle, length):
        return x + length * math.cos(angle), y - length * math.sin(angle)

    def axes(x, angle, colours=(RED, GREEN), names=("x", "y"), dashes=None):
        for turn, colour, name in zip((0.0, math.pi / 2.0), colours, names):
            drawing.arrow((x, y), towards(x, angle + turn, 92), colour=colour, width=1.2 if dashes else 2, dashes=dashes)
            px, py = towards(x, angle + turn, 104)
            drawing.text(px, py + 5, name, colour, "middle")
        drawing.circle(x, y, 5, BLUE, 1.5, "white")
        drawing.dot(x, y, 2, BLUE)
        drawing.text(x - 10, y + 16, "z", BLUE, "end")

    def moon(x):
        drawing.circle(x, y, radius, GREY, 1, PALE[INK])
        px, py = towards(x, turned, radius)
        drawing.dot(px, py, 4.5, ORANGE)

    notes = (
        ("moon-me (the default)", "x: latitude 0, longitude 0\ny: longitude 90 east, z: north pole\nof the time of the image:\nthey turn with the Moon"),
        ("moon-me-epoch", "the same axes at --epoch,\nheld still in space\n(orange: longitude 0 later)"),
        ("j2000", "x: vernal equinox, z: Earth's\nnorth pole of J2000 (22 to 25\ndegrees from the Moon's), at rest"),
        ("lvlh", "z: to the Moon's centre\ny: against the angular momentum\nx: forward"),
    )
    for index, (title, words) in enumerate(notes):
        x = 118.0 + 240.0 * index
        drawing.text(x, 24, title, bold=True, anchor="middle")
        drawing.text(x, 272, words, INK, "middle", 12)
        if title.startswith("moon-me"):
            moon(x)
            axes(x, turned if index == 0 else 0.0)
            if index == 0:
                drawing.path([towards(x, 0.0, 0), towards(x, 0.0, 92)], GREY, 1, "4 4")
                px, py = towards(x, 0.0, 100)
                drawing.text(px, py + 16, "epoch", GREY, "middle", 12)
        elif title == "j2000":
            moon(x)
            axes(x, math.radians(-25.0))
        else:
            drawing.circle(x, y, 82, GREY, 1)
            drawing.circle(x, y, 44, GREY, 1, PALE[INK])
            at = math.radians(60.0)
            px, py = towards(x, at, 82)
            ex, ey = px - 52 * math.sin(at), py - 52 * math.cos(at)
            drawing.arrow((px, py), (ex, ey), colour=RED, width=2)
            drawing.text(ex - 8, ey + 4, "x", RED, "end")
            ex, ey = towards(x, at, 34)
            drawing.arrow((px, py), (ex, ey), colour=BLUE, width=2)
            drawing.text(ex - 8, ey + 14, "z", BLUE, "middle")
            drawing.circle(px, py, 6, GREEN, 1.5, "white")
            drawing.path([(px - 4, py - 4), (px + 4, py + 4)], GREEN, 1.5)
            drawing.path([(px - 4, py + 4), (px + 4, py - 4)], GREEN, 1.5)
            drawing.text(px + 12, py + 4, "y", GREEN)
            drawing.arrow(*[towards(x, math.radians(k), 82) for k in range(-60, -19, 5)], colour=GREY, width=1.5)
            drawing.text(x + 60, y + 84, "flight", GREY, "middle", 12)
    drawing.text(20, 346, "Seen from above the Moon's north pole; the Moon has turned since the epoch. Circle with dot: towards the viewer, with cross: away.", GREY, size=12)
    return drawing


def selection():
    size = constant("TileId", "SizeDegrees")
    drawing = Drawing(960, 360, "Which ground an image needs")
    x, y, radius, camera, sun = 420.0, 190.0, 120.0, (860.0, 190.0), math.radians(65.0)

    def at(degrees, reach=radius):
        """A place on the Moon, degrees counter-clockwise from the direction of the camera."""
        return x + reach * math.cos(math.radians(degrees)), y - reach * math.sin(math.radians(degrees))

    def arc(first, last, colour, width=7):
        drawing.path([at(first + (last - first) * k / 24) for k in range(25)], colour, width)

    limb = math.degrees(math.acos(radius / (camera[0] - x)))
    terminator = math.degrees(sun) - 90.0
    drawing.circle(x, y, radius, GREY, 1, "#f4f8fd")
    arc(limb, 180.0, GREY, 3)
    arc(180.0, 360.0 - limb, GREY, 3)
    arc(terminator, limb, BLUE)
    arc(-limb, terminator, INK)
    arc(limb, limb + 16.0, ORANGE)
    arc(terminator - 7.0, terminator, GREEN)
    for side in (-1, 1):
        drawing.path([camera, at(side * limb)], GREY, 1, "4 4")
    for k in (-1, 0, 1):
        foot = (x + 150 * math.cos(sun) + 22 * k * math.sin(sun), y - 150 * math.sin(sun) + 22 * k * math.cos(sun))
        drawing.arrow((foot[0] + 40 * math.cos(sun), foot[1] - 40 * math.sin(sun)), foot, colour=RED, width=1.5)
    drawing.dot(*camera, 6, INK)
    drawing.text(camera[0], camera[1] + 24, "camera", INK, "middle", bold=True)
    drawing.text(560, 30, "from the Sun", RED, size=12)
    drawing.text(560, 96, "seen and lit: taken", BLUE, bold=True)
    drawing.text(300, 40, "not seen, may throw\nshadows on what is seen: taken", ORANGE, "end", bold=True)
    drawing.text(560, 262, "dark, beside something lit: taken", GREEN, bold=True)
    drawing.text(560, 300, "seen and dark: night, left out", INK, bold=True)
    drawing.text(270, 200, "behind the limb: left out", GREY, "end", bold=True)
    drawing.text(20, 346, f"Not to scale. Squares of cells are tested by the bounds of their facets. With --lod off all of a tile of {size:g} x {size:g} degrees is taken or left out.", GREY, size=12)
    return drawing


def light_space():
    drawing = Drawing(960, 330, "Light space")
    sun = 330.0  # D: from the Sun to the middle of the drawing's ground, which lies far too near to it
    slope = math.radians(13.0)  # of the ground towards the Sun's rays

    def ground(along):
        """(u, w) of the ground: w away from the Sun, u across, upwards."""
        height = 22.0 * math.exp(-((along + 45.0) / 13.0) ** 2) + 10.0 * math.exp(-((along - 52.0) / 9.0) ** 2)
        return along * math.sin(slope) + height * math.cos(slope) - 30.0, along * math.cos(slope) - height * math.sin(slope)

    def in_light_space(point):
        u, w = point
        scale = sun / (sun + w)
        return scale * u, scale * w

    points = [ground(along) for along in range(-95, 96, 5)]
    mapped = [in_light_space(point) for point in points]

    def is_away(index):
        """Whether the facet from a point to the next one is turned away from the Sun: its upper side looks along the rays."""
        return mapped[index + 1][0] < mapped[index][0]

    def is_dark(index):
        """Whether a facet that is turned away lies on the ray to the point, nearer to the Sun."""
        u, w = mapped[index]
        return any(is_away(k) and mapped[k + 1][0] < u < mapped[k][0] and mapped[k][1] < w - 1.0 for k in range(len(points) - 1) if k + 1 < index)

    def receives(index):
        return not (is_away(index) if index + 1 < len(points) else False) and not (index and is_away(index - 1))

    stretch = 2.2  # of u on the paper; straight lines stay straight

    def panel(left, shapes, begin):
        """Draws points (u, w); begin gives where the ray to a point comes from, on the paper."""
        def paper(point):
            return left + point[1], 150.0 - stretch * (point[0] + 12.0)

        for index in range(3, len(points), 3):
            if receives(index):
                dark = is_dark(index)
                drawing.path([begin(paper(shapes[index])), paper(shapes[index])], GREY if dark else ORANGE, 1, "3 4" if dark else None)
        for index in range(len(points) - 1):
            drawing.path([paper(shapes[index]), paper(shapes[index + 1])], RED if is_away(index) else INK, 3 if is_away(index) else 2)
        for index in range(3, len(points), 3):
            if receives(index):
                drawing.dot(*paper(shapes[index]), 4.5, INK if is_dark(index) else ORANGE)

    at_sun = (30.0, 150.0 - stretch * 12.0)
    drawing.text(20, 24, "In space", bold=True)
    panel(at_sun[0] + sun, points, lambda point: at_sun)
    drawing.circle(*at_sun, 9, ORANGE, 1, ORANGE)
    drawing.text(20, at_sun[1] - 18, "Sun", ORANGE)
    drawing.text(560, 24, "In light space: (u, v, w) D / (D + w)", bold=True)
    panel(760.0, mapped, lambda point: (570.0, point[1]))
    drawing.text(570, 60, "all rays are parallel to w", ORANGE)
    drawing.arrow((480, 150), (545, 150), colour=GREY, width=2)
    drawing.arrow((870, 285), (920, 285), colour=GREY)
    drawing.text(926, 289, "w", GREY)
    drawing.arrow((870, 285), (870, 240), colour=GREY)
    drawing.text(866, 234, "u", GREY)
    for x, colour, words in ((20, RED, "facets turned away from the Sun: only these throw shadows"), (430, ORANGE, "point that the Sun reaches"), (660, INK, "point in shadow: a red facet before it")):
        drawing.dot(x + 4, 311, 4.5, colour)
        drawing.text(x + 16, 316, words, colour, size=12)
    return drawing


DRAWINGS = {
    "data-flow": data_flow,
    "camera": camera,
    "attitude-frames": attitude_frames,
    "illumination-direction": illumination,
    "selection": selection,
    "light-space": light_space,
}


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in DRAWINGS.items():
        draw().save(folder / f"{name}.svg")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
