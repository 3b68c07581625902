namespace Msisf.Core.Certainty;

/// <summary>Bounds of an image, by rows from the top.</summary>
public sealed class CertainImage
{
    internal CertainImage(int width, int height)
    {
        (Width, Height) = (width, height);
        (Low, High, States) = (new double[width * height], new double[width * height], new CertainState[width * height]);
    }

    /// <summary>px.</summary>
    public int Width { get; }

    /// <summary>px.</summary>
    public int Height { get; }

    /// <summary>I/F: the least of each pixel.</summary>
    public double[] Low { get; }

    /// <summary>I/F: the greatest of each pixel.</summary>
    public double[] High { get; }

    /// <summary>What is certain of each pixel.</summary>
    public CertainState[] States { get; }

    /// <summary>Their numbers.</summary>
    internal byte[] StateNumbers => [.. States.Select(state => (byte)state)];
}

/// <summary>What is certain of a pixel; the numbers are those of the layer.</summary>
public enum CertainState : byte
{
    /// <summary>It shows no ground.</summary>
    NoSurface = 0,

    /// <summary>All of its samples show ground that sees the whole Sun.</summary>
    Lit = 1,

    /// <summary>All of its samples show ground that sees nothing of the Sun.</summary>
    Dark = 2,

    /// <summary>None of these.</summary>
    Undecided = 3,
}
