using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Mesh;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>Makes the tiles' meshes from an elevation grid; safe for several threads.</summary>
/// <remarks>Each vertex depends on its sample alone, so tiles meet bit for bit. All steps are in docs/pattern-format.md.</remarks>
public sealed class TileMeshBuilder
{
    private static readonly SineCosine NorthPole = SineCosine.OfDegrees(90, 1);
    private static readonly SineCosine SouthPole = SineCosine.OfDegrees(-90, 1);
    private static readonly SineCosine ZeroDegrees = SineCosine.OfDegrees(0, 1);

    private readonly IElevationGrid _grid;
    private readonly GridDirections _directions;
    private readonly Lazy<double> _northPoleRadius;
    private readonly Lazy<double> _southPoleRadius;

    /// <summary>Prepares the directions of the grid's samples.</summary>
    /// <param name="grid">The whole Moon.</param>
    public TileMeshBuilder(IElevationGrid grid)
    {
        _grid = grid;
        _directions = new GridDirections(grid.PixelsPerDegree);
        _northPoleRadius = new Lazy<double>(() => FacetMesh.MeanRadius(grid, 0));
        _southPoleRadius = new Lazy<double>(() => FacetMesh.MeanRadius(grid, (180 * grid.PixelsPerDegree) - 1));
    }

    /// <summary>m: the radius at which the skirts of parts end (<see cref="TileMeshLayout.HasSkirt"/>), below all ground.</summary>
    public double SkirtFootRadius => _grid.RadiusLimits.Min - Skirt.DepthBelowLowest;

    /// <summary>The radius of each vertex, in vertex order, without those of the skirt's foot.</summary>
    /// <param name="layout">Layout at the grid's resolution.</param>
    /// <returns>m.</returns>
    /// <exception cref="BadInputException">The grid can't give a sample, or gives one that is no radius of the Moon.</exception>
    public double[] ReadRadii(TileMeshLayout layout)
    {
        double[] radii = new double[layout.VertexCount];
        int firstRow = layout.HasNorthPole ? 1 : 0;
        for (int row = 0; row < layout.Lines; row++)
        {
            Span<double> line = radii.AsSpan(firstRow + (row * layout.Samples), layout.Samples);
            _grid.ReadRadii(layout.FirstLine + row, layout.FirstSample, line);
        }

        if (layout.HasNorthPole)
        {
            radii[0] = _northPoleRadius.Value;
        }

        if (layout.HasSouthPole)
        {
            radii[^1] = _southPoleRadius.Value;
        }

        return radii;
    }

    /// <summary>The mesh of a tile or part.</summary>
    /// <param name="layout">Layout at the grid's resolution.</param>
    /// <param name="radii">What <see cref="ReadRadii"/> gave for it.</param>
    /// <exception cref="BadInputException">A radius is too far from the reference radius for the mesh's lattice (more than about 20 km).</exception>
    public TileMesh Build(TileMeshLayout layout, double[] radii)
    {
        int[] border = layout.HasSkirt ? Skirt.Border(layout) : [];
        int[] offsets = new int[3 * (radii.Length + border.Length)];
        LatticePoint origin = TileMesh.OriginOf(layout.Part);
        SineCosine[] longitudes = new SineCosine[layout.Samples];
        for (int column = 0; column < layout.Samples; column++)
        {
            longitudes[column] = _directions.Longitude(SampleOf(layout, column));
        }

        int vertex = 0;
        if (layout.HasNorthPole)
        {
            Place(offsets, vertex, layout, radii[vertex], origin, NorthPole, ZeroDegrees);
            vertex++;
        }

        for (int row = 0; row < layout.Lines; row++)
        {
            SineCosine latitude = _directions.Latitude(layout.FirstLine + row);
            for (int column = 0; column < layout.Samples; column++)
            {
                Place(offsets, vertex, layout, radii[vertex], origin, latitude, longitudes[column]);
                vertex++;
            }
        }

        if (layout.HasSouthPole)
        {
            Place(offsets, vertex, layout, radii[vertex], origin, SouthPole, ZeroDegrees);
            vertex++;
        }

        foreach (int top in border)
        {
            (SineCosine latitude, SineCosine longitude) = DirectionOf(layout, top, longitudes);
            Place(offsets, vertex++, layout, SkirtFootRadius, origin, latitude, longitude);
        }

        return new TileMesh(layout, radii, offsets, [.. layout.CreateFaces(), .. Skirt.Faces(border, radii.Length)], SkirtFootRadius);
    }

    private (SineCosine Latitude, SineCosine Longitude) DirectionOf(TileMeshLayout layout, int vertex, SineCosine[] longitudes)
    {
        int firstRow = layout.HasNorthPole ? 1 : 0;
        if (vertex < firstRow)
        {
            return (NorthPole, ZeroDegrees);
        }

        (int row, int column) = int.DivRem(vertex - firstRow, layout.Samples);
        return row == layout.Lines ? (SouthPole, ZeroDegrees) : (_directions.Latitude(layout.FirstLine + row), longitudes[column]);
    }

    private static void Place(
        int[] offsets, int vertex, TileMeshLayout layout, double radius, LatticePoint origin, SineCosine latitude, SineCosine longitude)
    {
        if (!(radius > 0.0 && radius < LatticePoint.RadiusLimit))
        {
            throw OutOfReach(layout, vertex, radius);
        }

        LatticePoint point = LatticePoint.Nearest(radius, latitude, longitude);
        int x = point.X - origin.X;
        int y = point.Y - origin.Y;
        int z = point.Z - origin.Z;
        if (int.Abs(x) >= TileMesh.OffsetLimit || int.Abs(y) >= TileMesh.OffsetLimit || int.Abs(z) >= TileMesh.OffsetLimit)
        {
            throw OutOfReach(layout, vertex, radius);
        }

        offsets[3 * vertex] = x;
        offsets[(3 * vertex) + 1] = y;
        offsets[(3 * vertex) + 2] = z;
    }

    private static BadInputException OutOfReach(TileMeshLayout layout, int vertex, double radius)
    {
        int sampleVertex = Math.Max(vertex - (layout.HasNorthPole ? 1 : 0), 0);
        int line = Math.Min(layout.FirstLine + (sampleVertex / layout.Samples), (180 * layout.PixelsPerDegree) - 1);
        int sample = SampleOf(layout, sampleVertex % layout.Samples);
        return new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"The elevation model has the radius {radius:R} m at line {line + 1}, sample {sample + 1}; a surface within about 20 km of {MoonConstants.ReferenceRadius:R} m is needed. Check the model and its label."));
    }

    private static int SampleOf(TileMeshLayout layout, int column) => (layout.FirstSample + column) % (360 * layout.PixelsPerDegree);
}
