"""Stars and bodies of a frame: where numpy projects them, and what their truth says."""

import msisf
import numpy as np
import pytest

CAMERA = {
    "width": 160, "height": 120, "focal-length": 16, "pixel-pitch": 0.036,
    "detector": {"f-number": 1.4, "band": [420, 700], "transmission": 0.8, "quantum-efficiency": 0.5, "exposure-time": 0.4, "gain": 4,
                 "adc-bits": 12, "psf": "gaussian", "psf-sigma": 0.7, "fits": "no"},
}  # fmt: skip


def render(moon, **options):
    return moon.render(position=(5.0, 125.0, 400e3), look_at="horizon:274", time="2010-04-06T20:24:00Z", camera=CAMERA, **options)


def test_stars_are_record_arrays(moon):
    frame = render(moon, stars=True, planets=True, earth=True)

    stars = frame.stars
    assert len(stars) > 20 and all(str(name).startswith("HIP ") for name in stars.id)
    seen = stars[stars.visible]
    assert 0 < len(seen) < len(stars) and np.all(seen.electrons > 0.0) and all(by for by in stars[~stars.visible].hiddenBy)
    assert stars.hByTurn.shape == (len(stars), 3) and np.all(np.isnan(stars.start))  # no motion, no streaks

    # The camera's own turns: two stars of different places tell how the body's axes lie, as do all others.
    ra, dec = np.radians(stars.rightAscension), np.radians(stars.declination)
    sky = np.stack([np.cos(dec) * np.cos(ra), np.cos(dec) * np.sin(ra), np.sin(dec)], axis=1)
    pixels = np.stack([stars.h - 1.0, stars.v - 1.0, np.ones(len(stars))])
    rays = (np.linalg.inv(frame.K) @ pixels).T
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    u, _, vt = np.linalg.svd(rays.T @ sky)
    turn = u @ np.diag([1.0, 1.0, np.linalg.det(u @ vt)]) @ vt
    np.testing.assert_allclose(sky @ turn.T, rays, atol=1e-10)

    earth = frame.bodies[frame.bodies.name == "Earth"][0]
    assert earth.electrons > 1e8 and 0.0 < earth.visible <= 1.0 and 3.6e8 < earth.distance < 4.1e8
    assert len(render(moon).stars) == 0 and len(render(moon).bodies) == 0


def test_derivatives_are_differences(moon):
    frame = render(moon, stars=True)
    star = frame.stars[0]
    ray = np.linalg.inv(frame.K) @ [star.h - 1.0, star.v - 1.0, 1.0]
    camera = np.array([-ray[2], ray[0], -ray[1]])  # looks along -x, y right, z up
    for axis, (by_h, by_v) in enumerate(zip(star.hByTurn, star.vByTurn)):
        step = 1e-6
        moved = camera - step * np.cross(np.eye(3)[axis], camera)  # the camera turns, the star stays
        seen = frame.K @ [moved[1], -moved[2], -moved[0]]
        np.testing.assert_allclose((seen[:2] / seen[2] + 1.0 - [star.h, star.v]) / step, [by_h, by_v], rtol=1e-4, atol=1e-2)


def test_unknown_catalogue_is_named(moon):
    with pytest.raises(msisf.RequestError, match="'stars' is 'tycho'"):
        render(moon, stars="tycho")
