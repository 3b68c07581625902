using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Mesh.Bounds;

/// <summary>Bounds of the facets of each block; a block is read when it is first asked for. Safe for several threads.</summary>
internal sealed class BlockBoundsTable
{
    /// <summary>
    /// Added to slopes: a cell's legs are neither quite straight nor quite at right angles (below 1 percent at 1 px/deg).
    /// </summary>
    private const double SlopeMargin = 1.02;

    private readonly SurfaceModel _surface;
    private readonly RowOfBlocks?[] _rows;

    public BlockBoundsTable(SurfaceModel surface)
    {
        _surface = surface;
        Columns = CellBlock.ColumnsOf(surface.Mesh);
        _rows = new RowOfBlocks?[CellBlock.RowsOf(surface.Mesh)];
    }

    /// <summary>Rows of blocks.</summary>
    public int Rows => _rows.Length;

    /// <summary>Blocks a row.</summary>
    public int Columns { get; }

    /// <summary>
    /// Minimum and maximum vertex radius (m, not widened by the lattice) and tangent of the steepest facet's slope; rounded outwards.
    /// </summary>
    public BlockBounds Of(CellBlock block)
    {
        RowOfBlocks row = Volatile.Read(ref _rows[block.Row]) ?? NewRow(block.Row);
        if (!Volatile.Read(ref row.IsKnown[block.Column]))
        {
            row.Bounds[block.Column] = Find(block); // two threads may both find it: they find the same
            Volatile.Write(ref row.IsKnown[block.Column], true);
        }

        return row.Bounds[block.Column];
    }

    private RowOfBlocks NewRow(int row)
    {
        RowOfBlocks made = new(Columns);
        return Interlocked.CompareExchange(ref _rows[row], made, null) ?? made;
    }

    private BlockBounds Find(CellBlock block)
    {
        CellRange cells = block.Cells(_surface.Mesh);
        int samples = cells.EndSample - cells.FirstSample + 1;
        Span<double> north = stackalloc double[samples];
        Span<double> line = stackalloc double[samples];
        double min = double.PositiveInfinity;
        double max = double.NegativeInfinity;
        double east = 0.0;
        double south = 0.0;
        double cellAngle = 2.0 * Math.PI / _surface.Mesh.Samples;
        for (int i = cells.FirstLine; i <= cells.EndLine; i++)
        {
            _surface.Mesh.ReadRadii(i, cells.FirstSample, line);
            double stepEast = 0.0;
            double stepSouth = 0.0;
            double west = line[0];
            for (int j = 0; j < samples; j++)
            {
                double radius = line[j];
                min = Math.Min(min, radius);
                max = Math.Max(max, radius);
                stepEast = Math.Max(stepEast, Math.Abs(radius - west));
                stepSouth = Math.Max(stepSouth, Math.Abs(radius - north[j]));
                west = radius;
            }

            bool isPole = i < 0 || i == _surface.Mesh.Lines;
            east = isPole ? east : Math.Max(east, Slope(stepEast, cellAngle * _surface.Latitude(i).Cosine, min));
            if (i > cells.FirstLine)
            {
                // The step to a pole is half a cell long.
                bool isHalf = i == 0 || i == _surface.Mesh.Lines;
                south = Math.Max(south, Slope(stepSouth, isHalf ? 0.5 * cellAngle : cellAngle, min));
            }

            line.CopyTo(north);
        }

        if (!(Math.Max(MoonConstants.ReferenceRadius - min, max - MoonConstants.ReferenceRadius) <= MoonConstants.MaxRelief))
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{_surface.Grid.ProductId} has radii from {min:R} to {max:R} m around line {cells.FirstLine + 2}, "
                    + $"sample {cells.FirstSample + 1}; a surface within {MoonConstants.MaxRelief:R} m of "
                    + $"{MoonConstants.ReferenceRadius:R} m is needed. Check the model and its label."));
        }

        return new BlockBounds(
            MathF.BitDecrement((float)min),
            MathF.BitIncrement((float)max),
            MathF.BitIncrement((float)(SlopeMargin * double.Hypot(east, south))));
    }

    /// <summary>Rounding to the lattice tilts a facet too, most where the samples of a polar line lie close together.</summary>
    private static double Slope(double step, double angle, double radius) =>
        (step + (2.0 * Tolerances.VertexLattice)) / (angle * radius);

    private sealed class RowOfBlocks(int columns)
    {
        public BlockBounds[] Bounds { get; } = new BlockBounds[columns];

        public bool[] IsKnown { get; } = new bool[columns];
    }
}
