"""The functions of spiceypy that docs/missions.md uses, straight on CSPICE by ctypes: its recipe runs where spiceypy is missing.

CSPICE is the library that the environment variable MSISF_CSPICE names.
"""
import ctypes
import os

_c = ctypes.CDLL(os.environ["MSISF_CSPICE"])
_double = ctypes.c_double


def furnsh(path):
    _c.furnsh_c(path.encode())


def str2et(text):
    et = _double()
    _c.str2et_c(text.encode(), ctypes.byref(et))
    return et.value


def et2utc(et, form, precision):
    text = ctypes.create_string_buffer(64)
    _c.et2utc_c(_double(et), form.encode(), precision, len(text), text)
    return text.value.decode()


def spkpos(target, et, frame, aberration, observer):
    position, light_time = (_double * 3)(), _double()
    _c.spkpos_c(target.encode(), _double(et), frame.encode(), aberration.encode(), observer.encode(), position, ctypes.byref(light_time))
    return list(position), light_time.value


def pxform(source, target, et):
    matrix = (_double * 3 * 3)()
    _c.pxform_c(source.encode(), target.encode(), _double(et), matrix)
    return [list(row) for row in matrix]


def eul2m(angle3, angle2, angle1, axis3, axis2, axis1):
    matrix = (_double * 3 * 3)()
    _c.eul2m_c(_double(angle3), _double(angle2), _double(angle1), axis3, axis2, axis1, matrix)
    return [list(row) for row in matrix]
