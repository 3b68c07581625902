using System.Runtime.InteropServices;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The surface points that a frame's pixels show. Reading is safe for several threads, each with its own <see cref="SurfaceRow"/>.
/// </summary>
internal sealed class VisibleSurface : ISurfaceRows
{
    /// <summary>Number of rows of a band; the last band may have fewer.</summary>
    public const int BandRows = 64;

    private readonly List<Band> _bands = [];
    private RowResolver _resolver = null!;

    public int Width { get; private set; }

    public int Height { get; private set; }

    public ImageView View { get; private set; } = null!;

    /// <summary>Counts of the work for the frame.</summary>
    public VisibilityCounts Counts { get; private set; }

    /// <summary>Bytes of the buffers that the bands have replaced since the first frame.</summary>
    public long ReplacedBytes => _bands.Sum(band => band.Records.ReplacedBytes);

    /// <summary>Number of bands of the frame.</summary>
    internal int BandCount { get; private set; }

    /// <summary>Computes the surface point that a pixel shows.</summary>
    /// <param name="x">1 to the width.</param>
    /// <param name="y">1 to the height.</param>
    /// <param name="hit">The point and its facet, with the facet's normal.</param>
    public bool TryGet(int x, int y, out SurfaceHit hit)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(x, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(x, Width);
        Band band = BandOf(y, out int row);
        int pixel = ((row - band.FirstRow) * band.Stride) + x - 1;
        double inverse = band.InverseDepths[pixel];
        hit = inverse > 0.0 ? _resolver.Resolve(x - 1, row, inverse, band.Records[band.Facets[pixel]]) : default;
        return inverse > 0.0;
    }

    public void Read(int y, SurfaceRow row)
    {
        Band band = BandOf(y, out int index);
        _resolver.Resolve(band, index, row);
    }

    public void ReadPoints(int y, ReadOnlySpan<int> columns, SurfaceRow row)
    {
        Band band = BandOf(y, out int index);
        _resolver.Resolve(band, index, columns, row);
    }

    public FacetId FacetOf(int y, int number) => BandOf(y, out _).Records[number].Facet;

    /// <summary>The facets of a row that was read.</summary>
    /// <param name="y">1 to the height.</param>
    /// <param name="facets">Receives the facet of each point.</param>
    public void ReadFacets(int y, SurfaceRow row, Span<FacetId> facets)
    {
        ReadOnlySpan<FacetRecord> records = BandOf(y, out _).Records.AsSpan();
        for (int i = 0; i < row.Count; i++)
        {
            facets[i] = records[row.Facets[i]].Facet;
        }
    }

    /// <summary>Tells which pixels of a row show the same facet, and how the facets' planes lie.</summary>
    /// <param name="y">1 to the height.</param>
    /// <param name="row">Receives the facets.</param>
    public void ReadFacets(int y, FacetRow row)
    {
        Band band = BandOf(y, out int index);
        int start = (index - band.FirstRow) * band.Stride;
        ReadOnlySpan<double> inverses = band.InverseDepths.AsSpan(start, Width);
        ReadOnlySpan<int> numbers = band.Facets.AsSpan(start, Width);
        ReadOnlySpan<FacetRecord> records = band.Records.AsSpan();
        row.Clear(Width);
        Span<long> facets = row.Facets.AsSpan(1, Width);
        Span<double> planeX = row.PlaneX.AsSpan(1, Width);
        Span<double> planeY = row.PlaneY.AsSpan(1, Width);
        Span<double> planeZ = row.PlaneZ.AsSpan(1, Width);
        Vector3D camera = View.Camera.PositionBodyFixed - View.Anchor;
        facets.Fill(FacetRow.NoSurface);
        ReadOnlySpan<long> bits = MemoryMarshal.Cast<double, long>(inverses); // 0 without surface
        int last = Band.NotRecorded;
        long facet = FacetRow.NoSurface;
        Vector3D plane = default;
        for (int i = 0, next; i < bits.Length && (next = bits[i..].IndexOfAnyExcept(0L)) >= 0;)
        {
            for (i += next; i < bits.Length && bits[i] != 0; i++)
            {
                int number = numbers[i];
                if (number != last)
                {
                    last = number;
                    ref readonly FacetRecord record = ref records[number];
                    facet = ((long)record.Line << 32) | (uint)record.PartSampleAndHalf;
                    plane = record.Normal / (record.Offset - Vector3D.Dot(record.Normal, camera));
                }

                (facets[i], planeX[i], planeY[i], planeZ[i]) = (facet, plane.X, plane.Y, plane.Z);
            }
        }
    }

    /// <summary>Starts a new frame.</summary>
    /// <param name="view">The frame's projection.</param>
    /// <param name="lens">The samples of a camera with a lens; null for a pinhole.</param>
    internal void Begin(ImageView view, LensSamples? lens)
    {
        View = view;
        Width = view.Camera.Width;
        Height = view.Camera.Height;
        BandCount = (Height + BandRows - 1) / BandRows;
        while (_bands.Count < BandCount)
        {
            _bands.Add(new Band());
        }

        _resolver = new RowResolver(view, lens);
    }

    /// <summary>Empties a band of the frame for drawing.</summary>
    internal Band BeginBand(int index)
    {
        int firstRow = index * BandRows;
        _bands[index].Begin(Width, firstRow, Math.Min(BandRows, Height - firstRow));
        return _bands[index];
    }

    /// <summary>Stores the counts of the work for the frame.</summary>
    internal void End(VisibilityCounts counts) => Counts = counts;

    private Band BandOf(int y, out int row)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(y, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(y, Height);
        row = y - 1;
        return _bands[row / BandRows];
    }
}
