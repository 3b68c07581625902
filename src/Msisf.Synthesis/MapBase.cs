namespace Msisf.Synthesis;

/// <summary>The base model between two latitudes, interpolated at any place as <see cref="BaseSurface"/> does at samples.</summary>
internal sealed class MapBase
{
    private const int Reach = PixelMeanKernel.Reach;

    private readonly int _pixelsPerDegree;
    private readonly int _firstLine;
    private readonly MeanSpline _spline;

    /// <summary>Reads the base's lines, all around the Moon.</summary>
    /// <param name="terrain">The ground.</param>
    /// <param name="southDegrees">Southernmost latitude.</param>
    /// <param name="northDegrees">Northernmost latitude.</param>
    public MapBase(SyntheticTerrain terrain, double southDegrees, double northDegrees)
    {
        _pixelsPerDegree = terrain.Base.PixelsPerDegree;
        int around = 360 * _pixelsPerDegree;
        _firstLine = LineOf(northDegrees);
        int lines = LineOf(southDegrees) - _firstLine + 1;
        int all = around + (2 * Reach);
        double[] means = new double[(lines + (2 * Reach)) * all];
        for (int line = 0; line < lines + (2 * Reach); line++)
        {
            Span<double> own = means.AsSpan(line * all, all);
            terrain.Base.ReadHeights(_firstLine - Reach + line, 0, own.Slice(Reach, around));
            own.Slice(around, Reach).CopyTo(own);
            own.Slice(Reach, Reach).CopyTo(own[(around + Reach)..]);
        }

        _spline = new MeanSpline(means, lines, around, terrain.Kernel);
    }

    /// <summary>Height at a place, m over the reference radius.</summary>
    /// <param name="latitudeDegrees">Between the latitudes that were read.</param>
    /// <param name="longitudeDegrees">[0, 360).</param>
    public double HeightAt(double latitudeDegrees, double longitudeDegrees) =>
        _spline.HeightAt(((90.0 - latitudeDegrees) * _pixelsPerDegree) - _firstLine, longitudeDegrees * _pixelsPerDegree);

    private int LineOf(double latitudeDegrees) =>
        Math.Clamp((int)Math.Floor((90.0 - latitudeDegrees) * _pixelsPerDegree), 0, (180 * _pixelsPerDegree) - 1);
}
