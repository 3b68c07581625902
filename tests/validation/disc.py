"""The brightness of the whole disc against the phase angle, beside Allen's magnitudes."""
import numpy as np

from frames import camera_quaternion, draw

PHASES_DEGREES = (5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120)
REFERENCE_DEGREES = 30
DISTANCE = 4.0e8  # m: far enough that the whole hemisphere is seen
WIDTH = 512  # px
FIELD_DEGREES = 0.52  # the disc is 0.498 degrees wide from there
TIME_MJD = 55289.0


def allen(phase_degrees):
    """Magnitude of the whole disc less that of the full Moon (C. W. Allen, Astrophysical Quantities, 3rd ed., section 66)."""
    return 0.026 * phase_degrees + 4.0e-9 * phase_degrees**4


def differences(folder, sun, *options):
    """Magnitudes that are too faint by this much, at each phase angle, both set to zero at 30 degrees.

    sun  position of the Sun, MOON_ME; the camera goes round the Moon in the plane of its equator, on both sides
    """
    towards_sun = np.asarray(sun) / np.linalg.norm(sun)
    states = []
    for side in (-1.0, 1.0):
        for phase in PHASES_DEGREES:
            angle = side * np.radians(phase)
            pole = np.array([0.0, 0.0, 1.0])
            across = np.cross(pole, towards_sun)
            across /= np.linalg.norm(across)
            direction = np.cos(angle) * towards_sun + np.sin(angle) * across
            right = np.cross(-direction, pole)
            right /= np.linalg.norm(right)
            axes = np.stack([right, np.cross(-direction, right), -direction], axis=1)
            states.append([TIME_MJD, *(DISTANCE * direction), *camera_quaternion(axes)])
    sums = np.array([image.sum() for image in draw(
        folder, states, "--width", str(WIDTH), "--height", str(WIDTH), "--fov", repr(FIELD_DEGREES), *options)])
    magnitudes = -2.5 * np.log10(sums.reshape(2, -1).mean(axis=0))
    phases = np.array(PHASES_DEGREES, float)
    at_reference = PHASES_DEGREES.index(REFERENCE_DEGREES)
    return (magnitudes - magnitudes[at_reference]) - (allen(phases) - allen(REFERENCE_DEGREES))
