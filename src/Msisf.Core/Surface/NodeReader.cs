using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface;

/// <summary>Computes the bounds of nodes by reading the vertices of their cells. Safe for several threads.</summary>
internal sealed class NodeReader
{
    /// <summary>
    /// Factor on computed slopes: a cell's legs are neither exactly straight nor exactly at right angles, which changes a slope by less
    /// than 1 percent at 1 px/deg.
    /// </summary>
    private const double SlopeMargin = 1.02;

    /// <summary>Lines, and samples of a line, of a node from which on known bounds are worth more than exact ones.</summary>
    private const int LeastKnown = 64;

    /// <summary>Maximum number of vertices of a line for which the buffer is on the stack.</summary>
    private const int StackSamples = 64;

    private readonly FacetMesh _mesh;
    private readonly PlaneNodes? _plane;
    private readonly (double East, double North)[] _perRadian = [];
    private readonly int _firstLine;

    /// <summary>Takes the model.</summary>
    /// <param name="plane">The geometry of a polar stereographic mesh; null for one of latitude and longitude.</param>
    public NodeReader(FacetMesh mesh, PlaneNodes? plane)
    {
        _mesh = mesh;
        _plane = plane;
        if (plane is not null)
        {
            return;
        }

        _firstLine = mesh.Cells.FirstLine;
        _perRadian = new (double, double)[mesh.Cells.Lines + 1];
        double cellAngle = 2.0 * Math.PI / mesh.Samples;
        for (int line = _firstLine; line <= mesh.Cells.EndLine; line++)
        {
            double latitude = FacetMesh.Latitude(line, mesh.Lines);
            double stepNorth = FacetMesh.Latitude(line - 1, mesh.Lines) - latitude;
            bool isPole = line < 0 || line == mesh.Lines;
            _perRadian[line - _firstLine] =
                (isPole ? 0.0 : 1.0 / (Math.Cos(latitude) * cellAngle), stepNorth > 0.0 ? 1.0 / stepNorth : 0.0);
        }
    }

    /// <summary>Reads the bounds of one node.</summary>
    /// <exception cref="BadInputException">The model has a radius there outside the range of the Moon's surface.</exception>
    public NodeBounds Read(CellRange cells)
    {
        Extremes found = Extremes.None;
        Read(cells, ref found);
        double reference = _mesh.Grid.ReferenceRadius;
        if (!(Math.Max(reference - found.Min, found.Max - reference) <= MoonConstants.MaxReliefOver(reference)))
        {
            throw new BadInputException(Invariant(
                $"{_mesh.Grid.ProductId} has radii from {found.Min:R} to {found.Max:R} m around line {cells.FirstLine + 2}, "
                    + $"sample {cells.FirstSample + 1}; a surface within "
                    + $"{MoonConstants.MaxReliefOver(reference):R} m of {reference:R} m is needed. Check the model and its label."));
        }

        return found.ToBounds();
    }

    /// <summary>The bounds of a node as far as the model knows them without being read; null if it knows none, or none worth it.</summary>
    public NodeBounds? Known(CellRange cells)
    {
        if (_mesh.IsClosed || Math.Min(cells.Lines, cells.Samples) < LeastKnown
            || _mesh.Grid.BoundsOf(cells.FirstLine, cells.Lines + 1, cells.FirstSample, cells.Samples + 1) is not { } known)
        {
            return null;
        }

        // The steps are the same everywhere; the angles between vertices are least in the first or the last line of a node, or of a map.
        (double east, double north) = (0.0, 0.0);
        foreach (int line in (int[])[cells.FirstLine, cells.EndLine])
        {
            (double perRadianEast, double perRadianNorth) = _plane is null ? _perRadian[line - _firstLine] : default;
            if (_plane is not null)
            {
                perRadianEast = perRadianNorth = _plane.PerRadian(line, cells.FirstSample, cells.EndSample);
            }

            (east, north) = (Math.Max(east, perRadianEast), Math.Max(north, perRadianNorth));
        }

        double step = (known.Step + (2.0 * Tolerances.VertexLattice)) / known.Min;
        return new NodeBounds(
            MathF.BitDecrement((float)known.Min),
            MathF.BitIncrement((float)known.Max),
            MathF.BitIncrement((float)(SlopeMargin * double.Hypot(step * east, step * north))));
    }

    private void Read(CellRange cells, ref Extremes found)
    {
        int samples = cells.Samples + 1;
        Span<double> radii = samples <= StackSamples ? stackalloc double[2 * StackSamples] : new double[2 * samples];
        Span<double> north = radii[..samples];
        Span<double> south = radii.Slice(samples, samples);
        _mesh.ReadRadii(cells.FirstLine, cells.FirstSample, north);
        AddLine(cells, cells.FirstLine, ref found, north, north);
        for (int line = cells.FirstLine + 1; line <= cells.EndLine; line++)
        {
            _mesh.ReadRadii(line, cells.FirstSample, south);
            AddLine(cells, line, ref found, north, south);
            Span<double> read = south;
            south = north;
            north = read;
        }
    }

    private void AddLine(CellRange cells, int line, ref Extremes found, ReadOnlySpan<double> north, ReadOnlySpan<double> south)
    {
        (double perRadianEast, double perRadianNorth) = _plane is null ? _perRadian[line - _firstLine] : default;
        if (_plane is not null)
        {
            perRadianEast = perRadianNorth = _plane.PerRadian(line, cells.FirstSample, cells.EndSample);
        }

        found.Add(north, south, perRadianEast, perRadianNorth);
    }

    /// <summary>The bounds of a node over the lines that have been read so far.</summary>
    private struct Extremes
    {
        public double Min;
        public double Max;
        private double _eastSlope;
        private double _northSlope;

        public static Extremes None => new() { Min = double.PositiveInfinity, Max = double.NegativeInfinity };

        /// <summary>Adds a line of vertices; for the northernmost line <paramref name="north"/> is the line itself.</summary>
        public void Add(ReadOnlySpan<double> north, ReadOnlySpan<double> south, double perRadianEast, double perRadianNorth)
        {
            double stepEast = 0.0;
            double stepNorth = Math.Abs(south[0] - north[0]);
            Min = Math.Min(Min, south[0]);
            Max = Math.Max(Max, south[0]);
            if (south.Length > Vector512<double>.Count)
            {
                AddWide(north, south, ref stepEast, ref stepNorth);
            }
            else
            {
                for (int i = 1; i < south.Length; i++)
                {
                    Min = Math.Min(Min, south[i]);
                    Max = Math.Max(Max, south[i]);
                    stepEast = Math.Max(stepEast, Math.Abs(south[i] - south[i - 1]));
                    stepNorth = Math.Max(stepNorth, Math.Abs(south[i] - north[i]));
                }
            }

            // Rounding to the lattice also tilts a facet, most where the samples of a polar line are close together.
            _eastSlope = Math.Max(_eastSlope, (stepEast + (2.0 * Tolerances.VertexLattice)) * perRadianEast / Min);
            _northSlope = Math.Max(_northSlope, (stepNorth + (2.0 * Tolerances.VertexLattice)) * perRadianNorth / Min);
        }

        public readonly NodeBounds ToBounds() => new(
            MathF.BitDecrement((float)Min),
            MathF.BitIncrement((float)Max),
            MathF.BitIncrement((float)(SlopeMargin * double.Hypot(_eastSlope, _northSlope))));

        /// <summary>
        /// Adds all vertices of a line except the first; the line must have at least as many of them as a vector has lanes.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise read with unoptimised vectors
        private void AddWide(ReadOnlySpan<double> north, ReadOnlySpan<double> south, ref double stepEast, ref double stepNorth)
        {
            Vector512<double> min = Vector512.Create(Min);
            Vector512<double> max = Vector512.Create(Max);
            Vector512<double> east = Vector512<double>.Zero;
            Vector512<double> down = Vector512.Create(stepNorth);
            for (int i = 1; i < south.Length; i += Vector512<double>.Count)
            {
                // The last vector begins early enough to end with the line; the vertices that it repeats do not change the bounds.
                int at = Math.Min(i, south.Length - Vector512<double>.Count);
                Vector512<double> radius = ArrayLanes.Load(south, at);
                min = Vector512.Min(min, radius);
                max = Vector512.Max(max, radius);
                east = Vector512.Max(east, Vector512.Abs(radius - ArrayLanes.Load(south, at - 1)));
                down = Vector512.Max(down, Vector512.Abs(radius - ArrayLanes.Load(north, at)));
            }

            Min = -MaxOf(-min);
            Max = MaxOf(max);
            stepEast = MaxOf(east);
            stepNorth = MaxOf(down);
        }

        private static double MaxOf(Vector512<double> values)
        {
            Vector256<double> four = Vector256.Max(values.GetLower(), values.GetUpper());
            Vector128<double> two = Vector128.Max(four.GetLower(), four.GetUpper());
            return Math.Max(two[0], two[1]);
        }
    }
}
