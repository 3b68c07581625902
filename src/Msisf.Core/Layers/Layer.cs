namespace Msisf.Core.Layers;

/// <summary>One kind of ground truth, a picture of numbers. Immutable; docs/formats.md has the definitions.</summary>
public sealed class Layer
{
    /// <summary>Stands for "undefined" in layers of whole numbers that have such pixels: tile and cell ids start at 0.</summary>
    public const int UndefinedNumber = -1;

    internal Layer(string name, LayerType type, string unit, string description, LayerValue value, bool isVector = false)
    {
        Name = name;
        Type = type;
        Unit = unit;
        Description = description;
        Value = value;
        IsVector = isVector;
    }

    /// <summary>As in <c>--layers</c>: "pixel-scale".</summary>
    public string Name { get; }

    /// <summary>EXTNAME in FITS: the name in capitals, with underscores: "PIXEL_SCALE".</summary>
    public string ExtensionName => Name.ToUpperInvariant().Replace('-', '_');

    /// <summary>How the values are stored.</summary>
    public LayerType Type { get; }

    /// <summary>"m", "deg", or empty for a pure number.</summary>
    public string Unit { get; }

    /// <summary>The definition in one or two sentences, ASCII.</summary>
    public string Description { get; }

    /// <summary>Three planes: x, y and z in MOON_ME.</summary>
    public bool IsVector { get; }

    /// <summary>1, or 3 for a vector.</summary>
    public int Planes => IsVector ? 3 : 1;

    internal LayerValue Value { get; }
}
