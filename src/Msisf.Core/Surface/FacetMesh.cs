using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>
/// The surface of a model, with a vertex on every sample. Cell (i, j) joins the samples (i, j) and (i + 1, j + 1) by the facets
/// (NW, SW, SE) and (NW, SE, NE). The mesh of a whole Moon is the closed surface that the pattern files draw (docs/pattern-format.md), with
/// a vertex on each pole: line -1 is the north pole and line 180 res the south pole, so the fans that close the poles are cells too. The
/// mesh of a map of a part of the Moon ends with the map's first and last samples. Safe for several threads.
/// </summary>
internal sealed class FacetMesh
{
    private readonly bool _isRing;
    private readonly Lazy<double> _northPoleRadius;
    private readonly Lazy<double> _southPoleRadius;

    /// <summary>Makes the mesh of a model; nothing of the model is read yet.</summary>
    public FacetMesh(ITerrainGrid grid)
    {
        Grid = grid;
        Lines = grid.Lines;
        Samples = grid.Samples;
        IsClosed = grid.IsWholeBody;
        GridWindow window = grid.Window;
        _isRing = grid.Projection is Equirectangular && window.Samples == Samples;
        Cells = IsClosed
            ? new CellRange(-1, Lines, 0, Samples)
            : new CellRange(window.FirstLine, window.EndLine - 1, window.FirstSample, _isRing ? window.EndSample : window.EndSample - 1);
        _northPoleRadius = new Lazy<double>(() => MeanRadius(grid, 0));
        _southPoleRadius = new Lazy<double>(() => MeanRadius(grid, Lines - 1));
    }

    /// <summary>The model.</summary>
    public ITerrainGrid Grid { get; }

    /// <summary>Whether the mesh goes around the whole Moon, so that no ray enters the ground without meeting a facet.</summary>
    public bool IsClosed { get; }

    public CellRange Cells { get; }

    /// <summary>Number of samples after which the same place comes again; 0 if none does.</summary>
    public int SamplesOfTurn => Grid.Projection is Equirectangular ? Samples : 0;

    /// <summary>Line of the cells of the southern fan; a number that no line has if the mesh has no fans.</summary>
    public int SouthFanLine => IsClosed ? Lines - 1 : int.MaxValue;

    /// <summary>Number of lines of samples; vertex lines of a closed mesh go from -1 to this number.</summary>
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

    /// <summary>Line and sample of a direction on a map, px from the centre of the first pixel; null outside its cells.</summary>
    /// <param name="directionBodyFixed">MOON_ME, of any length above 0.</param>
    public (double Line, double Sample)? PlaceOf(Vector3D directionBodyFixed)
    {
        (double line, double sample) = Grid.Projection.PixelOf(directionBodyFixed);
        sample += sample < Cells.FirstSample ? SamplesOfTurn : 0;
        return line >= Cells.FirstLine && line <= Cells.EndLine && sample >= Cells.FirstSample && sample <= Cells.EndSample
            ? (line, sample)
            : null;
    }

    /// <summary>Radii of consecutive vertices of a line, m.</summary>
    /// <param name="line">-1 (north pole) to <see cref="Lines"/> (south pole); of an open mesh a line of samples.</param>
    /// <param name="firstSample">
    /// First sample; of a closed mesh any whole number, and the samples continue across the prime meridian.
    /// </param>
    /// <param name="radii">Receives the radii.</param>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        if (!IsClosed && !_isRing)
        {
            Grid.ReadRadii(line, firstSample, radii);
            return;
        }

        if (IsClosed && (line < 0 || line >= Lines))
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

    /// <summary>Tells the model that the vertices of some cells are read next (<see cref="ITerrainGrid.Prefetch"/>).</summary>
    public void Prefetch(CellRange cells)
    {
        int firstLine = Math.Max(cells.FirstLine, 0);
        int endLine = Math.Min(cells.EndLine + 1, Lines);
        int firstSample = IsClosed || _isRing ? ((cells.FirstSample % Samples) + Samples) % Samples : cells.FirstSample;
        Grid.Prefetch(firstLine, endLine - firstLine, firstSample, Math.Min(cells.Samples + 1, Samples));
    }

    /// <summary>The sample to the right of one that has a cell; a map across the prime meridian counts on there.</summary>
    public int Next(int sample) => sample + 1 == Samples && Cells.EndSample <= Samples ? 0 : sample + 1;

    /// <summary>The samples to the left and to the right of one, or itself where a map ends.</summary>
    public (int West, int East) NeighboursOf(int sample) => _isRing
        ? (sample == 0 ? Samples - 1 : sample - 1, sample + 1)
        : (Math.Max(sample - 1, Cells.FirstSample), Math.Min(sample + 1, Cells.EndSample));

    /// <summary>
    /// Radius of the pole vertex, m: the sum of the line's radii from west to east, with one rounding per addition, divided by their
    /// number.
    /// </summary>
    /// <param name="grid">The model.</param>
    /// <param name="line">The first or the last line.</param>
    private static double MeanRadius(ITerrainGrid grid, int line)
    {
        double[] radii = new double[grid.Samples];
        grid.ReadRadii(line, 0, radii);
        double sum = 0.0;
        foreach (double radius in radii)
        {
            sum += radius;
        }

        return sum / radii.Length;
    }
}
