namespace Msisf.Core.Maps;

/// <summary>The cells of a map, line by line from the top. Immutable.</summary>
/// <param name="Lines">Number of lines.</param>
/// <param name="Samples">Cells of a line.</param>
/// <param name="Left">X of the left edge, in units of the map.</param>
/// <param name="Top">Y of the upper edge.</param>
/// <param name="CellWidth">Along X, in units of the map.</param>
/// <param name="CellHeight">Along Y.</param>
public sealed record MapGrid(
    GroundProjection Projection, int Lines, int Samples, double Left, double Top, double CellWidth, double CellHeight)
{
    /// <summary>Part of a cell on both sides of its middle between which its size is measured; the map is as good as even there.</summary>
    private const double Step = 0.25;

    /// <summary>Number of cells.</summary>
    public int Count => Lines * Samples;

    /// <summary>Direction of a cell's middle, body-fixed, length 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The map does not reach there.</exception>
    public Vector3D DirectionOf(int line, int sample) => At(line, sample);

    /// <summary>Directions of the cells of some lines, line by line.</summary>
    public Vector3D[] DirectionsOf(int firstLine, int endLine)
    {
        Vector3D[] directions = new Vector3D[(endLine - firstLine) * Samples];
        for (int i = 0; i < directions.Length; i++)
        {
            directions[i] = DirectionOf(firstLine + (i / Samples), i % Samples);
        }

        return directions;
    }

    /// <summary>Directions of cells spread over the map, those of its corners among them.</summary>
    public IEnumerable<Vector3D> Spread()
    {
        const int Side = 8;
        for (int i = 0; i < (Side + 1) * (Side + 1); i++)
        {
            yield return DirectionOf(
                (int)((Lines - 1) * (i / (Side + 1) / (double)Side)), (int)((Samples - 1) * (i % (Side + 1) / (double)Side)));
        }
    }

    /// <summary>m: width and height of a cell on the sphere.</summary>
    public (double Width, double Height) SizeOf(int line, int sample)
    {
        (Vector3D across, Vector3D up) = SidesOf(line, sample);
        return (across.Length, up.Length);
    }

    /// <summary>m^2: area of a cell on the sphere.</summary>
    public double AreaOf(int line, int sample)
    {
        (Vector3D across, Vector3D up) = SidesOf(line, sample);
        return Vector3D.Cross(across, up).Length;
    }

    private (Vector3D Across, Vector3D Up) SidesOf(int line, int sample)
    {
        double scale = Projection.Radius / (2.0 * Step);
        return (
            scale * (At(line, sample + Step) - At(line, sample - Step)), scale * (At(line - Step, sample) - At(line + Step, sample)));
    }

    private Vector3D At(double line, double sample) =>
        Projection.ToDirection(Left + ((sample + 0.5) * CellWidth), Top - ((line + 0.5) * CellHeight))
        ?? throw new ArgumentOutOfRangeException(nameof(line), Invariant($"{Projection.Kind} does not reach {line:R}, {sample:R}."));
}
