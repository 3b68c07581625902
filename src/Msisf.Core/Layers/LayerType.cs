namespace Msisf.Core.Layers;

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
