using Msisf.Core.Surface.Sources;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The values of a raster's outermost pixels, and of those between which and them its slope is taken. Each run needs them where the raster
/// lies in a coarser model: read from the file, each block along the border would be unpacked for them.
/// </summary>
/// <param name="Height">Number of rows.</param>
/// <param name="Width">Pixels of a row.</param>
/// <param name="Values">NaN without data: four rows, then four columns (<see cref="IndexOf"/>).</param>
internal sealed record RasterBorder(int Height, int Width, float[] Values)
{
    private const int Inwards = BorderMisfit.SlopeSamples;

    /// <summary>A border to fill.</summary>
    public RasterBorder(int height, int width)
        : this(height, width, new float[4 * (height + width)])
    {
    }

    /// <summary>Takes what lies on the border of a part of a row. Safe for several threads that have other pixels.</summary>
    /// <param name="first">Column of the first value.</param>
    public void Take(int row, int first, ReadOnlySpan<float> values)
    {
        if (IndexOf(row, Height) is >= 0 and int line)
        {
            values.CopyTo(Values.AsSpan((line * Width) + first));
        }

        foreach (int column in (ReadOnlySpan<int>)[0, Inwards, Width - 1 - Inwards, Width - 1])
        {
            if (column >= first && column < first + values.Length)
            {
                Values[IndexInColumn(row, IndexOf(column, Width))] = values[column - first];
            }
        }
    }

    /// <summary>The values of the next pixels of a row, as many as lie on the border; empty if the first one does not.</summary>
    /// <param name="column">The first.</param>
    /// <param name="most">At most so many.</param>
    public ReadOnlySpan<float> RunAt(int row, int column, int most) =>
        IndexOf(row, Height) is >= 0 and int line ? Values.AsSpan((line * Width) + column, Math.Min(most, Width - column))
        : IndexOf(column, Width) is >= 0 and int index ? Values.AsSpan(IndexInColumn(row, index), 1)
        : default;

    private int IndexInColumn(int row, int index) => (4 * Width) + (index * Height) + row;

    /// <summary>Which of the four rows or columns a place is; -1 for none.</summary>
    private static int IndexOf(int place, int count) =>
        place == 0 ? 0 : place == Inwards ? 1 : place == count - 1 - Inwards ? 2 : place == count - 1 ? 3 : -1;
}
