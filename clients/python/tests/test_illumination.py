"""Maps of light as arrays."""

import numpy as np
import pytest

import msisf

WHERE = dict(center=(-89.6, 100.0), size=(4, 3), cell=500, time_interval="61041:6h:61072")


def test_maps_of_a_region_are_arrays_that_agree(tmp_path):
    maps = msisf.illumination(**WHERE, above_ground=[2], folder=tmp_path)
    assert maps["lit"].shape == (6, 8) and maps["lit"].dtype == np.float32
    assert np.all(maps["disc"] <= maps["lit"]) and np.array_equal(maps["never_lit"] == 1, maps["lit"] == 0)
    # A second call takes the horizons that are there, and rays to a point Sun are another question.
    kept = sorted((tmp_path / "horizons").iterdir())
    point = msisf.illumination(**WHERE, above_ground=[2], sun="point", exact=True, folder=tmp_path)
    assert sorted((tmp_path / "horizons").iterdir()) == kept
    assert np.all(point["lit"] <= maps["lit"])
    assert np.array_equal(point["slope"], maps["slope"])


def test_wrong_options_say_what_is_wrong():
    with pytest.raises(msisf.MsisfError, match="runs backwards"):
        msisf.illumination(center=(-89, 0), size=1, time_interval="61041:1h:61040")
    with pytest.raises(TypeError, match="takes no points"):
        msisf.illumination(points="a.csv", time_interval="61041:1h:61042")
