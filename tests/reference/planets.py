"""Magnitudes of planets for Msisf.Core.Tests/Sky/SkyBodyTests.cs, by the formulas of Skyfield (python3-skyfield).

Run: /usr/bin/python3 tests/reference/planets.py
"""
from skyfield import magnitudelib as m

print("1", m._mercury_magnitude(0.31, 1.2, 75.0))
print("2", m._venus_magnitude(0.72, 0.9, 80.0), m._venus_magnitude(0.72, 0.28, 170.0))
print("399", m._earth_magnitude(0.99, 0.0026, 60.0))
print("4", m._mars_magnitude(1.4, 0.7, 30.0), m._mars_magnitude(1.6, 1.3, 65.0))
print("5", m._jupiter_magnitude(5.2, 4.3, 7.0), m._jupiter_magnitude(5.2, 4.3, 90.0))
print("6", m._saturn_magnitude(9.5, 8.6, 4.0, -21.0, -18.0), m._saturn_magnitude(9.5, 8.6, 4.0, 3.0, -1.0))
print("7", m._uranus_magnitude(19.2, 18.3, 2.0, 50.0, -52.0), m._uranus_magnitude(19.2, 18.3, 20.0, 50.0, 52.0))
print("8", m._neptune_magnitude(30.0, 29.1, 1.0, 1992.0), m._neptune_magnitude(30.0, 29.1, 40.0, 2010.0))
