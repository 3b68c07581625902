using Msisf.Core.Lod;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Core.Mesh.Bounds;

/// <summary>One pass over a model, line by line from the north, that gathers the bounds of its blocks.</summary>
internal sealed class SummaryScan
{
    /// <summary>
    /// Added to slopes: a cell's legs are neither quite straight nor quite at right angles (below 1 percent at 1 px/deg).
    /// </summary>
    private const double SlopeMargin = 1.02;

    private readonly IElevationGrid _grid;
    private readonly FacetMesh _mesh;
    private readonly int _subdivisions;
    private readonly int _tileCells;
    private readonly double _cellAngle;
    private readonly int _columns;
    private readonly Accumulator[] _blocks;

    public SummaryScan(IElevationGrid grid, int subdivisions)
    {
        _grid = grid;
        _mesh = new FacetMesh(grid);
        _subdivisions = subdivisions;
        _tileCells = TileId.SizeDegrees * grid.PixelsPerDegree;
        _cellAngle = Math.PI / 180.0 / grid.PixelsPerDegree;
        _columns = TileId.Columns * subdivisions;
        _blocks = new Accumulator[TileId.Rows * subdivisions * _columns];
        Array.Fill(_blocks, new Accumulator { Min = double.PositiveInfinity, Max = double.NegativeInfinity });
    }

    public BlockBounds[] Run()
    {
        // One sample more than a line has: the last cell ends at the first sample.
        double[] previous = new double[_mesh.Samples + 1];
        double[] current = new double[_mesh.Samples + 1];
        _mesh.ReadRadii(-1, 0, previous);
        AddLine(0, previous, previous, -1);
        int row = 0;
        for (int line = 0; line <= _mesh.Lines; line++)
        {
            _mesh.ReadRadii(line, 0, current);
            AddLine(row, previous, current, line);
            if (row + 1 < TileId.Rows * _subdivisions && line == Start(row + 1))
            {
                row++;
                AddLine(row, current, current, line); // the border line belongs to both rows, the step to it only to the northern one
            }

            (previous, current) = (current, previous);
            if (line % Math.Max(1, LodLevels.SparingSamplesBetweenReleases / _mesh.Samples) == 0)
            {
                _grid.ReleasePages(); // the lines above are not read again, and are much
            }
        }

        return Array.ConvertAll(_blocks, block => block.ToBounds());
    }

    private void AddLine(int row, double[] north, double[] south, int line)
    {
        double latitude = FacetMesh.Latitude(line, _mesh.Lines);
        double stepSouth = FacetMesh.Latitude(line - 1, _mesh.Lines) - latitude;
        double perMetreSouth = stepSouth > 0.0 ? 1.0 / stepSouth : 0.0;
        bool pole = line < 0 || line == _mesh.Lines;
        double perMetreEast = pole ? 0.0 : 1.0 / (Math.Cos(latitude) * _cellAngle);
        for (int column = 0; column < _columns; column++)
        {
            ref Accumulator block = ref _blocks[(row * _columns) + column];
            int end = Start(column + 1);
            double min = block.Min;
            double max = block.Max;
            double stepEast = 0.0;
            double stepNorth = 0.0;
            double radius = south[Start(column)];
            for (int sample = Start(column); sample <= end; sample++)
            {
                double west = radius;
                radius = south[sample];
                min = Math.Min(min, radius);
                max = Math.Max(max, radius);
                stepEast = Math.Max(stepEast, Math.Abs(radius - west));
                stepNorth = Math.Max(stepNorth, Math.Abs(radius - north[sample]));
            }

            block.Min = min;
            block.Max = max;
            // Rounding to the lattice tilts a facet too, most where the samples of a polar line lie close together.
            block.East = Math.Max(block.East, (stepEast + (2.0 * Tolerances.VertexLattice)) * perMetreEast / min);
            block.North = Math.Max(block.North, (stepNorth + (2.0 * Tolerances.VertexLattice)) * perMetreSouth / min);
        }
    }

    private int Start(int block) => (block / _subdivisions * _tileCells) + (block % _subdivisions * _tileCells / _subdivisions);

    private struct Accumulator
    {
        public double Min;
        public double Max;
        public double East;
        public double North;

        public readonly BlockBounds ToBounds() => new(
            MathF.BitDecrement((float)Min),
            MathF.BitIncrement((float)Max),
            MathF.BitIncrement((float)(SlopeMargin * double.Hypot(East, North))));
    }
}
