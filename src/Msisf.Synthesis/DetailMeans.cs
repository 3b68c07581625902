using Msisf.Core.Numerics;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>Means of the invented detail over the cells of a model, and the smooth ground whose means over the cells are given.</summary>
internal static class DetailMeans
{
    /// <summary>
    /// Samples along a side of a cell at least, if narrower cells are drawn: what is too small for them has a mean near 0.
    /// </summary>
    private const double SamplesASide = 48.0;

    /// <summary>Cells: by which a place may be taken for its neighbour.</summary>
    private const double MostShiftInCells = 1e-3;

    /// <summary>m: width of the cells in which a mean is computed that is the same for all narrower ones.</summary>
    public static double CellFor(double spacing, double cell) =>
        Math.Max(cell, Math.ScaleB(1.0, (int)Math.Floor(Math.Log2(spacing / SamplesASide))));

    /// <summary>Mean of the detail over a cell, m.</summary>
    /// <param name="model">The model.</param>
    /// <param name="maria">Where the ground is smoother.</param>
    /// <param name="layer">The detail in cells of that width.</param>
    /// <param name="cell">m: their width, a power of two.</param>
    /// <param name="line">The model's line.</param>
    /// <param name="sample">Its sample.</param>
    public static double Of(ITerrainGrid model, MareMask maria, DetailLayer layer, double cell, int line, int sample)
    {
        PolarStereographic map = LatticeFace.Of(model.Projection.DirectionOf(line, sample)).Map((int)Math.Round(Math.Log2(cell)));
        (double top, double bottom, double left, double right) = (1e300, -1e300, 1e300, -1e300);
        foreach ((double down, double across) in ((double, double)[])[(-0.5, -0.5), (-0.5, 0.5), (0.5, -0.5), (0.5, 0.5)])
        {
            (double y, double x) = map.PixelOf(model.Projection.DirectionOf(line + down, sample + across));
            (top, bottom) = (Math.Min(top, y), Math.Max(bottom, y));
            (left, right) = (Math.Min(left, x), Math.Max(right, x));
        }

        (int firstLine, int firstSample) = ((int)Math.Floor(top), (int)Math.Floor(left));
        int side = Math.Max((int)Math.Ceiling(bottom) - firstLine, (int)Math.Ceiling(right) - firstSample) + 1;
        side = (side + MapFrame.WholeSteps - 1) / MapFrame.WholeSteps * MapFrame.WholeSteps;
        MapFrame frame = new(map, firstLine, side, firstSample, side, MostShiftInCells * cell);
        float[] fractions = new float[frame.X.Length];
        float[] heights = new float[frame.X.Length];
        maria.Fill(frame, fractions);
        layer.AddTo(frame, fractions, heights);
        (double sum, int count) = (0.0, 0);
        for (int i = 0; i < heights.Length; i++)
        {
            (double y, double x) = PixelOf(model, frame, i);
            x -= model.Projection is Equirectangular ? Math.Round((x - sample) / model.Samples) * model.Samples : 0.0;
            if (Math.Abs(y - line) <= 0.5 && Math.Abs(x - sample) <= 0.5)
            {
                sum += heights[i];
                count++;
            }
        }

        return count == 0 ? heights[((side / 2) * frame.Stride) + (side / 2)] : sum / count;
    }

    /// <summary>Heights of the smooth ground at places.</summary>
    /// <param name="means">Means of its cells line by line, with <see cref="PixelMeanKernel.Reach"/> more on each side.</param>
    /// <param name="lines">Lines, without the additional ones.</param>
    /// <param name="samples">Samples of a line, without the additional ones.</param>
    /// <param name="kernel">The weights.</param>
    public static Func<double, double, double> Spline(double[] means, int lines, int samples, PixelMeanKernel kernel)
    {
        int all = samples + (2 * PixelMeanKernel.Reach);
        int width = PixelMeanKernel.CoefficientCount(samples);
        double[] across = new double[(lines + (2 * PixelMeanKernel.Reach)) * width];
        for (int line = 0; line < lines + (2 * PixelMeanKernel.Reach); line++)
        {
            kernel.Coefficients(means.AsSpan(line * all, all), across.AsSpan(line * width, width), samples, step: 1);
        }

        double[] coefficients = new double[PixelMeanKernel.CoefficientCount(lines) * width];
        for (int column = 0; column < width; column++)
        {
            kernel.Coefficients(across.AsSpan(column), coefficients.AsSpan(column), lines, width);
        }

        return HeightAt;

        double HeightAt(double down, double right)
        {
            (int row, double north, double middle, double south) = PixelMeanKernel.At(down);
            (int column, double west, double centre, double east) = PixelMeanKernel.At(right);
            int at = (row * width) + column;
            return (north * Along(at)) + (middle * Along(at + width)) + (south * Along(at + (2 * width)));

            double Along(int first) =>
                (west * coefficients[first]) + (centre * coefficients[first + 1]) + (east * coefficients[first + 2]);
        }
    }

    private static (double Line, double Sample) PixelOf(ITerrainGrid model, MapFrame frame, int index) =>
        model.Projection is Equirectangular(var perDegree)
            ? (((90.0 - frame.Latitudes[index]) * perDegree) - 0.5, (frame.Longitudes[index] * perDegree) - 0.5)
            : model.Projection.PixelOf(new Vector3D(frame.X[index], frame.Y[index], frame.Z[index]));
}
