using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Sampling;

/// <summary>
/// Finds the mean brightness of pixels in which facets larger than pixels meet, from what the pixels' centres show: the edge of two facets
/// is the line in which their planes meet, so it is known which part of a pixel lies beyond it. Each thread needs its own object.
/// </summary>
internal sealed class FacetAreas
{
    private const int Lanes = 4;

    private FacetRow _above = new();
    private FacetRow _here = new();
    private FacetRow _below = new();
    private FacetsAround[] _kinds = [];

    /// <summary>What the neighbours of the last row's pixels show.</summary>
    public ReadOnlySpan<FacetsAround> Kinds => _kinds;

    /// <summary>Looks at a row; the rows of a band from top to bottom.</summary>
    /// <param name="visible">What the pixels' centres show.</param>
    /// <param name="row">The row, from 0.</param>
    /// <param name="contrasts">Contrast around each pixel of the row, levels of 255.</param>
    /// <param name="minContrast">Means are wanted of pixels with at least so much contrast.</param>
    /// <param name="factors">I/F of the centres of all pixels of the image.</param>
    /// <param name="means">
    /// Receives the mean I/F of the row's pixels with so much contrast; where <see cref="Kinds"/> is <see cref="FacetsAround.Other"/>, the
    /// centre's.
    /// </param>
    public void Look(
        VisibleSurface visible, int row, bool isFirst, ReadOnlySpan<byte> contrasts, int minContrast, ReadOnlySpan<double> factors,
        Span<double> means)
    {
        int width = visible.Width;
        if (_kinds.Length < width + Lanes)
        {
            _kinds = new FacetsAround[width + Lanes];
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
        Span<byte> four = stackalloc byte[Lanes];
        for (int i = 0; i < width; i += Lanes)
        {
            int count = Math.Min(Lanes, width - i);
            four.Clear();
            contrasts.Slice(i, count).CopyTo(four);
            uint wanted = 0;
            if (MemoryMarshal.Read<uint>(four) != 0)
            {
                for (int lane = 0; lane < Lanes; lane++)
                {
                    wanted |= four[lane] >= minContrast ? 1u << lane : 0;
                }
            }

            Vector256<double> found = Look(visible.View, row, i, wanted);
            if (wanted != 0)
            {
                for (int lane = 0; lane < count; lane++)
                {
                    means[i + lane] = found[lane];
                }
            }
        }
    }

    /// <summary>Part of a pixel's square that lies beyond a straight line, for four pixels.</summary>
    /// <param name="atCentre">Absolute value at the pixel's centre of a function that is linear in the image and 0 on the line.</param>
    /// <param name="perColumn">Its absolute change from one column to the next.</param>
    /// <param name="perRow">Its absolute change from one row to the next.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static Vector256<double> PartBeyond(Vector256<double> atCentre, Vector256<double> perColumn, Vector256<double> perRow)
    {
        Vector256<double> smaller = Vector256.MinNative(perColumn, perRow);
        Vector256<double> larger = Vector256.MaxNative(perColumn, perRow);
        Vector256<double> half = Vector256.Create(0.5);
        Vector256<double> reach = (half * (perColumn + perRow)) - atCentre; // at the square's farthest corner
        Vector256<double> corner = reach * reach * half / (smaller * larger);
        Vector256<double> strip = half - (atCentre / larger);
        return Vector256.GreaterThan(reach, Vector256<double>.Zero)
            & Vector256.ConditionalSelect(Vector256.LessThan(reach, smaller), corner, strip);
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

    /// <summary>Looks at four pixels.</summary>
    /// <param name="view">The projection.</param>
    /// <param name="column">Column of the first one.</param>
    /// <param name="wanted">The pixels whose means are wanted.</param>
    /// <returns>The means that are known, and the brightness of the centres where none is.</returns>
    private Vector256<double> Look(ImageView view, int row, int column, uint wanted)
    {
        int place = column + 1;
        Vector256<long> own = ArrayLanes.Load256(_here.Facets, place);
        Vector256<long> left = ArrayLanes.Load256(_here.Facets, place - 1);
        Vector256<long> right = ArrayLanes.Load256(_here.Facets, place + 1);
        Vector256<long> above = ArrayLanes.Load256(_above.Facets, place);
        Vector256<long> below = ArrayLanes.Load256(_below.Facets, place);
        Vector256<long> isLeft = Vector256.Equals(own, left);
        Vector256<long> isRight = Vector256.Equals(own, right);
        Vector256<long> isAbove = Vector256.Equals(own, above);
        Vector256<long> isBelow = Vector256.Equals(own, below);
        uint joined = (isLeft & isRight & isAbove & isBelow).ExtractMostSignificantBits();
        uint alone = ~(isLeft | isRight | isAbove | isBelow).ExtractMostSignificantBits();
        uint other = alone;
        uint several = 0;
        wanted &= ~(joined | alone);
        Vector256<double> means = ArrayLanes.Load256(_here.Factors, place);
        if (wanted != 0 && view.Camera.Model.Lens is not null)
        {
            other |= wanted; // a lens makes curves of the lines
        }
        else if (wanted != 0)
        {
            // The line to a facet counts once, also where two neighbours show it; there is none to what lies outside the image.
            Vector256<long> outside = Vector256.Create(FacetRow.Outside);
            Vector256<long> notRight = isRight | Vector256.Equals(right, left);
            Vector256<long> notAbove = isAbove | Vector256.Equals(above, left) | Vector256.Equals(above, right);
            Vector256<long> notBelow = isBelow | Vector256.Equals(below, left) | Vector256.Equals(below, right)
                | Vector256.Equals(below, above);
            Rays rays = new(view, row, column);
            Lines lines = Lines.None;
            lines = lines.With(~(isLeft | Vector256.Equals(left, outside)), rays, _here, place, _here, place - 1, -1.0, 0.0);
            lines = lines.With(~(notRight | Vector256.Equals(right, outside)), rays, _here, place, _here, place + 1, 1.0, 0.0);
            lines = lines.With(~(notAbove | Vector256.Equals(above, outside)), rays, _here, place, _above, place, 0.0, -1.0);
            lines = lines.With(~(notBelow | Vector256.Equals(below, outside)), rays, _here, place, _below, place, 0.0, 1.0);

            Vector256<long> nothing = Vector256.Create(FacetRow.NoSurface);
            Vector256<long> isSky = Vector256.Equals(own, nothing) | Vector256.Equals(left, nothing) | Vector256.Equals(right, nothing)
                | Vector256.Equals(above, nothing) | Vector256.Equals(below, nothing);
            Vector256<double> isKnown = lines.AreBetween & Vector256.LessThanOrEqual(lines.Parts, Vector256<double>.One)
                & ~isSky.AsDouble();
            uint known = isKnown.ExtractMostSignificantBits();
            other |= wanted & ~known;
            several = lines.Several.ExtractMostSignificantBits() & known & wanted;
            means = Vector256.ConditionalSelect(isKnown, means + lines.Brighter, means);
        }

        for (int lane = 0; lane < Lanes; lane++)
        {
            _kinds[column + lane] = (FacetsAround)((2 * ((other >> lane) & 1)) | ((several >> lane) & 1));
        }

        return means;
    }

    /// <summary>The rays of four pixels, and how a function of the ray changes in the image.</summary>
    private readonly struct Rays
    {
        private readonly Vector256<double> _x;
        private readonly Vector256<double> _y;
        private readonly Vector256<double> _z;
        private readonly Vector3D _perColumn;
        private readonly Vector3D _perRow;

        public Rays(ImageView view, int row, int column)
        {
            Vector256<double> columns = Vector256.Create((double)column) + Vector256.Create(0.0, 1.0, 2.0, 3.0);
            Vector3D first = view.FirstRay + (row * view.RayPerRow);
            (_perColumn, _perRow) = (view.RayPerColumn, view.RayPerRow);
            _x = Vector256.Create(first.X) + (columns * _perColumn.X);
            _y = Vector256.Create(first.Y) + (columns * _perColumn.Y);
            _z = Vector256.Create(first.Z) + (columns * _perColumn.Z);
        }

        /// <summary>The dot products of vectors with the pixels' rays, and their changes from one column and row to the next.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Dot(
            Vector256<double> x, Vector256<double> y, Vector256<double> z, out Vector256<double> atCentre, out Vector256<double> perColumn,
            out Vector256<double> perRow)
        {
            atCentre = (x * _x) + (y * _y) + (z * _z);
            perColumn = (x * _perColumn.X) + (y * _perColumn.Y) + (z * _perColumn.Z);
            perRow = (x * _perRow.X) + (y * _perRow.Y) + (z * _perRow.Z);
        }
    }

    /// <summary>The lines in which the facets of four pixels meet those of their neighbours.</summary>
    /// <param name="AreBetween">The pixels whose lines all lie between the pixel's centre and the neighbour's.</param>
    /// <param name="Crossed">The pixels that a line crosses.</param>
    /// <param name="Several">The pixels that several lines cross.</param>
    /// <param name="Parts">Sum of the pixels' parts beyond their lines.</param>
    /// <param name="Brighter">By how much the pixels' mean I/F is larger than that of their centres.</param>
    private readonly record struct Lines(
        Vector256<double> AreBetween, Vector256<double> Crossed, Vector256<double> Several, Vector256<double> Parts,
        Vector256<double> Brighter)
    {
        public static Lines None => new(
            Vector256<double>.AllBitsSet, Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero, Vector256<double>.Zero);

        /// <summary>Adds the lines to one neighbour of each pixel.</summary>
        /// <param name="isMeant">The pixels that have such a line.</param>
        /// <param name="place">Element of the first pixel.</param>
        /// <param name="neighbour">Element of the first neighbour.</param>
        /// <param name="right">px from a pixel to its neighbour.</param>
        /// <param name="down">px.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Lines With(
            Vector256<long> isMeant, in Rays rays, FacetRow here, int place, FacetRow there, int neighbour, double right, double down)
        {
            rays.Dot(
                ArrayLanes.Load256(here.PlaneX, place) - ArrayLanes.Load256(there.PlaneX, neighbour),
                ArrayLanes.Load256(here.PlaneY, place) - ArrayLanes.Load256(there.PlaneY, neighbour),
                ArrayLanes.Load256(here.PlaneZ, place) - ArrayLanes.Load256(there.PlaneZ, neighbour),
                out Vector256<double> atCentre, out Vector256<double> perColumn, out Vector256<double> perRow);
            Vector256<double> atNeighbour = atCentre + (perColumn * right) + (perRow * down);
            Vector256<double> zero = Vector256<double>.Zero;
            Vector256<double> mask = isMeant.AsDouble();
            Vector256<double> isBetween = (Vector256.LessThanOrEqual(atCentre, zero) & Vector256.GreaterThanOrEqual(atNeighbour, zero))
                | (Vector256.GreaterThanOrEqual(atCentre, zero) & Vector256.LessThanOrEqual(atNeighbour, zero));
            Vector256<double> part = mask & PartBeyond(Vector256.Abs(atCentre), Vector256.Abs(perColumn), Vector256.Abs(perRow));
            Vector256<double> crosses = Vector256.GreaterThan(part, zero);
            Vector256<double> brighter = ArrayLanes.Load256(there.Factors, neighbour) - ArrayLanes.Load256(here.Factors, place);
            return new Lines(
                AreBetween & (isBetween | ~mask), Crossed | crosses, Several | (Crossed & crosses), Parts + part,
                Brighter + (part * brighter));
        }
    }
}

/// <summary>How the facets that a pixel's four neighbours show lie to the one that the pixel's centre shows.</summary>
internal enum FacetsAround : byte
{
    /// <summary>They are the same facet, or meet it in straight lines of which at most one crosses the pixel.</summary>
    OneLine,

    /// <summary>They meet it in straight lines of which several cross the pixel.</summary>
    Lines,

    /// <summary>
    /// One meets it in no line between the two, as at a silhouette, or none of them is the same: facets are about as small as pixels.
    /// </summary>
    Other,
}
