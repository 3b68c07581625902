"""Compares maps of msis (--map) with the layers of the same images, as GDAL reads both, and with a camera over the facets of LDEM_4.

  maps.py NUMPY_MOON FOLDER...

NUMPY_MOON is the folder of numpy_moon.py. In each folder lie frame.xml, frame.*.npy and frame.*.map.tif, of a frame of the Moon by LDEM_4
unless the folder's name begins with "other". A line for each folder: its name, PROJ's name of the map, longitude of its middle, cells that
show something, cells that were compared with the facets, and what is wrong ("ok" for nothing).
"""
import os
import sys
import xml.etree.ElementTree as ET

import numpy as np
from osgeo import gdal, osr

sys.path.insert(0, sys.argv[1])
from numpy_camera import opencv  # noqa: E402
from numpy_moon import GROUND, dot, unit  # noqa: E402

gdal.UseExceptions()
TYPES = {"float64": gdal.GDT_Float64, "float32": gdal.GDT_Float32, "uint8": gdal.GDT_Byte, "int32": gdal.GDT_Int32}
NOTHING = {"float64": np.nan, "float32": np.nan, "uint8": 255, "int32": -2147483648}


def directions(image, lines, samples):
    """Of the middles of cells, by PROJ."""
    left, cell, _, top, _, _ = image.GetGeoTransform()
    srs = osr.SpatialReference(image.GetProjection())
    srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    globe = srs.CloneGeogCS()
    globe.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    places = np.stack([left + (samples + 0.5) * cell, top - (lines + 0.5) * cell], axis=1)
    degrees = np.array(osr.CoordinateTransformation(srs, globe).TransformPoints(places))[:, :2]
    degrees[~np.isfinite(degrees)] = np.nan
    lon, lat = np.radians(degrees).T
    return np.stack([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)], axis=1)


class Frame:
    def __init__(self, path):
        camera = ET.parse(path).getroot().find("GeneralInformation/Camera")
        numbers = {name: np.array(camera.find(name).text.split(), float) for name in ("K", "R", "t")}
        self.K, self.R, self.t = numbers["K"].reshape(3, 3), numbers["R"].reshape(3, 3), numbers["t"]
        self.width, self.height = int(camera.get("width")), int(camera.get("height"))
        lens = camera.find("Distortion")
        names = "k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4".split()
        self.measured = opencv(dict(zip(names, map(float, lens.text.split()))), None)[0] if lens is not None else lambda at: at
        self.position = -self.R.T @ self.t

    def seen(self, towards):
        """Whether cells are seen, the column and row of the pixels, and how far from deciding otherwise they are (px, m)."""
        _, _, _, corner, normal = GROUND.facet(towards * 1737400.0)
        points = towards * (dot(normal, corner) / dot(normal, towards))[:, None]
        x, y, z = (points @ self.R.T + self.t).T
        at = np.column_stack([self.measured(np.stack([x / z, y / z], axis=1)), np.ones(len(z))]) @ self.K.T
        h, v = np.floor(at[:, 0] + 0.5), np.floor(at[:, 1] + 0.5)
        border = np.abs(at[:, :2] - np.floor(at[:, :2]) - 0.5).min(axis=1)
        back = self.position - points
        is_seen = (z > 0) & (h >= 0) & (h < self.width) & (v >= 0) & (v < self.height) & (dot(normal, back) > 0.0)
        room = np.full(len(z), np.inf)
        for part in np.array_split(np.nonzero(is_seen)[0], max(1, is_seen.sum() // 200)):
            if len(part):
                room[part] = GROUND.clearance(points[part], unit(back[part]), reach=3e5, step=400.0)
        is_seen &= room > 0.0
        return is_seen, h.astype(int), v.astype(int), border, np.abs(room)


def by_facets(folder, image, maps, layers, random):
    """Of some cells, and of those beside the map: shown where the camera sees them, with the numbers of their pixel."""
    frame = Frame(os.path.join(folder, "frame.xml"))
    height, width = maps["radiance-factor"].shape
    lines, samples = random.integers(-2, height + 2, 1500), random.integers(-2, width + 2, 1500)
    towards = directions(image, lines, samples)
    real = np.isfinite(towards).all(axis=1)
    lines, samples, towards = lines[real], samples[real], towards[real]
    is_seen, h, v, border, room = frame.seen(towards)
    sure = (border > 1e-6) & (room > 5.0)
    inside = (lines >= 0) & (lines < height) & (samples >= 0) & (samples < width)
    yield "facets", sure.mean() > 0.97 and is_seen.sum() > 150
    yield "beside the map", not np.any(is_seen & sure & ~inside)
    at = sure & inside
    dark = at & ~is_seen
    yield "hidden", np.all(np.isnan(maps["position"][0, lines[dark], samples[dark]]))
    at &= is_seen
    for name, values in maps.items():
        found, expected = values[..., lines[at], samples[at]], layers[name][..., v[at], h[at]]
        yield "pixels of " + name, np.array_equal(found, expected, equal_nan=values.dtype.kind == "f")


def by_positions(image, maps, layers):
    """The pixel of each cell is the one whose point is nearest; cells with a pixel's point are shown."""
    shown = np.isfinite(maps["position"][0])
    lines, samples = np.nonzero(shown)
    towards = directions(image, lines, samples)
    points = maps["position"][:, shown].T
    off = np.linalg.norm(unit(points) - towards, axis=1) * np.linalg.norm(points, axis=1)
    reach = 0.75 * maps["pixel-scale"][shown] / np.cos(np.radians(maps["emission"][shown])) + 2.0
    yield "places", np.mean(off < reach) > 0.98 and np.median(off) < 0.6 * np.median(reach)
    places = np.stack([layers["longitude"], layers["latitude"], 0 * layers["latitude"]], axis=-1)
    srs = osr.SpatialReference(image.GetProjection())
    srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    globe = srs.CloneGeogCS()
    globe.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    x, y, _ = np.array(osr.CoordinateTransformation(globe, srs).TransformPoints(places[np.isfinite(layers["latitude"])])).T
    left, cell, _, top, _, _ = image.GetGeoTransform()
    line, sample = np.floor((top - y) / cell).astype(int), np.floor((x - left) / cell).astype(int)
    inside = (line >= 0) & (line < shown.shape[0]) & (sample >= 0) & (sample < shown.shape[1])
    yield "all pixels", inside.mean() > 0.98 and shown[line[inside], sample[inside]].mean() > 0.98


def check(folder):
    stem = os.path.join(folder, "frame")
    endings = [name[len("frame."):-len(".map.tif")] for name in os.listdir(folder) if name.endswith(".map.tif")]
    names = [name for name in endings if name]
    layers, maps, checks = {}, {}, []
    for name in names:
        layer = np.load(f"{stem}.{name}.npy")
        layers[name] = np.moveaxis(layer, -1, 0) if layer.ndim == 3 else layer
        image = gdal.Open(f"{stem}.{name}.map.tif")
        maps[name] = image.ReadAsArray()
        kind = layer.dtype.name
        checks += [
            (name + " type", image.GetRasterBand(1).DataType == TYPES[kind] and image.RasterCount == (3 if name == "position" else
                                                                                                      layer.size // layer[..., 0].size
                                                                                                      if layer.ndim == 3 else 1)),
            (name + " no-data", np.array_equal(image.GetRasterBand(1).GetNoDataValue(), NOTHING[kind], equal_nan=True)),
            (name + " layout", image.GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE") == "COG"),
        ]
    image = gdal.Open(f"{stem}.map.tif")
    numbers = image.ReadAsArray()
    srs = osr.SpatialReference(image.GetProjection())
    shown = np.isfinite(maps["position"][0])
    brightness = layers["radiance-factor"].astype(np.float32)
    has_detector = "Digital" in image.GetMetadataItem("DESCRIPTION")
    checks += [
        ("image", image.GetRasterBand(1).DataType == gdal.GDT_Float32),
        ("shown", np.array_equal(np.isfinite(numbers), np.isfinite(maps["radiance-factor"]))),
        ("numbers", np.all(numbers[np.isfinite(numbers)] % 1.0 == 0.0) if has_detector
         else np.array_equal(numbers, maps["radiance-factor"].astype(np.float32), equal_nan=True)),
        ("borders", shown[0].any() and shown[-1].any() and shown[:, 0].any() and shown[:, -1].any() or brightness.min() == 0.0),
        ("grid", np.all(np.mod(np.array(image.GetGeoTransform())[[0, 3]], image.GetGeoTransform()[1]) == 0.0)),
        ("sphere", srs.GetSemiMajor() == (2439400.0 if "Mercury" in srs.GetName() else 1737400.0) and srs.GetInvFlattening() == 0.0),
    ]
    random = np.random.default_rng(1)
    compared = 0 if "other" in folder else 1500
    checks += by_positions(image, maps, layers) if compared == 0 else by_facets(folder, image, maps, layers, random)
    middle = srs.GetProjParm("central_meridian")
    return srs.GetAttrValue("PROJECTION"), middle, shown.sum(), compared, [name for name, is_right in checks if not is_right]


for folder in sys.argv[2:]:
    *words, wrong = check(folder)
    print(os.path.basename(folder), *words, ",".join(wrong).replace(" ", "-") or "ok")
