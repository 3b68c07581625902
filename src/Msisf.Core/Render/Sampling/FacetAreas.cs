using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Finds the mean brightness of pixels in which facets larger than pixels meet, from what the pixels' centres show: the edge of two facets
/// is the line in which their planes meet, so it is known which part of a pixel lies beyond it. Each thread needs its own object.
/// </summary>
internal sealed class FacetAreas
{
    private const int Lanes = 8;

    private FacetRow _above = new();
    private FacetRow _here = new();
    private FacetRow _below = new();
    private FacetsAround[] _kinds = [];
    private double[] _means = [];

    /// <summary>What the neighbours of the last row's pixels show.</summary>
    public ReadOnlySpan<FacetsAround> Kinds => _kinds;

    /// <summary>
    /// The mean I/F of the last row's pixels; the centre's where <see cref="Kinds"/> is <see cref="FacetsAround.Other"/>.
    /// </summary>
    public ReadOnlySpan<double> Means => _means;

    /// <summary>Looks at a row; the rows of a band from top to bottom.</summary>
    /// <param name="visible">What the pixels' centres show.</param>
    /// <param name="row">The row, from 0.</param>
    /// <param name="isFirst">Whether it is the first one of a band.</param>
    /// <param name="contrasts">Contrast around each pixel of the row, levels of 255.</param>
    /// <param name="minContrast">With less contrast a pixel's mean is its centre's brightness.</param>
    /// <param name="factors">I/F of the centres of all pixels of the image.</param>
    public void Look(
        VisibleSurface visible, int row, bool isFirst, ReadOnlySpan<byte> contrasts, int minContrast, ReadOnlySpan<double> factors)
    {
        int width = visible.Width;
        if (_kinds.Length < width + Lanes)
        {
            (_kinds, _means) = (new FacetsAround[width + Lanes], new double[width + Lanes]);
        }

        if (isFirst)
        {
            Read(visible, row - 1, factors, _above);
            Read(visible, row, factors, _here);
        }
        else
        {
            (_above, _here, _below) = (_here, _below, _above);
        }

        Read(visible, row + 1, factors, _below);
        _here.Factors.AsSpan(1, width).CopyTo(_means);
        _kinds.AsSpan(0, width).Fill(FacetsAround.OneLine);
        for (int i = 0; i < width; i += Lanes)
        {
            uint wanted = 0;
            for (int lane = 0; lane < Math.Min(Lanes, width - i); lane++)
            {
                wanted |= contrasts[i + lane] >= minContrast ? 1u << lane : 0;
            }

            Look(visible.View, row, i, wanted);
        }
    }

    /// <summary>Part of a pixel's square that lies beyond a straight line, for eight pixels.</summary>
    /// <param name="atCentre">Absolute value at the pixel's centre of a function that is linear in the image and 0 on the line.</param>
    /// <param name="perColumn">Its absolute change from one column to the next.</param>
    /// <param name="perRow">Its absolute change from one row to the next.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Vector512<double> PartBeyond(Vector512<double> atCentre, Vector512<double> perColumn, Vector512<double> perRow)
    {
        Vector512<double> smaller = Vector512.MinNative(perColumn, perRow);
        Vector512<double> larger = Vector512.MaxNative(perColumn, perRow);
        Vector512<double> half = Vector512.Create(0.5);
        Vector512<double> reach = (half * (perColumn + perRow)) - atCentre; // at the square's farthest corner
        Vector512<double> corner = reach * reach * half / (smaller * larger);
        Vector512<double> strip = half - (atCentre / larger);
        return Vector512.GreaterThan(reach, Vector512<double>.Zero)
            & Vector512.ConditionalSelect(Vector512.LessThan(reach, smaller), corner, strip);
    }

    private static void Read(VisibleSurface visible, int row, ReadOnlySpan<double> factors, FacetRow facets)
    {
        if (row >= 0 && row < visible.Height)
        {
            visible.ReadFacets(row + 1, facets);
            factors.Slice(row * visible.Width, visible.Width).CopyTo(facets.Factors.AsSpan(1));
        }
        else
        {
            facets.Clear(visible.Width);
        }
    }

    /// <summary>Looks at eight pixels.</summary>
    /// <param name="view">The projection.</param>
    /// <param name="row">Their row.</param>
    /// <param name="column">Column of the first one.</param>
    /// <param name="wanted">The pixels whose means are wanted.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Look(ImageView view, int row, int column, uint wanted)
    {
        Vector512<long> own = Vector512.LoadUnsafe(ref _here.Facets[column + 1]);
        Vector512<long> left = Vector512.LoadUnsafe(ref _here.Facets[column]);
        Vector512<long> right = Vector512.LoadUnsafe(ref _here.Facets[column + 2]);
        Vector512<long> above = Vector512.LoadUnsafe(ref _above.Facets[column + 1]);
        Vector512<long> below = Vector512.LoadUnsafe(ref _below.Facets[column + 1]);
        Vector512<long> isLeft = Vector512.Equals(own, left);
        Vector512<long> isRight = Vector512.Equals(own, right);
        Vector512<long> isAbove = Vector512.Equals(own, above);
        Vector512<long> isBelow = Vector512.Equals(own, below);
        uint joined = (uint)(isLeft & isRight & isAbove & isBelow).ExtractMostSignificantBits();
        uint alone = ~(uint)(isLeft | isRight | isAbove | isBelow).ExtractMostSignificantBits();
        wanted &= ~joined & ~alone;
        uint other = alone;
        uint several = 0;
        if (wanted != 0 && view.Camera.Model.Lens is not null)
        {
            other |= wanted; // a lens makes curves of the lines
        }
        else if (wanted != 0)
        {
            // The line to a facet counts once, also where two neighbours show it; there is none to what lies outside the image.
            Vector512<long> outside = Vector512.Create(FacetRow.Outside);
            Lines lines = new(view, row, column, _here);
            lines.Add(~(isLeft | Vector512.Equals(left, outside)), _here, column, -1.0, 0.0);
            Vector512<long> isKnown = isRight | Vector512.Equals(right, left);
            lines.Add(~(isKnown | Vector512.Equals(right, outside)), _here, column + 2, 1.0, 0.0);
            isKnown = isAbove | Vector512.Equals(above, left) | Vector512.Equals(above, right);
            lines.Add(~(isKnown | Vector512.Equals(above, outside)), _above, column + 1, 0.0, -1.0);
            isKnown = isBelow | Vector512.Equals(below, left) | Vector512.Equals(below, right) | Vector512.Equals(below, above);
            lines.Add(~(isKnown | Vector512.Equals(below, outside)), _below, column + 1, 0.0, 1.0);

            Vector512<long> nothing = Vector512.Create(FacetRow.NoSurface);
            Vector512<long> isSky = Vector512.Equals(own, nothing) | Vector512.Equals(left, nothing) | Vector512.Equals(right, nothing)
                | Vector512.Equals(above, nothing) | Vector512.Equals(below, nothing);
            uint known = (uint)(lines.AreBetween & ~isSky).ExtractMostSignificantBits();
            other |= wanted & ~known;
            several = lines.Several & known & wanted;
            Vector512<double> isMeant = MaskOf(known & wanted);
            Vector512<double> centres = Vector512.LoadUnsafe(ref _here.Factors[column + 1]);
            Vector512.ConditionalSelect(isMeant, centres + lines.Brighter, centres).StoreUnsafe(ref _means[column]);
        }

        for (int lane = 0; lane < Lanes; lane++)
        {
            _kinds[column + lane] = (FacetsAround)((2 * ((other >> lane) & 1)) | ((several >> lane) & 1));
        }
    }

    private static Vector512<double> MaskOf(uint lanes)
    {
        Vector512<long> bits = Vector512.Create(1L, 2L, 4L, 8L, 16L, 32L, 64L, 128L);
        return Vector512.Equals(Vector512.Create((long)lanes) & bits, bits).AsDouble();
    }

    /// <summary>The lines in which the facets of eight pixels meet those of their neighbours.</summary>
    private struct Lines
    {
        private readonly Vector512<double> _rayX;
        private readonly Vector512<double> _rayY;
        private readonly Vector512<double> _rayZ;
        private readonly FacetRow _here;
        private readonly int _place;
        private readonly Vector3D _perColumn;
        private readonly Vector3D _perRow;
        private Vector512<double> _areBetween = Vector512<double>.AllBitsSet;
        private Vector512<double> _crossed = Vector512<double>.Zero;
        private Vector512<double> _several = Vector512<double>.Zero;
        private Vector512<double> _parts = Vector512<double>.Zero;
        private Vector512<double> _brighter = Vector512<double>.Zero;

        public Lines(ImageView view, int row, int column, FacetRow here)
        {
            Vector512<double> columns = Vector512.Create((double)column) + Vector512.Create(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);
            Vector3D first = view.FirstRay + (row * view.RayPerRow);
            (_perColumn, _perRow) = (view.RayPerColumn, view.RayPerRow);
            _rayX = Vector512.Create(first.X) + (columns * _perColumn.X);
            _rayY = Vector512.Create(first.Y) + (columns * _perColumn.Y);
            _rayZ = Vector512.Create(first.Z) + (columns * _perColumn.Z);
            (_here, _place) = (here, column + 1);
        }

        /// <summary>The pixels whose lines all lie between the pixel's centre and the neighbour's, with parts of at most 1.</summary>
        public readonly Vector512<long> AreBetween =>
            (_areBetween & Vector512.LessThanOrEqual(_parts, Vector512<double>.One)).AsInt64();

        /// <summary>The pixels that several lines cross.</summary>
        public readonly uint Several => (uint)_several.ExtractMostSignificantBits();

        /// <summary>By how much the pixels' mean I/F is larger than that of their centres.</summary>
        public readonly Vector512<double> Brighter => _brighter;

        /// <summary>Adds the lines to one neighbour of each pixel.</summary>
        /// <param name="isMeant">The pixels that have such a line.</param>
        /// <param name="row">The row of the neighbours.</param>
        /// <param name="place">Element of the first one.</param>
        /// <param name="right">px from a pixel to its neighbour.</param>
        /// <param name="down">px.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(Vector512<long> isMeant, FacetRow row, int place, double right, double down)
        {
            Vector512<double> x = Vector512.LoadUnsafe(ref _here.PlaneX[_place]) - Vector512.LoadUnsafe(ref row.PlaneX[place]);
            Vector512<double> y = Vector512.LoadUnsafe(ref _here.PlaneY[_place]) - Vector512.LoadUnsafe(ref row.PlaneY[place]);
            Vector512<double> z = Vector512.LoadUnsafe(ref _here.PlaneZ[_place]) - Vector512.LoadUnsafe(ref row.PlaneZ[place]);
            Vector512<double> atCentre = (x * _rayX) + (y * _rayY) + (z * _rayZ);
            Vector512<double> perColumn = (x * _perColumn.X) + (y * _perColumn.Y) + (z * _perColumn.Z);
            Vector512<double> perRow = (x * _perRow.X) + (y * _perRow.Y) + (z * _perRow.Z);
            Vector512<double> atNeighbour = atCentre + (perColumn * right) + (perRow * down);
            Vector512<double> zero = Vector512<double>.Zero;
            Vector512<double> mask = isMeant.AsDouble();
            _areBetween &= ~mask | (Vector512.LessThanOrEqual(atCentre, zero) & Vector512.GreaterThanOrEqual(atNeighbour, zero))
                | (Vector512.GreaterThanOrEqual(atCentre, zero) & Vector512.LessThanOrEqual(atNeighbour, zero));
            Vector512<double> part = mask & PartBeyond(Vector512.Abs(atCentre), Vector512.Abs(perColumn), Vector512.Abs(perRow));
            Vector512<double> crosses = Vector512.GreaterThan(part, zero);
            _several |= _crossed & crosses;
            _crossed |= crosses;
            _parts += part;
            _brighter += part * (Vector512.LoadUnsafe(ref row.Factors[place]) - Vector512.LoadUnsafe(ref _here.Factors[_place]));
        }
    }
}
