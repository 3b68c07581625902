namespace Msisf.Adapters.Layers;

/// <summary>How the numbers of a layer follow each other in memory.</summary>
/// <param name="IsInterleaved">Whether the values of a pixel lie side by side; if not, the planes follow each other.</param>
/// <param name="IsBigEndian">Whether the most significant byte comes first; if not, the order is the machine's.</param>
internal readonly record struct LayerLayout(bool IsInterleaved, bool IsBigEndian)
{
    /// <summary>That of the data in a FITS file.</summary>
    public static LayerLayout Fits => new(IsInterleaved: false, IsBigEndian: true);

    /// <summary>That in which CFITSIO takes pixels.</summary>
    public static LayerLayout ForCFitsio => new(IsInterleaved: false, IsBigEndian: !BitConverter.IsLittleEndian);

    /// <summary>That of NumPy's arrays.</summary>
    public static LayerLayout Npy => new(IsInterleaved: true, IsBigEndian: !BitConverter.IsLittleEndian);
}
