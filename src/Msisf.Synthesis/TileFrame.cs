namespace Msisf.Synthesis;

/// <summary>
/// A block of samples of the whole-Moon grid with the directions of its lines and columns. Lines before 0 and after the last are the
/// mirror lines beyond a pole (a latitude above 90 degrees: the opposite meridian); columns continue across the prime meridian.
/// </summary>
internal sealed class TileFrame
{
    /// <summary>Floats of a vector; the columns are padded to a multiple of it.</summary>
    public const int VectorWidth = 8;

    /// <summary>Makes the tables of a block.</summary>
    /// <param name="pixelsPerDegree">Samples a degree.</param>
    /// <param name="firstLine">Northernmost line; may be negative.</param>
    /// <param name="lines">How many lines.</param>
    /// <param name="firstSample">Westernmost column; may be negative.</param>
    /// <param name="samples">How many columns.</param>
    public TileFrame(int pixelsPerDegree, int firstLine, int lines, int firstSample, int samples)
    {
        PixelsPerDegree = pixelsPerDegree;
        FirstLine = firstLine;
        Lines = lines;
        FirstSample = firstSample;
        Samples = samples;
        Stride = (samples + VectorWidth - 1) / VectorWidth * VectorWidth;
        SinLatitude = new double[lines];
        CosLatitude = new double[lines];
        for (int line = 0; line < lines; line++)
        {
            (SinLatitude[line], CosLatitude[line]) = PortableMath.SinCosDegrees(LatitudeDegrees(line));
        }

        // Longitudes are reduced to [0, 360) first, so that a column has the same bits in every tile that holds it.
        int around = 360 * pixelsPerDegree;
        SinLongitude = new double[Stride];
        CosLongitude = new double[Stride];
        for (int column = 0; column < Stride; column++)
        {
            int sample = (((firstSample + column) % around) + around) % around;
            (SinLongitude[column], CosLongitude[column]) = PortableMath.SinCosDegrees((sample + 0.5) / pixelsPerDegree);
        }
    }

    /// <summary>Samples a degree.</summary>
    public int PixelsPerDegree { get; }

    /// <summary>Northernmost line in the whole-Moon grid.</summary>
    public int FirstLine { get; }

    /// <summary>How many lines.</summary>
    public int Lines { get; }

    /// <summary>Westernmost column in the whole-Moon grid.</summary>
    public int FirstSample { get; }

    /// <summary>How many columns.</summary>
    public int Samples { get; }

    /// <summary>Number of columns including the padding.</summary>
    public int Stride { get; }

    /// <summary>Sine of each line's latitude.</summary>
    public double[] SinLatitude { get; }

    /// <summary>Cosine of each line's latitude; negative beyond a pole.</summary>
    public double[] CosLatitude { get; }

    /// <summary>Sine of each column's longitude.</summary>
    public double[] SinLongitude { get; }

    /// <summary>Cosine of each column's longitude.</summary>
    public double[] CosLongitude { get; }

    /// <summary>Latitude of a line of the block; beyond 90 on a mirror line.</summary>
    public double LatitudeDegrees(int line) => 90.0 - ((FirstLine + line + 0.5) / PixelsPerDegree);
}
