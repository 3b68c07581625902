namespace Msisf.Core.Layers;

/// <summary>All layers, in the order in which files hold them.</summary>
public static class LayerCatalogue
{
    /// <summary>All layers.</summary>
    public static IReadOnlyList<Layer> All { get; } =
    [
        new(
            "depth", LayerType.Real64, "m",
            "Distance of the surface point from the camera's focal point along the optical axis: the depth map of computer vision.",
            SurfaceValues.Depth),
        new(
            "range", LayerType.Real64, "m",
            "Distance of the surface point from the camera's focal point along the pixel's ray: the slant range of remote sensing.",
            SurfaceValues.Range),
        new(
            "position", LayerType.Real64, "m",
            "Surface point from the Moon's centre, in MOON_ME.",
            SurfaceValues.Position,
            "x", "y", "z")
        {
            KeepsDouble = true,
        },
        new("latitude", LayerType.Real64, "deg", "Planetocentric latitude, -90 to 90.", SurfaceValues.Latitude)
        {
            KeepsDouble = true,
        },
        new("longitude", LayerType.Real64, "deg", "East longitude, 0 to below 360; 0 on the polar axis.", SurfaceValues.Longitude)
        {
            KeepsDouble = true,
        },
        new("height", LayerType.Real64, "m", "Height over the sphere of 1 737 400 m.", SurfaceValues.Height),
        new(
            "normal", LayerType.Real64, string.Empty,
            "Outward surface normal that shades the point, length 1, in MOON_ME.",
            SurfaceValues.Normal,
            "x", "y", "z"),
        new(
            "incidence",
            LayerType.Real64,
            "deg",
            "Angle between NORMAL and the direction to the Sun's centre, 0 to 180.",
            LightValues.Incidence),
        new("emission", LayerType.Real64, "deg", "Angle between NORMAL and the direction to the camera, 0 to 180.", LightValues.Emission),
        new("phase", LayerType.Real64, "deg", "Angle at the surface point between Sun and camera, 0 to 180.", LightValues.Phase),
        new(
            "illumination-direction", LayerType.Real64, "deg",
            "Direction in the image in which the Sun lies along the ground: 0 down, 90 right, 180 up, 270 left. "
                + "Undefined where the Sun is in the zenith.",
            LightValues.Direction)
        {
            IsDirection = true,
        },
        new(
            "mask", LayerType.Unsigned8, string.Empty,
            "0 no surface, 1 lit, 2 penumbra, 3 shadow (Sun's centre above the point's horizontal plane, but hidden or behind the facet), "
                + "4 night.",
            LightValues.State),
        new(
            "sun-visibility", LayerType.Real64, string.Empty,
            "Part of the Sun's disc that shines on the point, 0 to 1.",
            LightValues.VisibleFraction),
        new(
            "tile", LayerType.Signed32, string.Empty,
            "5 x 5 degree tile: 72 row + column; southern border -90 + 5 row, western border 5 column degrees.",
            SurfaceValues.Tile)
        {
            DescriptionOnPolarMaps = "Undefined: a polar map has no tiles.",
        },
        new(
            "cell", LayerType.Signed32, string.Empty,
            "Cell of the mesh of MESHRES px/deg: line (0 northernmost) and sample of its north-western vertex; "
                + "line -1 is the fan round the north pole.",
            SurfaceValues.Cell,
            "line", "sample")
        {
            DescriptionOnPolarMaps =
                "Cell of the polar map at the level of detail that was drawn: line (0 uppermost) and sample (0 leftmost) of its upper left "
                    + "vertex in the map's image.",
        },
        new(
            "pixel-scale", LayerType.Real64, "m",
            "Side of the square with the area of the pixel's beam at the point, across the line of sight.",
            SurfaceValues.PixelScale),
        new(
            "slope", LayerType.Real64, "deg",
            "Angle between NORMAL and the direction from the Moon's centre, 0 to 180.",
            SlopeValues.Slope),
        new(
            "aspect", LayerType.Real64, "deg",
            "Azimuth in which the ground falls, clockwise from north: 0 north, 90 east, 180 south, 270 west. "
                + "Undefined on level ground and on the polar axis.",
            SlopeValues.Aspect)
        {
            IsDirection = true,
        },
        new(
            "sphere-incidence", LayerType.Real64, "deg",
            "Angle between the direction from the Moon's centre and the direction to the Sun's centre, 0 to 180.",
            SlopeValues.SphereIncidence),
        new(
            "radiance-factor", LayerType.Real64, string.Empty,
            "I/F of the image: pi times the radiance over the Sun's irradiance, mean over the pixel's samples; 0 without surface or light.",
            ImageValues.RadianceFactor)
        {
            CoversImage = true,
        },
        new(
            "radiance", LayerType.Real64, "W m-2 sr-1 nm-1",
            "Spectral radiance of the image in the band of --band. Undefined without the Sun.",
            ImageValues.Radiance)
        {
            CoversImage = true,
        },
        new(
            "electrons", LayerType.Real64, "electron",
            "Mean number of electrons that the light of the scene frees in the pixel during the exposure: after optics and PSF, before "
                + "smear, fixed pattern, dark current and noise.",
            ImageValues.Electrons)
        {
            NeedsDetector = true,
            CoversImage = true,
        },
        new(
            "saturated", LayerType.Unsigned8, string.Empty,
            "0 where the DN is in proportion to the light, 1 at the highest DN, 2 at the full well, 3 at both.",
            ImageValues.Saturation)
        {
            NeedsDetector = true,
            CoversImage = true,
        },
        new(
            "crater", LayerType.Signed32, string.Empty,
            "Row of the catalogue of --craters, from 1: the smallest of the listed craters in whose ellipse the pixel's centre lies and "
                + "which terrain does not hide there; 0 for none.",
            SurfaceValues.CraterNumber)
        {
            NeedsCraters = true,
        },
        new(
            "object", LayerType.Signed32, string.Empty,
            "What the pixel shows: 0 nothing, 1 ground, 2 a star, 10 the Sun, 399 the Earth, planets 199 to 899 (NAIF's numbers).",
            SurfaceValues.ObjectNumber)
        {
            NeedsSky = true,
            CoversImage = true,
        },
        new(
            "source", LayerType.Signed32, string.Empty,
            "Where the height comes from. Model: its number, 0 the coarsest; of a seam the finest one that it joins; invented ground "
                + "has the number after the last. Kind: 1 measured, 2 blended (changed to meet another model), 3 seam, 4 invented.",
            SurfaceValues.Source,
            "model", "kind")
        {
            NeedsModels = true,
        },
        new(
            "rays", LayerType.Real64, string.Empty,
            "Factor by which the rays of invented craters change the reflectance, 1 in the mean; a site's own map of the reflectance "
                + "counts without it.",
            SurfaceValues.Rays)
        {
            NeedsInventedGround = true,
        },
        new(
            "indirect", LayerType.Real64, string.Empty,
            "The part of I/F of the image that is light from the ground around, mean over the pixel's samples; with --samples auto, of the "
                + "pixel's centre. 0 without surface.",
            ImageValues.Indirect)
        {
            NeedsIndirect = true,
            CoversImage = true,
        },
    ];

    /// <summary>The layer "cell" of scenes of several elevation models.</summary>
    public static Layer CellOfSeveral { get; } = new(
        "cell", LayerType.Signed32, string.Empty,
        "Cell of the mesh of a model: line (0 northernmost) and sample of its north-western vertex; line -1 is the fan round the north "
            + "pole; part is the model, 0 the coarsest. The number of models stands for the seams: line 0, sample the facet's number.",
        SurfaceValues.Cell,
        "line", "sample", "part")
    {
        DescriptionOnPolarMaps =
            "Cell of the mesh of a model: line and sample of its upper left vertex in a polar map's image; of its north-western vertex "
                + "in a cylindrical model, where line -1 is the fan round the north pole; part is the model, 0 the coarsest. The number "
                + "of models stands for the seams: line 0, sample the facet's number.",
    };
}
