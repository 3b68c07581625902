namespace Msisf.Core.Navigation;

/// <summary>Where the surface points of a frame's pixels lie in another frame. Arrays by rows, a number for each pixel.</summary>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
public sealed record FlowField(int Width, int Height)
{
    /// <summary>px: to the right, from the pixel's centre to the point's place in the other frame; NaN where there is none.</summary>
    public double[] Right { get; } = new double[Width * Height];

    /// <summary>px: down.</summary>
    public double[] Down { get; } = new double[Width * Height];

    /// <summary><see cref="FlowClass"/>: what the other frame shows of the points.</summary>
    public byte[] Classes { get; } = new byte[Width * Height];

    /// <summary><see cref="FlowLight"/>: how the light on the points differs.</summary>
    public byte[] Lights { get; } = new byte[Width * Height];
}

/// <summary>What another frame shows of a surface point; the numbers are those of the files.</summary>
public enum FlowClass : byte
{
    /// <summary>The pixel shows no surface.</summary>
    NoSurface = 0,

    /// <summary>The other frame shows the point.</summary>
    Seen = 1,

    /// <summary>Its place lies inside the other image, but its facet faces away, or terrain lies in front of it.</summary>
    Hidden = 2,

    /// <summary>Its place lies outside the other image, or it lies behind that camera.</summary>
    Outside = 3,
}

/// <summary>How the light on a surface point differs in two frames; the numbers are those of the files.</summary>
public enum FlowLight : byte
{
    /// <summary>The pixel shows no surface.</summary>
    NoSurface = 0,

    /// <summary>Some of the Sun shines on it in both.</summary>
    LitInBoth = 1,

    /// <summary>None in either.</summary>
    DarkInBoth = 2,

    /// <summary>Dark in one, because terrain is between it and the Sun.</summary>
    ChangedByShadow = 3,

    /// <summary>Dark in one, because its facet faces away from the Sun.</summary>
    ChangedBySlope = 4,
}
