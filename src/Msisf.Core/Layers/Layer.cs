using Msisf.Core.Terrain;

namespace Msisf.Core.Layers;

/// <summary>One kind of ground truth, an image of numbers. Immutable; docs/formats.md has the definitions.</summary>
public sealed class Layer
{
    /// <summary>Value of undefined pixels in layers of whole numbers; -1 is not used, because it is a valid line of cells.</summary>
    public const int UndefinedNumber = int.MinValue;

    internal Layer(string name, LayerType type, string unit, string description, LayerValues values, params string[] planeNames)
    {
        Name = name;
        Type = type;
        Unit = unit;
        Description = description;
        Values = values;
        PlaneNames = planeNames;
    }

    /// <summary>Name of the layer as in <c>--layers</c>, e.g. "pixel-scale".</summary>
    public string Name { get; }

    /// <summary>EXTNAME in FITS: the name in capitals, with underscores: "PIXEL_SCALE".</summary>
    public string ExtensionName => Name.ToUpperInvariant().Replace('-', '_');

    /// <summary>How the values are stored in double precision.</summary>
    public LayerType Type { get; }

    /// <summary>Unit of the values: "m", "deg", or empty for a pure number.</summary>
    public string Unit { get; }

    /// <summary>The definition in one or two sentences, ASCII.</summary>
    public string Description { get; }

    /// <summary>The definition on polar maps, where it is another one.</summary>
    internal string? DescriptionOnPolarMaps { get; init; }

    /// <summary>What each plane holds ("x", "y", "z"); empty for a layer of one number a pixel.</summary>
    public IReadOnlyList<string> PlaneNames { get; }

    /// <summary>Number of values of a pixel: 1, or one for each of <see cref="PlaneNames"/>.</summary>
    public int Planes => Math.Max(1, PlaneNames.Count);

    internal LayerValues Values { get; }

    /// <summary>The definition for a mesh of this resolution, which says whether it is one of latitude and longitude.</summary>
    public string DescriptionOn(GridResolution mesh) =>
        mesh.PixelsPerDegree is null ? DescriptionOnPolarMaps ?? Description : Description;

    /// <summary>How the values are stored in a precision.</summary>
    public LayerType StoredType(LayerPrecision precision) =>
        Type == LayerType.Real64 && precision == LayerPrecision.Real32 && !KeepsDouble ? LayerType.Real32 : Type;

    /// <summary>Whether only a camera with a detector has it.</summary>
    public bool NeedsDetector { get; init; }

    /// <summary>Whether only a frame with a catalogue of craters has it.</summary>
    public bool NeedsCraters { get; init; }

    /// <summary>Whether only a frame with stars or bodies of the sky has it.</summary>
    public bool NeedsSky { get; init; }

    /// <summary>Whether only a frame with light that ground throws on ground has it.</summary>
    public bool NeedsIndirect { get; init; }

    /// <summary>Whether it is of use for scenes of several elevation models, or with invented ground, only.</summary>
    public bool NeedsModels { get; init; }

    /// <summary>Whether only a frame with invented ground has it.</summary>
    public bool NeedsInventedGround { get; init; }

    /// <summary>Whether single precision is too coarse: 7 digits of a latitude, longitude or position are metres on the ground.</summary>
    public bool KeepsDouble { get; init; }

    /// <summary>Whether the values are directions in degrees, [0, 360): in single precision those just below 360 become 0.</summary>
    public bool IsDirection { get; init; }

    /// <summary>Whether the layer has values also where a pixel's centre shows no surface.</summary>
    internal bool CoversImage { get; init; }
}

/// <summary>How a layer's values are stored.</summary>
public enum LayerType
{
    /// <summary>IEEE 754 double; NaN where undefined, as the FITS standard 4.0, section 5.3, has it.</summary>
    Real64,

    /// <summary>IEEE 754 single precision, rounded to nearest; NaN where undefined.</summary>
    Real32,

    /// <summary>0 to 255; always defined.</summary>
    Unsigned8,

    /// <summary>32 bits, signed; <see cref="Layer.UndefinedNumber"/> where undefined.</summary>
    Signed32,
}

/// <summary>Precision of the real numbers in a layer's file.</summary>
public enum LayerPrecision
{
    /// <summary>Doubles everywhere.</summary>
    Real64,

    /// <summary>Single precision, except in layers that place a point on the Moon (<see cref="Layer.KeepsDouble"/>).</summary>
    Real32,
}

/// <summary>Computes the values of one row of a layer.</summary>
/// <param name="plane">0 to <see cref="Layer.Planes"/> - 1.</param>
/// <param name="values">
/// Receives a value for each pixel that shows the surface, from left to right, of a layer that <see cref="Layer.CoversImage"/> for each
/// pixel: in the layer's unit, NaN where it is undefined. Seven more may be written after them.
/// </param>
internal delegate void LayerValues(LayerRow row, int plane, double[] values);

/// <summary>Sizes of stored numbers.</summary>
public static class LayerTypeSize
{
    /// <summary>Bytes of a number.</summary>
    public static int Size(this LayerType type) => type switch
    {
        LayerType.Real64 => sizeof(double),
        LayerType.Unsigned8 => sizeof(byte),
        _ => sizeof(int),
    };
}
