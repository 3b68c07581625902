"""Earthshine for Msisf.Core.Tests/Sky/EarthLightTests.cs: the light of a Lambert sphere, lit by the Sun, on facets of the Moon, summed over its
surface by numpy; over what it would be from far away at the same distance of the centre.

Run: /usr/bin/python3 tests/reference/earthshine.py
"""
import numpy as np

R, D = 6378136.6, 3.844e8


def irradiance(phase, normal):
    """Sum over the sphere; observer at the origin, centre at (D, 0, 0), Sun in the plane of x and y."""
    n = 2000
    mu = (np.arange(n) + 0.5) / n * 2 - 1
    phi = (np.arange(2 * n) + 0.5) / (2 * n) * 2 * np.pi
    mu, phi = np.meshgrid(mu, phi)
    s = np.sqrt(1 - mu * mu)
    p = np.stack([s * np.cos(phi), s * np.sin(phi), mu])
    sun = np.array([-np.cos(phase), np.sin(phase), 0.0])
    lit = np.clip(np.tensordot(sun, p, 1), 0, None)
    at = R * p + np.array([D, 0, 0])[:, None, None]
    way = np.sqrt((at * at).sum(0))
    to = at / way
    out = np.clip(-(to * p).sum(0), 0, None)
    each = lit * out / way ** 2
    return (each * np.clip(np.tensordot(np.array(normal), to, 1), 0, None)).sum() / (lit * np.clip(-p[0], 0, None)).sum() * D ** 2


for degrees in (5, 60, 90, 140):
    for normal in ((1, 0, 0), (0.5, np.sqrt(0.75), 0), (0.2, -np.sqrt(0.96), 0)):
        print(degrees, normal, "%.6f" % irradiance(np.radians(degrees), normal))
