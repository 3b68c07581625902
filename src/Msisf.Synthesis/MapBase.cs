namespace Msisf.Synthesis;

/// <summary>The base model between two latitudes, interpolated at any place as <see cref="BaseSurface"/> does at samples.</summary>
internal sealed class MapBase
{
    private const int Reach = PixelMeanKernel.Reach;

    private readonly int _pixelsPerDegree;
    private readonly int _firstLine;
    private readonly int _width;
    private readonly double[] _coefficients;

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
        double[] means = new double[around + (2 * Reach)];
        _width = PixelMeanKernel.CoefficientCount(around);
        double[] halfDone = new double[(lines + (2 * Reach)) * _width];
        for (int line = 0; line < lines + (2 * Reach); line++)
        {
            terrain.Base.ReadHeights(_firstLine - Reach + line, 0, means.AsSpan(Reach, around));
            means.AsSpan(around, Reach).CopyTo(means);
            means.AsSpan(Reach, Reach).CopyTo(means.AsSpan(around + Reach));
            terrain.Kernel.Coefficients(means, halfDone.AsSpan(line * _width, _width), around, step: 1);
        }

        _coefficients = new double[PixelMeanKernel.CoefficientCount(lines) * _width];
        for (int column = 0; column < _width; column++)
        {
            terrain.Kernel.Coefficients(halfDone.AsSpan(column), _coefficients.AsSpan(column), lines, _width);
        }
    }

    /// <summary>Height at a place, m over the reference radius.</summary>
    /// <param name="latitudeDegrees">Between the latitudes that were read.</param>
    /// <param name="longitudeDegrees">[0, 360).</param>
    public double HeightAt(double latitudeDegrees, double longitudeDegrees)
    {
        (int line, double north, double middle, double south) =
            PixelMeanKernel.At(((90.0 - latitudeDegrees) * _pixelsPerDegree) - _firstLine);
        (int column, double w0, double w1, double w2) = PixelMeanKernel.At(longitudeDegrees * _pixelsPerDegree);
        ReadOnlySpan<double> rows = _coefficients.AsSpan(line * _width);
        return (w0 * Along(rows, column)) + (w1 * Along(rows, column + 1)) + (w2 * Along(rows, column + 2));

        double Along(ReadOnlySpan<double> values, int at) =>
            (north * values[at]) + (middle * values[at + _width]) + (south * values[at + (2 * _width)]);
    }

    private int LineOf(double latitudeDegrees) =>
        Math.Clamp((int)Math.Floor((90.0 - latitudeDegrees) * _pixelsPerDegree), 0, (180 * _pixelsPerDegree) - 1);
}
