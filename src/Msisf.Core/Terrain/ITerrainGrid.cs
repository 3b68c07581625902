namespace Msisf.Core.Terrain;

/// <summary>Radii of the Moon on a regular grid in a map projection, of all of it or of a part. Safe for several threads.</summary>
public interface ITerrainGrid : ITerrain
{
    /// <inheritdoc/>
    GridResolution ITerrain.Resolution => Projection.Resolution;

    /// <inheritdoc/>
    IReadOnlyList<ITerrainGrid> ITerrain.Models => [this];

    /// <inheritdoc/>
    bool ITerrain.IsWholeBody => false;

    /// <summary>Where the samples lie.</summary>
    MapProjection Projection { get; }

    /// <summary>Number of lines of the whole grid.</summary>
    int Lines { get; }

    /// <summary>Number of samples of a line of the whole grid.</summary>
    int Samples { get; }

    /// <summary>The part of the grid that the model has.</summary>
    GridWindow Window => new(0, Lines, 0, Samples);

    /// <summary>Whether a sample is the mean of its cell, as in LOLA's gridded products, and not the height in the cell's middle.</summary>
    bool HoldsMeans => false;

    /// <summary>Whether samples may be without data (<see cref="ReadGaps"/>).</summary>
    bool MayHaveGaps => false;

    /// <summary>
    /// Coarser levels of the model that were computed before, finest first, each half as fine as the one before, as levels of maps are
    /// computed that keep places without data.
    /// </summary>
    IReadOnlyList<ITerrainGrid> StoredLevels => [];

    /// <summary>Tells which of consecutive samples of one line have no data; parameters as of <see cref="ReadRadii"/>.</summary>
    /// <param name="isGap">Receives whether a sample has no data.</param>
    void ReadGaps(int line, int firstSample, Span<bool> isGap) => isGap.Clear();

    /// <summary>Radii of consecutive samples of one line.</summary>
    /// <param name="line">0 to <see cref="Lines"/> - 1, from the top; within the window.</param>
    /// <param name="firstSample">
    /// 0 to <see cref="Samples"/> - 1, or within the window; the samples of a model of the whole Moon continue across the prime meridian.
    /// </param>
    /// <param name="radii">Filled with m from the Moon's centre; 1 to <see cref="Samples"/> of them.</param>
    /// <exception cref="BadInputException">A sample has no data, or can't be right: the file is damaged.</exception>
    void ReadRadii(int line, int firstSample, Span<double> radii);

    /// <summary>
    /// Whether any sample of a block may be without data; if false, it need not be looked at sample by sample.
    /// </summary>
    /// <param name="firstLine">Top line.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    bool MayHaveGapsIn(int firstLine, int lines, int firstSample, int samples) => MayHaveGaps;

    /// <summary>Whether the height of a sample with data was changed to meet other models.</summary>
    bool IsBlended(int line, int sample) => false;

    /// <summary>
    /// Bounds of a block of samples that are known without reading it; null if none are. The samples may have less extreme values.
    /// </summary>
    /// <param name="firstLine">Top line.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    KnownBounds? BoundsOf(int firstLine, int lines, int firstSample, int samples) => null;

    /// <summary>
    /// Tells that a block of samples is read next, so that a file which nobody has read yet is fetched there, and only there. It changes
    /// nothing but the time that reading takes.
    /// </summary>
    /// <param name="firstLine">Top line.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    /// <param name="samples">How many samples; the block of a model of the whole Moon continues across the prime meridian.</param>
    void Prefetch(int firstLine, int lines, int firstSample, int samples)
    {
    }
}

/// <summary>Bounds of a block of samples.</summary>
/// <param name="Min">m: no radius is below.</param>
/// <param name="Max">m: no radius is above.</param>
/// <param name="Step">m: no two neighbouring samples of a line, or of two lines, differ by more.</param>
public readonly record struct KnownBounds(double Min, double Max, double Step);

/// <summary>
/// The part of a grid for which a model has samples. Samples of a map across the prime meridian count on there, beyond the grid's.
/// </summary>
/// <param name="FirstLine">Its top line.</param>
/// <param name="EndLine">The line below its last one.</param>
/// <param name="FirstSample">Its leftmost sample.</param>
/// <param name="EndSample">The sample to the right of its last one.</param>
public readonly record struct GridWindow(int FirstLine, int EndLine, int FirstSample, int EndSample)
{
    /// <summary>Number of lines.</summary>
    public int Lines => EndLine - FirstLine;

    /// <summary>Number of samples of a line.</summary>
    public int Samples => EndSample - FirstSample;

    /// <summary>
    /// The same part of the grid in which a sample stands for 2 x 2 of this one; it reaches as far as the samples that stand for any of
    /// this window's.
    /// </summary>
    public GridWindow Halved() => new(FirstLine >> 1, (EndLine + 1) >> 1, FirstSample >> 1, (EndSample + 1) >> 1);
}
