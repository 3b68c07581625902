using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tiles;

/// <summary>Makes the tiles' meshes from an elevation grid; safe for several threads.</summary>
/// <remarks>
/// Each vertex depends on its sample alone, so the shared vertices of neighbouring tiles have the same bits. All steps are in
/// docs/pattern-format.md.
/// </remarks>
public sealed class TileMeshBuilder
{
    private readonly FacetMesh _mesh;
    private readonly GridDirections _directions;

    /// <summary>Prepares the directions of the grid's samples.</summary>
    /// <param name="grid">The whole Moon.</param>
    public TileMeshBuilder(IGlobalGrid grid)
    {
        _mesh = new FacetMesh(grid);
        _directions = new GridDirections(grid.PixelsPerDegree);
    }

    /// <summary>The radius of each vertex, in vertex order.</summary>
    /// <param name="layout">Layout at the grid's resolution.</param>
    /// <returns>m.</returns>
    /// <exception cref="BadInputException">The grid can't give a sample, or gives one that is not a radius of the Moon.</exception>
    public double[] ReadRadii(TileMeshLayout layout)
    {
        double[] radii = new double[layout.VertexCount];
        _mesh.Prefetch(new CellRange(
            layout.FirstLine, layout.FirstLine + layout.Lines - 1, layout.FirstSample, layout.FirstSample + layout.Samples - 1));
        int firstRow = layout.HasNorthPole ? 1 : 0;
        for (int row = 0; row < layout.Lines; row++)
        {
            Span<double> line = radii.AsSpan(firstRow + (row * layout.Samples), layout.Samples);
            _mesh.ReadRadii(layout.FirstLine + row, layout.FirstSample, line);
        }

        if (layout.HasNorthPole)
        {
            radii[0] = _mesh.NorthPoleRadius;
        }

        if (layout.HasSouthPole)
        {
            radii[^1] = _mesh.SouthPoleRadius;
        }

        return radii;
    }

    /// <summary>The mesh of a tile.</summary>
    /// <param name="layout">Layout at the grid's resolution.</param>
    /// <param name="radii">The radii from <see cref="ReadRadii"/> for this layout.</param>
    /// <exception cref="BadInputException">
    /// A radius is too far from the reference radius for the mesh's lattice (more than about 20 km).
    /// </exception>
    public TileMesh Build(TileMeshLayout layout, double[] radii)
    {
        int[] offsets = new int[3 * radii.Length];
        LatticePoint origin = TileMesh.OriginOf(layout.Tile);
        SineCosine[] longitudes = new SineCosine[layout.Samples];
        for (int column = 0; column < layout.Samples; column++)
        {
            longitudes[column] = _directions.Longitude(SampleOf(layout, column));
        }

        for (int vertex = 0; vertex < radii.Length; vertex++)
        {
            Place(offsets, vertex, layout, radii[vertex], origin, DirectionOf(layout, vertex, longitudes));
        }

        return new TileMesh(layout, radii, offsets, layout.CreateFaces());
    }

    private (SineCosine Latitude, SineCosine Longitude) DirectionOf(TileMeshLayout layout, int vertex, SineCosine[] longitudes)
    {
        int firstRow = layout.HasNorthPole ? 1 : 0;
        (int row, int column) = vertex < firstRow ? (-1, 0) : int.DivRem(vertex - firstRow, layout.Samples);
        return (_directions.Latitude(layout.FirstLine + row), longitudes[column]);
    }

    private static void Place(
        int[] offsets, int vertex, TileMeshLayout layout, double radius, LatticePoint origin,
        (SineCosine Latitude, SineCosine Longitude) direction)
    {
        if (!(radius > 0.0 && radius < LatticePoint.RadiusLimit))
        {
            throw OutOfReach(layout, vertex, radius);
        }

        LatticePoint point = LatticePoint.Nearest(radius, direction.Latitude, direction.Longitude);
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
        return new BadInputException(Invariant(
            $"The elevation model has the radius {radius:R} m at line {line + 1}, sample {sample + 1}; "
                + $"a surface within about 20 km of {MoonConstants.ReferenceRadius:R} m is needed. Check the model and its label."));
    }

    private static int SampleOf(TileMeshLayout layout, int column) => (layout.FirstSample + column) % (360 * layout.PixelsPerDegree);
}
