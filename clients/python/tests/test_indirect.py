"""Light that the ground throws on ground (docs/photometry.md) against numpy: rays from a point in all directions, followed step by step.

Nothing is shared with msis: no points that stand for ground, no groups of pixels, no random numbers. The server draws.
"""

import numpy as np
import pytest
from numpy_camera import looking_down
from numpy_moon import GROUND, gathered_light

TIME = 55289.0  # the Sun is over 1.5 N, 44 W
CAMERA = {"width": 24, "height": 16, "principal-point": [7.3, 11.6], "focal-length-px": [30, 33], "skew": 1.5}
DETECTOR = {
    "aperture": 5, "exposure-time": 1e-3, "quantum-efficiency": 0.5, "band": [633, 653], "gain": 2000, "adc-bits": 12, "seed": "none",
}  # fmt: skip
PLACE = {"latitude": 35.0, "longitude": 43.0, "height": 5e5}  # low Sun


def render(moon, camera, file, **options):
    return moon.render(camera.position, camera.quaternion(), TIME, camera=file, lod="off", reflectance="lambert", **options)


def test_layer_is_the_light_that_rays_in_all_directions_find(moon):
    camera = looking_down(CAMERA, **PLACE)

    frame = render(moon, camera, CAMERA, indirect=1, indirect_error=0.02, layers=["indirect", "mask"])

    points = GROUND.hit(camera.position, camera.rays(camera.pixels()))
    layer = frame.layers["indirect"].ravel()
    ranked = np.argsort(layer)[::-1]  # from the brightest on
    lit, shadow = (ranked[frame.mask.ravel()[ranked] == state] for state in (1, 3))
    assert len(lit) > 100 and len(shadow) > 10
    some = np.concatenate([part[:: len(part) // 5] for part in (lit, shadow)])
    expected = gathered_light(points[some], frame.sun_position)
    assert np.sqrt(np.mean((layer[some] - expected) ** 2)) < 0.1 * np.sqrt(np.mean(expected**2))
    assert layer[some].sum() == pytest.approx(expected.sum(), rel=0.05)


@pytest.mark.parametrize(
    ("file", "bounces", "options"),
    [
        ({}, 1, {}),
        ({}, 2, {"sun": "disc", "reflectance": "lommel-seeliger"}),
        ({"detector": DETECTOR}, 1, {}),
        ({"distortion": {"model": "brown-conrady", "k1": -0.1, "k2": 0.02}}, 1, {"samples": 4, "shading": "smooth"}),
    ],
    ids=["plain", "disc and another law", "detector", "lens and several samples"],
)
def test_layer_is_what_the_option_adds_to_the_image(moon, file, bounces, options):
    file = {**CAMERA, **file}
    camera = looking_down(file, **PLACE)
    options = {"layers": ["radiance-factor", *(["electrons"] if "detector" in file else [])], **options}
    options = {"reflectance": "lambert", **options}

    alone = moon.render(camera.position, camera.quaternion(), TIME, camera=file, lod="off", **options)
    options["layers"] = [*options["layers"], "indirect"]
    both = moon.render(
        camera.position, camera.quaternion(), TIME, camera=file, lod="off", indirect=bounces, indirect_error=0.2, **options
    )

    added = both.layers["radiance-factor"] - alone.layers["radiance-factor"]
    assert both.layers["indirect"].max() > 0.0
    np.testing.assert_allclose(added, both.layers["indirect"], atol=1e-12)
    if "detector" in file:
        light, electrons = both.layers["radiance-factor"], both.layers["electrons"]
        lit, dark = alone.layers["radiance-factor"] > 0.0, (alone.layers["radiance-factor"] == 0.0) & (light > 1e-7)
        per_light = electrons[lit] / light[lit]
        np.testing.assert_allclose(per_light, alone.layers["electrons"][lit] / alone.layers["radiance-factor"][lit], rtol=1e-9)
        assert dark.any() and not alone.layers["electrons"][dark].any()
        np.testing.assert_allclose(electrons[dark] / light[dark], np.median(per_light), rtol=0.3)  # pixels differ in solid angle
