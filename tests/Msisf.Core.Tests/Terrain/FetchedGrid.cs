using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Terrain;

/// <summary>Notes which samples of a model are fetched before they are read, and which are not. For one thread.</summary>
internal sealed class FetchedGrid(FunctionGrid grid) : IGlobalGrid
{
    private readonly HashSet<(int Line, int Sample)> _fetched = [];
    private readonly HashSet<(int Line, int Sample)> _read = [];

    public string ProductId => grid.ProductId;

    public int PixelsPerDegree => grid.PixelsPerDegree;

    /// <summary>Samples that were read.</summary>
    public int Read => _read.Count;

    /// <summary>Samples that were read without having been fetched.</summary>
    public int ReadUnfetched { get; private set; }

    /// <summary>Samples that were fetched and not read.</summary>
    public int FetchedInVain => _fetched.Except(_read).Count();

    public void Prefetch(int firstLine, int lines, int firstSample, int samples)
    {
        int width = 360 * PixelsPerDegree;
        Assert.InRange(firstLine, 0, (180 * PixelsPerDegree) - 1);
        Assert.InRange(lines, 1, (180 * PixelsPerDegree) - firstLine);
        Assert.InRange(firstSample, 0, width - 1);
        Assert.InRange(samples, 1, width);
        for (int line = firstLine; line < firstLine + lines; line++)
        {
            for (int sample = firstSample; sample < firstSample + samples; sample++)
            {
                _fetched.Add((line, sample % width));
            }
        }
    }

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        for (int i = 0; i < radii.Length; i++)
        {
            (int Line, int Sample) place = (line, (firstSample + i) % (360 * PixelsPerDegree));
            _read.Add(place);
            ReadUnfetched += _fetched.Contains(place) ? 0 : 1;
        }

        grid.ReadRadii(line, firstSample, radii);
    }
}
