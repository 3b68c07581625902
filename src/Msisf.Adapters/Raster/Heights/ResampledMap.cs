using Msisf.Adapters.Interop;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// Brings a map in any projection that PROJ knows to a grid that is read: polar stereographic near a pole, otherwise the Moon's.
/// Values are bilinear between pixels; where one of the pixels around has no data, there is none. A map in a cylindrical projection that
/// goes all around has no seam, wherever it begins. Not safe for several threads.
/// </summary>
internal sealed class ResampledMap : IDisposable
{
    /// <summary>Rows of a part in which places lie on a lattice; their pixels are in memory at once.</summary>
    private const int LatticeRows = 32;

    /// <summary>Side of a part in which each place has to be found for itself.</summary>
    private const int TileSide = 64;

    /// <summary>Pixels that are read at once: where places of a part lie farther apart, as around a pole, it is cut.</summary>
    private const long MostPixels = 1L << 20;

    /// <summary>Places of a part that is not cut further.</summary>
    private const int FewestPlaces = 64;

    private readonly GdalImage _map;
    private readonly MapPlane _plane;
    private readonly bool _isLattice;
    private double[] _columns = [];
    private double[] _rows = [];
    private float[] _pixels = [];
    private int[] _left = [];
    private int[] _right = [];
    private double[] _across = [];

    private ResampledMap(GdalImage map, MapPlane plane, GeoTiffPlacement placement)
    {
        (_map, _plane, Placement) = (map, plane, placement);
        _isLattice = placement.Projection is Equirectangular && plane.IsCylindrical;
    }

    /// <summary>Where the samples lie.</summary>
    public GeoTiffPlacement Placement { get; }

    /// <summary>Resamples a map.</summary>
    /// <returns>Null if PROJ can't bring it to the Moon, or its pixels are too small.</returns>
    public static ResampledMap? Of(GdalImage map)
    {
        ProjText proj = new(map.Projection()!);
        if (MapPlane.Of(map, proj) is not { } plane)
        {
            return null;
        }

        if (MapFootprint.Of(plane)?.Placement(plane) is { } placement)
        {
            return new ResampledMap(map, plane, placement);
        }

        plane.Dispose();
        return null;
    }

    /// <summary>Reads a rectangle of samples; lines and samples count in the window of the placement.</summary>
    /// <param name="rule">Tells which pixels have no data.</param>
    /// <param name="values">Receives the values, NaN without data.</param>
    /// <param name="stride">Values from one line to the next.</param>
    /// <returns>
    /// Pixels around the samples that can't be heights and are not declared; those around several parts count several times.
    /// </returns>
    public UndeclaredGaps Read(int line, int lines, int sample, int samples, Span<float> values, int stride, HeightRule rule)
    {
        UndeclaredGaps found = UndeclaredGaps.None;
        (int rows, int columns) = _isLattice ? (LatticeRows, samples) : (TileSide, TileSide);
        for (int i = 0; i < lines; i += rows)
        {
            for (int j = 0; j < samples; j += columns)
            {
                found = found.With(ReadPart(
                    line + i, Math.Min(rows, lines - i), sample + j, Math.Min(columns, samples - j), values[((i * stride) + j)..], stride,
                    rule));
            }
        }

        return found;
    }

    /// <summary>Forgets PROJ's ways; the map stays open.</summary>
    public void Dispose() => _plane.Dispose();

    private UndeclaredGaps ReadPart(
        int line, int lines, int sample, int samples, Span<float> values, int stride, HeightRule rule)
    {
        int places = lines * samples;
        Span<double> columns = Sized(ref _columns, _isLattice ? samples : places);
        Span<double> rows = Sized(ref _rows, _isLattice ? lines : places);
        FindPlaces(line, lines, sample, samples, columns, rows);
        PixelBox box = PixelBox.Around(_plane, columns, rows, _isLattice);
        if (!_isLattice && (long)box.Rows * box.Columns > MostPixels && places > FewestPlaces)
        {
            return Halves(line, lines, sample, samples, values, stride, rule);
        }

        UndeclaredGaps found = ReadBox(box, rule);
        Span<int> left = Sized(ref _left, columns.Length);
        Span<int> right = Sized(ref _right, columns.Length);
        Span<double> across = Sized(ref _across, columns.Length);
        for (int i = 0; i < columns.Length; i++)
        {
            PixelNeighbours of = PixelNeighbours.Of(columns[i], box.Column, _plane.Width, _plane.IsRing);
            (left[i], right[i], across[i]) = (of.First, of.Second, of.Part);
        }

        for (int i = 0; i < lines; i++)
        {
            Span<float> row = values.Slice(i * stride, samples);
            if (_isLattice)
            {
                Blend(row, rows[i], left, right, across);
                continue;
            }

            for (int j = 0; j < samples; j++)
            {
                int place = (i * samples) + j;
                Blend(row.Slice(j, 1), rows[place], left.Slice(place, 1), right.Slice(place, 1), across.Slice(place, 1));
            }
        }

        return found;

        void Blend(Span<float> target, double row, ReadOnlySpan<int> before, ReadOnlySpan<int> behind, ReadOnlySpan<double> part)
        {
            PixelNeighbours down = PixelNeighbours.Of(row, box.Row, _plane.Height, isRing: false);
            if (double.IsNaN(down.Part) || box.IsEmpty)
            {
                target.Fill(float.NaN);
                return;
            }

            Bilinear.Blend(
                target, _pixels.AsSpan(down.First * box.Columns, box.Columns), _pixels.AsSpan(down.Second * box.Columns, box.Columns),
                down.Part, before, behind, part);
        }
    }

    private UndeclaredGaps Halves(int line, int lines, int sample, int samples, Span<float> values, int stride, HeightRule rule)
    {
        (int upper, int left) = lines >= samples ? (lines / 2, samples) : (lines, samples / 2);
        UndeclaredGaps first = ReadPart(line, upper, sample, left, values, stride, rule);
        return first.With(lines >= samples
            ? ReadPart(line + upper, lines - upper, sample, samples, values[(upper * stride)..], stride, rule)
            : ReadPart(line, lines, sample + left, samples - left, values[left..], stride, rule));
    }

    /// <summary>Where samples lie among the pixels of the map, counted from the centre of its first one; NaN for nowhere.</summary>
    private void FindPlaces(int line, int lines, int sample, int samples, Span<double> columns, Span<double> rows)
    {
        GridWindow window = Placement.Window;
        (line, sample) = (window.FirstLine + line, window.FirstSample + sample);
        if (_isLattice)
        {
            double resolution = ((Equirectangular)Placement.Projection).PixelsPerDegree;
            for (int i = 0; i < lines; i++)
            {
                rows[i] = 90.0 - ((line + i + 0.5) / resolution);
            }

            for (int j = 0; j < samples; j++)
            {
                columns[j] = (sample + j + 0.5) / resolution;
            }

            _plane.ToLattice(columns, rows);
            return;
        }

        for (int i = 0; i < lines; i++)
        {
            for (int j = 0; j < samples; j++)
            {
                SelenographicPoint point = SelenographicPoint.Below(Placement.Projection.DirectionOf(line + i, sample + j));
                columns[(i * samples) + j] = double.RadiansToDegrees(point.Longitude);
                rows[(i * samples) + j] = double.RadiansToDegrees(point.Latitude);
            }
        }

        _plane.ToPixels(columns, rows);
    }

    /// <summary>Reads pixels, of which those beyond the end of a row are at its beginning.</summary>
    private UndeclaredGaps ReadBox(PixelBox box, HeightRule rule)
    {
        if (box.IsEmpty)
        {
            return UndeclaredGaps.None;
        }

        Span<float> pixels = Sized(ref _pixels, box.Rows * box.Columns);
        for (int done = 0, count; done < box.Columns; done += count)
        {
            int column = _plane.ColumnAround(box.Column + done);
            count = Math.Min(box.Columns - done, _plane.Width - column);
            _map.Read(box.Row, box.Rows, column, count, pixels[done..], box.Columns);
        }

        UndeclaredGaps found = UndeclaredGaps.None;
        for (int i = rule.AreHeights(pixels) ? pixels.Length : 0; i < pixels.Length; i++)
        {
            if (!rule.IsHeight(pixels[i]))
            {
                found = float.IsNaN(pixels[i]) && _map.DeclaresGaps ? found : found.With(
                    box.Row + (i / box.Columns), _plane.ColumnAround(box.Column + (i % box.Columns)), pixels[i]);
                pixels[i] = float.NaN;
            }
        }

        return found;
    }

    private static Span<T> Sized<T>(ref T[] buffer, int count)
    {
        buffer = buffer.Length < count ? new T[count] : buffer;
        return buffer.AsSpan(0, count);
    }

    /// <summary>Pixels around places.</summary>
    private readonly record struct PixelBox(int Row, int Rows, int Column, int Columns)
    {
        public bool IsEmpty => Rows <= 0 || Columns <= 0;

        public static PixelBox Around(MapPlane plane, ReadOnlySpan<double> columns, ReadOnlySpan<double> rows, bool isLattice)
        {
            (double top, double bottom, double left, double right) = (double.MaxValue, double.MinValue, double.MaxValue, double.MinValue);
            for (int i = 0; i < Math.Max(columns.Length, rows.Length); i++)
            {
                (double row, double column) = (i < rows.Length ? rows[i] : double.NaN, i < columns.Length ? columns[i] : double.NaN);
                if (isLattice || !(double.IsNaN(row) || double.IsNaN(column)))
                {
                    (top, bottom) = (row < top ? row : top, row > bottom ? row : bottom);
                    (left, right) = (column < left ? column : left, column > right ? column : right);
                }
            }

            if (!(top <= bottom && left <= right))
            {
                return default;
            }

            // One pixel more than the last place lies behind: its weight may be none, but it is there.
            int firstRow = (int)Math.Clamp(Math.Floor(top), 0.0, plane.Height - 1.0);
            int lastRow = (int)Math.Clamp(Math.Floor(bottom) + 1.0, 0.0, plane.Height - 1.0);
            double mostLeft = plane.IsRing ? double.MinValue : 0.0;
            double mostRight = plane.IsRing ? double.MaxValue : plane.Width - 1.0;
            int firstColumn = (int)Math.Clamp(Math.Floor(left), mostLeft, mostRight);
            int lastColumn = (int)Math.Clamp(Math.Floor(right) + 1.0, mostLeft, mostRight);
            return new PixelBox(firstRow, lastRow + 1 - firstRow, firstColumn, lastColumn + 1 - firstColumn);
        }
    }
}
