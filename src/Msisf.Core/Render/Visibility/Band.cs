using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The depth buffer of some rows of an image: for each pixel the nearest facet drawn so far. One object is used for many frames. A facet is
/// recorded when it first becomes the nearest one at a pixel.
/// </summary>
internal sealed class Band
{
    /// <summary>Facet number that stands for a facet that is not recorded yet.</summary>
    public const int NotRecorded = -1;

    /// <summary>
    /// Elements after the last column of each row, so that eight pixels can be read and written from any column without range checks.
    /// </summary>
    private const int Padding = 8;

    /// <summary>Number of array elements from one row to the next.</summary>
    public int Stride { get; private set; }

    /// <summary>The image's width, px.</summary>
    public int Width { get; private set; }

    /// <summary>The band's first row in the image, counted from 0.</summary>
    public int FirstRow { get; private set; }

    /// <summary>The band's last row in the image, counted from 0.</summary>
    public int LastRow { get; private set; }

    /// <summary>The pixels that are being drawn: the whole band, or a tile of it.</summary>
    public PixelRange Window { get; private set; }

    /// <summary>
    /// Column of each pixel's sample in the plane that is drawn in; empty for a pinhole, whose samples are the pixels' centres.
    /// </summary>
    public double[] SampleColumns { get; private set; } = [];

    /// <summary>Row of each pixel's sample; ordered like <see cref="SampleColumns"/>.</summary>
    public double[] SampleRows { get; private set; } = [];

    /// <summary>px: maximum distance of a sample from its pixel's centre along columns or rows; 0 for a pinhole.</summary>
    public double Margin { get; private set; }

    /// <summary>1/m: the inverse depth of each pixel's nearest point; 0 where no facet has been drawn.</summary>
    public double[] InverseDepths { get; private set; } = [];

    /// <summary>Index of each pixel's facet in <see cref="Records"/>; undefined where no facet has been drawn.</summary>
    public int[] Facets { get; private set; } = [];

    /// <summary>The facets that have been the nearest one at some pixel.</summary>
    public FacetRecords Records { get; } = new();

    /// <summary>Empties the band for new rows; gives back memory for records that the last frames did not need.</summary>
    public void Begin(int width, int firstRow, int rows)
    {
        Width = width;
        FirstRow = firstRow;
        LastRow = firstRow + rows - 1;
        Stride = width + Padding;
        Records.Trim();
        Records.Clear();
        Window = new PixelRange(0, width - 1, firstRow, LastRow);
        SampleColumns = SampleRows = [];
        Margin = 0.0;
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

    /// <summary>Notes that no pixel shows a facet yet, for readers that do not look at the depths.</summary>
    public void ClearFacets() => Facets.AsSpan(0, Stride * (LastRow - FirstRow + 1)).Fill(NotRecorded);

    /// <summary>Sets where the samples of an image with a lens lie, each in the plane of its tile.</summary>
    /// <param name="columns">Memory for the columns of the samples; replaced if it is too small.</param>
    /// <param name="rows">Memory for their rows.</param>
    public void Place(IReadOnlyList<LensTile> tiles, LensSamples lens, ref double[] columns, ref double[] rows)
    {
        int size = Stride * (LastRow - FirstRow + 1);
        if (columns.Length < size)
        {
            columns = new double[size];
            rows = new double[size];
        }

        (SampleColumns, SampleRows) = (columns, rows);
        foreach (LensTile tile in tiles)
        {
            int width = tile.Pixels.LastColumn - tile.Pixels.FirstColumn + 1;
            for (int row = tile.Pixels.FirstRow; row <= tile.Pixels.LastRow; row++)
            {
                int start = IndexOf(tile.Pixels.FirstColumn, row);
                int sample = (row * Width) + tile.Pixels.FirstColumn;
                tile.Map.Apply(
                    lens.Right.AsSpan(sample, width), lens.Down.AsSpan(sample, width), columns.AsSpan(start, width),
                    rows.AsSpan(start, width));
            }
        }
    }

    /// <summary>Goes on with one tile of an image with a lens.</summary>
    public void Narrow(LensTile tile)
    {
        Window = tile.Pixels;
        Margin = tile.Margin;
    }

    /// <summary>
    /// Index of a pixel in <see cref="InverseDepths"/> and <see cref="Facets"/>; that pixel and the next seven may be read and written.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int IndexOf(int column, int row)
    {
        Debug.Assert((uint)column < (uint)Width && row >= FirstRow && row <= LastRow, "A pixel lies outside its band.");
        return ((row - FirstRow) * Stride) + column;
    }
}

/// <summary>A rectangle of pixels, counted from 0, with both ends included. It is empty if a first index is above its last.</summary>
internal readonly record struct PixelRange(int FirstColumn, int LastColumn, int FirstRow, int LastRow)
{
    public bool IsEmpty => FirstColumn > LastColumn || FirstRow > LastRow;

    /// <summary>The pixels of a band that are drawn and whose centres lie within limits (px), which may be infinite.</summary>
    public static PixelRange Within(double left, double right, double top, double bottom, Band band) =>
        Within(left, right, top, bottom, band.Window);

    /// <summary>The pixels of a window whose centres lie within limits (px), which may be infinite.</summary>
    public static PixelRange Within(double left, double right, double top, double bottom, in PixelRange window) => new(
        (int)Math.Clamp(Math.Ceiling(left), window.FirstColumn, window.LastColumn + 1.0),
        (int)Math.Clamp(Math.Floor(right), window.FirstColumn - 1.0, window.LastColumn),
        (int)Math.Clamp(Math.Ceiling(top), window.FirstRow, window.LastRow + 1.0),
        (int)Math.Clamp(Math.Floor(bottom), window.FirstRow - 1.0, window.LastRow));
}
