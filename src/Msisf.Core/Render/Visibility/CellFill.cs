using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Fills both facets of one cell together. Each row is tested eight pixels at a time by the signs of the <see cref="CellEdges"/>.
/// </summary>
internal static class CellFill
{
    private const int Lanes = 8;

    /// <summary>Draws the facets of a cell whose corners are all projected.</summary>
    /// <param name="index">Index of the cell's north-western vertex in the block.</param>
    /// <param name="halves">Bits of <see cref="FacetCorners"/> for those of the cell's two halves that are facets.</param>
    /// <param name="band">The band into which to draw.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void Draw<TSamples>(ProjectedBlock block, int index, uint halves, Band band)
        where TSamples : struct, ISampleKind
    {
        CellCorner northWest = new(block, index);
        CellCorner northEast = new(block, index + FacetCorners.NorthEast);
        CellCorner southWest = new(block, index + FacetCorners.SouthWest);
        CellCorner southEast = new(block, index + FacetCorners.SouthEast);
        double margin = TSamples.IsPixelCentre ? 0.0 : band.Margin;
        PixelRange pixels = PixelRange.Within(
            Math.Min(Math.Min(northWest.X, northEast.X), Math.Min(southWest.X, southEast.X)) - margin,
            Math.Max(Math.Max(northWest.X, northEast.X), Math.Max(southWest.X, southEast.X)) + margin,
            Math.Min(Math.Min(northWest.Y, northEast.Y), Math.Min(southWest.Y, southEast.Y)) - margin,
            Math.Max(Math.Max(northWest.Y, northEast.Y), Math.Max(southWest.Y, southEast.Y)) + margin,
            band);
        if (pixels.IsEmpty)
        {
            return;
        }

        DepthPlane southWestPlane = new(northWest, southWest, southEast);
        DepthPlane northEastPlane = new(northWest, southEast, northEast);
        Vector512<double> min = Vector512.Create(
            Math.Min(Math.Min(northWest.InverseDepth, northEast.InverseDepth), Math.Min(southWest.InverseDepth, southEast.InverseDepth)));
        Vector512<double> max = Vector512.Create(
            Math.Max(Math.Max(northWest.InverseDepth, northEast.InverseDepth), Math.Max(southWest.InverseDepth, southEast.InverseDepth)));
        Vector512<double> southWestMask = Vector512.Create((halves & FacetCorners.SouthWestHalf) != 0 ? -1L : 0L).AsDouble();
        Vector512<double> northEastMask = Vector512.Create((halves & FacetCorners.NorthEastHalf) != 0 ? -1L : 0L).AsDouble();
        Vector512<double> lastColumn = Vector512.Create((double)pixels.LastColumn);
        CellSides sides = new(northWest, northEast, southWest, southEast);
        CellWinners winners = new();
        for (int row = pixels.FirstRow; row <= pixels.LastRow; row++)
        {
            (double first, double last) = TSamples.IsPixelCentre ? sides.At(row) : sides.Within(row, margin);
            int begin = (int)Math.Max(pixels.FirstColumn, Math.Ceiling(first));
            int end = (int)Math.Min(pixels.LastColumn, last);
            if (begin > end)
            {
                continue;
            }

            Vector512<double> downNorthWest = Vector512.Create(northWest.Y - row);
            Vector512<double> downNorthEast = Vector512.Create(northEast.Y - row);
            Vector512<double> downSouthWest = Vector512.Create(southWest.Y - row);
            Vector512<double> downSouthEast = Vector512.Create(southEast.Y - row);
            Vector512<double> southWestStart = Vector512.Create(southWestPlane.AtColumn0(row));
            Vector512<double> northEastStart = Vector512.Create(northEastPlane.AtColumn0(row));
            Debug.Assert(end < band.Width, "A row is drawn beyond its band.");
            int start = band.IndexOf(begin, row) - begin;
            ref double nearest = ref ArrayLanes.At(band.InverseDepths, start);
            ref int facets = ref ArrayLanes.At(band.Facets, start);
            for (int column = begin; column <= end; column += Lanes)
            {
                Vector512<double> columns = Vector512.Create((double)column) + Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);
                Vector512<double> samples = columns;
                if (!TSamples.IsPixelCentre)
                {
                    int sample = start + column;
                    samples = ArrayLanes.Load(band.SampleColumns, sample);
                    Vector512<double> rows = ArrayLanes.Load(band.SampleRows, sample);
                    downNorthWest = Vector512.Create(northWest.Y) - rows;
                    downNorthEast = Vector512.Create(northEast.Y) - rows;
                    downSouthWest = Vector512.Create(southWest.Y) - rows;
                    downSouthEast = Vector512.Create(southEast.Y) - rows;
                    southWestStart = southWestPlane.AtColumn0(rows);
                    northEastStart = northEastPlane.AtColumn0(rows);
                }

                Vector512<double> acrossNorthWest = Vector512.Create(northWest.X) - samples;
                Vector512<double> acrossNorthEast = Vector512.Create(northEast.X) - samples;
                Vector512<double> acrossSouthWest = Vector512.Create(southWest.X) - samples;
                Vector512<double> acrossSouthEast = Vector512.Create(southEast.X) - samples;
                CellEdges edges = new(
                    acrossNorthWest, downNorthWest, acrossNorthEast, downNorthEast, acrossSouthWest, downSouthWest, acrossSouthEast,
                    downSouthEast);
                Vector512<double> inSouthWest = southWestMask & Vector512.LessThanOrEqual(edges.MaxOfSouthWest, Vector512<double>.Zero);
                Vector512<double> inNorthEast = northEastMask & Vector512.LessThanOrEqual(edges.MaxOfNorthEast, Vector512<double>.Zero);
                Vector512<double> inverseDepth = Vector512.ConditionalSelect(
                    inSouthWest,
                    southWestStart + (Vector512.Create(southWestPlane.PerColumn) * samples),
                    northEastStart + (Vector512.Create(northEastPlane.PerColumn) * samples));
                inverseDepth = Vector512.MinNative(Vector512.MaxNative(inverseDepth, min), max);
                Vector512<double> before = Vector512.LoadUnsafe(ref nearest, (nuint)column);
                Vector512<double> wins = (inSouthWest | inNorthEast)
                    & Vector512.GreaterThan(inverseDepth, before)
                    & Vector512.LessThanOrEqual(columns, lastColumn);
                if (wins == Vector512<double>.Zero)
                {
                    continue;
                }

                Vector512.ConditionalSelect(wins, inverseDepth, before).StoreUnsafe(ref nearest, (nuint)column);
                winners.Store(band.Records, block, index, wins, inSouthWest, ref Unsafe.Add(ref facets, column));
            }
        }
    }

    /// <summary>The inverse depth of a facet's plane (1/m), which is a linear function of column and row.</summary>
    private readonly struct DepthPlane
    {
        private readonly CellCorner _a;
        private readonly double _perRow;

        public DepthPlane(CellCorner a, CellCorner b, CellCorner c)
        {
            (double bx, double by, double b1) = (b.X - a.X, b.Y - a.Y, b.InverseDepth - a.InverseDepth);
            (double cx, double cy, double c1) = (c.X - a.X, c.Y - a.Y, c.InverseDepth - a.InverseDepth);
            double area = (bx * cy) - (cx * by);
            _a = a;
            PerColumn = ((b1 * cy) - (c1 * by)) / area;
            _perRow = ((c1 * bx) - (b1 * cx)) / area;
        }

        public double PerColumn { get; }

        public double AtColumn0(double row) => _a.InverseDepth + (_perRow * (row - _a.Y)) - (PerColumn * _a.X);

        public Vector512<double> AtColumn0(Vector512<double> rows) =>
            Vector512.Create(_a.InverseDepth) + (_perRow * (rows - Vector512.Create(_a.Y))) - Vector512.Create(PerColumn * _a.X);
    }
}

/// <summary>A projected vertex.</summary>
/// <param name="X">Image column, px.</param>
/// <param name="Y">Image row, px.</param>
/// <param name="InverseDepth">1/m: inverse of its depth.</param>
internal readonly record struct CellCorner(double X, double Y, double InverseDepth)
{
    public CellCorner(ProjectedBlock block, int index)
        : this(block.X[index], block.Y[index], block.InverseDepth[index])
    {
    }
}

/// <summary>Where the samples of the pixels lie. The drawing code is compiled for each kind, so that a pinhole pays nothing.</summary>
internal interface ISampleKind
{
    /// <summary>Whether each sample is its pixel's centre; otherwise it is where the band says.</summary>
    static abstract bool IsPixelCentre { get; }
}

/// <summary>The samples of a pinhole.</summary>
internal readonly struct PixelCentres : ISampleKind
{
    public static bool IsPixelCentre => true;
}

/// <summary>The samples of a lens, at <see cref="Band.SampleColumns"/> and <see cref="Band.SampleRows"/>.</summary>
internal readonly struct AnySamples : ISampleKind
{
    public static bool IsPixelCentre => false;
}
