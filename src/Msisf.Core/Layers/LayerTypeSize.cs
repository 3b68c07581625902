namespace Msisf.Core.Layers;

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
