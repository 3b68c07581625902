using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// The order of models in a scene of several, which does not depend on the order in which they are given, or on their files' names and
/// folders: the coarsest first; of models with the same resolution their places and heights decide.
/// </summary>
internal sealed class ModelOrder : IComparer<ITerrainGrid>
{
    /// <inheritdoc/>
    public int Compare(ITerrainGrid? x, ITerrainGrid? y)
    {
        ArgumentNullException.ThrowIfNull(x);
        ArgumentNullException.ThrowIfNull(y);
        int order = y.Projection.Resolution.MetresPerPixel.CompareTo(x.Projection.Resolution.MetresPerPixel);
        return order != 0 ? order : ComparePlaces(x, y);
    }

    private static int ComparePlaces(ITerrainGrid x, ITerrainGrid y)
    {
        int order = PlaceOf(x).CompareTo(PlaceOf(y));
        return order != 0 || ReferenceEquals(x, y) ? order : CompareHeights(x, y);
    }

    /// <summary>The window, and the direction of its first sample, which tells projections apart.</summary>
    private static (int, int, int, int, double, double, double) PlaceOf(ITerrainGrid grid)
    {
        GridWindow window = grid.Window;
        Vector3D first = grid.Projection.DirectionOf(window.FirstLine, window.FirstSample);
        return (window.FirstLine, window.FirstSample, window.EndLine, window.EndSample, first.X, first.Y, first.Z);
    }

    /// <summary>Reads both until they differ: other models do so in their first line, as a rule.</summary>
    private static int CompareHeights(ITerrainGrid x, ITerrainGrid y)
    {
        GridWindow window = x.Window;
        (double[] first, double[] second) = (new double[window.Samples], new double[window.Samples]);
        int order = 0;
        for (int line = window.FirstLine; line < window.EndLine && order == 0; line++)
        {
            Read(x, line, first);
            Read(y, line, second);
            order = first.AsSpan().SequenceCompareTo(second);
        }

        return order;
    }

    /// <summary>Radii of a line of the window; 0 without data.</summary>
    private static void Read(ITerrainGrid grid, int line, double[] radii)
    {
        int from = grid.Window.FirstSample;
        bool[] gaps = new bool[radii.Length];
        if (grid.MayHaveGaps)
        {
            grid.ReadGaps(line, from, gaps);
        }

        for (int start = 0; start < radii.Length;)
        {
            int length = gaps.AsSpan(start).IndexOf(!gaps[start]);
            Span<double> run = radii.AsSpan(start, length < 0 ? radii.Length - start : length);
            if (gaps[start])
            {
                run.Clear();
            }
            else
            {
                grid.ReadRadii(line, from + start, run);
            }

            start += run.Length;
        }
    }
}
