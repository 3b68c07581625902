using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Rows of an image that are drawn together: for each pixel the nearest facet so far. One object is used for many frames. A facet is
/// recorded when it first wins a pixel.
/// </summary>
internal sealed class Band
{
    /// <summary>The number of no facet.</summary>
    public const int NotRecorded = -1;

    private const int FirstCapacity = 1024;

    /// <summary>
    /// Elements behind the last column of a row, so that eight pixels can be read and written from any column on without range checks.
    /// </summary>
    private const int Padding = 8;

    private FacetRecord[] _records = new FacetRecord[FirstCapacity];

    /// <summary>Elements from one row to the next.</summary>
    public int Stride { get; private set; }

    /// <summary>The image's columns.</summary>
    public int Width { get; private set; }

    /// <summary>Its first row, from 0.</summary>
    public int FirstRow { get; private set; }

    /// <summary>Its last row.</summary>
    public int LastRow { get; private set; }

    /// <summary>1/m: one over the depth of each pixel's nearest point; 0 where there is none.</summary>
    public double[] InverseDepths { get; private set; } = [];

    /// <summary>Number of each pixel's facet in <see cref="Records"/>; means nothing where there is none.</summary>
    public int[] Facets { get; private set; } = [];

    /// <summary>Facets that won a pixel.</summary>
    public ReadOnlySpan<FacetRecord> Records => _records.AsSpan(0, RecordCount);

    /// <summary>How many facets won a pixel.</summary>
    public int RecordCount { get; private set; }

    /// <summary>Empties the band for new rows.</summary>
    public void Begin(int width, int firstRow, int rows)
    {
        Width = width;
        FirstRow = firstRow;
        LastRow = firstRow + rows - 1;
        Stride = width + Padding;
        RecordCount = 0;
        int size = Stride * rows;
        if (InverseDepths.Length < size)
        {
            InverseDepths = new double[size];
            Facets = new int[size];
        }
        else
        {
            InverseDepths.AsSpan(0, size).Clear();
        }
    }

    /// <summary>
    /// Index of a pixel in <see cref="InverseDepths"/> and <see cref="Facets"/>; seven more pixels may be read and written from there.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int IndexOf(int column, int row)
    {
        Debug.Assert((uint)column < (uint)Width && row >= FirstRow && row <= LastRow, "A pixel lies outside its band.");
        return ((row - FirstRow) * Stride) + column;
    }

    /// <summary>Records a facet; returns its number.</summary>
    /// <param name="block">The facet's block.</param>
    /// <param name="index">Its cell's north-western vertex.</param>
    /// <param name="half">0: the south-western facet, 1: the north-eastern one.</param>
    public int Add(ProjectedBlock block, int index, int half)
    {
        if (RecordCount == _records.Length)
        {
            Array.Resize(ref _records, 2 * RecordCount);
        }

        _records[RecordCount] = block.Record(index, half);
        return RecordCount++;
    }
}
