namespace Msisf.Core.Layers;

/// <summary>Precision of the real numbers in a layer's file.</summary>
public enum LayerPrecision
{
    /// <summary>Doubles everywhere.</summary>
    Real64,

    /// <summary>Single precision, except in layers that place a point on the Moon (<see cref="Layer.KeepsDouble"/>).</summary>
    Real32,
}
