using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Makes the coarser levels of a raster while its pixels are looked at, band by band from the top.</summary>
/// <param name="Map">The raster, no sample of which is read.</param>
/// <param name="File">Receives the levels; null for nobody.</param>
/// <param name="FirstLevel">The finest of them.</param>
internal sealed record RasterLevels(RasterPart Map, PyramidRows? File, int FirstLevel)
{
    /// <summary>px: height of a band; a strip's width is a multiple of it.</summary>
    public int Step { get; } = File is null ? LeastStep : Math.Max(LeastStep, LodLayout.Side << FirstLevel);

    private const int LeastStep = 512;

    /// <summary>Begins a band.</summary>
    /// <param name="line">Its first line.</param>
    public void Begin(int line, int lines)
    {
        foreach (int row in Rows(line, lines))
        {
            File!.Finest.Begin(row);
        }
    }

    /// <summary>Reduces a part of a band. Several threads may do so at once.</summary>
    /// <param name="part">Where it lies: at whole blocks, or the end of the map.</param>
    /// <param name="values">The stored values, row by row.</param>
    /// <param name="hasGaps">Whether any of them is without data.</param>
    public void Reduce(GridWindow part, Memory<float> values, bool hasGaps)
    {
        if (File is null)
        {
            return;
        }

        BlockReducer reducer = new(Map.With(part, values, hasGaps), FirstLevel, keepsGaps: true);
        int last = File.Finest.ColumnOf(part.EndSample - 1, FirstLevel);
        foreach (int row in Rows(part.FirstLine, part.Lines))
        {
            for (int column = File.Finest.ColumnOf(part.FirstSample, FirstLevel); column <= last; column++)
            {
                reducer.Reduce(row, column, File.Finest.Block(row, column));
            }
        }
    }

    /// <summary>Writes a band all parts of which are reduced.</summary>
    /// <param name="line">Its first line.</param>
    public void Write(int line, int lines)
    {
        foreach (int row in Rows(line, lines))
        {
            File!.Write(row);
        }
    }

    /// <summary>The rows of blocks of a band.</summary>
    private IEnumerable<int> Rows(int line, int lines)
    {
        int first = File?.Finest.RowOf(line, FirstLevel) ?? 0;
        return Enumerable.Range(first, File is null ? 0 : File.Finest.RowOf(line + lines - 1, FirstLevel) - first + 1);
    }
}
