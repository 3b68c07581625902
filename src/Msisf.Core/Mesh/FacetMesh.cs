using Msisf.Core.Terrain;

namespace Msisf.Core.Mesh;

/// <summary>
/// The closed surface that the pattern files draw (docs/pattern-format.md), with a vertex on every sample and one on each pole. Cell (i, j)
/// joins the samples (i, j) and (i + 1, j + 1) by the facets (NW, SW, SE) and (NW, SE, NE). Line -1 is the north pole and line 180 res the
/// south pole, so the fans that close the poles are cells too. Safe for several threads.
/// </summary>
internal sealed class FacetMesh
{
    private readonly Lazy<double> _northPoleRadius;
    private readonly Lazy<double> _southPoleRadius;

    /// <summary>Makes the mesh of a model; nothing of the model is read yet.</summary>
    public FacetMesh(IElevationGrid grid)
    {
        Grid = grid;
        Lines = 180 * grid.PixelsPerDegree;
        Samples = 360 * grid.PixelsPerDegree;
        _northPoleRadius = new Lazy<double>(() => MeanRadius(grid, 0));
        _southPoleRadius = new Lazy<double>(() => MeanRadius(grid, Lines - 1));
    }

    /// <summary>The model.</summary>
    public IElevationGrid Grid { get; }

    /// <summary>Number of lines of samples; vertex lines go from -1 to this number.</summary>
    public int Lines { get; }

    /// <summary>Number of samples per line.</summary>
    public int Samples { get; }

    /// <summary>m: mean radius of the first line, which is read at the first request.</summary>
    public double NorthPoleRadius => _northPoleRadius.Value;

    /// <summary>m: mean radius of the last line, which is read at the first request.</summary>
    public double SouthPoleRadius => _southPoleRadius.Value;

    /// <summary>Latitude of a vertex line, rad; the poles for -1 and <paramref name="lines"/>.</summary>
    public static double Latitude(int line, int lines) =>
        (0.5 - Math.Clamp((line + 0.5) / lines, 0.0, 1.0)) * Math.PI;

    /// <summary>Longitude of a sample, rad; not wrapped.</summary>
    public static double Longitude(double sample, int samples) => (sample + 0.5) * 2.0 * Math.PI / samples;

    /// <summary>Radii of consecutive vertices of a line, m.</summary>
    /// <param name="line">-1 (north pole) to <see cref="Lines"/> (south pole).</param>
    /// <param name="firstSample">First sample, any whole number; the samples continue across the prime meridian.</param>
    /// <param name="radii">Receives the radii.</param>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        if (line < 0 || line >= Lines)
        {
            radii.Fill(line < 0 ? NorthPoleRadius : SouthPoleRadius);
            return;
        }

        int first = ((firstSample % Samples) + Samples) % Samples;
        int most = Math.Min(radii.Length, Samples);
        Grid.ReadRadii(line, first, radii[..most]);
        if (radii.Length > most)
        {
            radii[..(radii.Length - most)].CopyTo(radii[most..]); // a closed ring: its first vertices come again
        }
    }

    /// <summary>
    /// Radius of the pole vertex, m: the sum of the line's radii from west to east, with one rounding per addition, divided by their
    /// number.
    /// </summary>
    /// <param name="grid">The model.</param>
    /// <param name="line">The first or the last line.</param>
    private static double MeanRadius(IElevationGrid grid, int line)
    {
        double[] radii = new double[360 * grid.PixelsPerDegree];
        grid.ReadRadii(line, 0, radii);
        double sum = 0.0;
        foreach (double radius in radii)
        {
            sum += radius;
        }

        return sum / radii.Length;
    }
}
