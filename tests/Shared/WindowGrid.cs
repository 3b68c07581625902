using Msisf.Core.Terrain;

namespace Msisf.TestSupport;

/// <summary>A part of a model of the whole Moon; asking for other samples is an error.</summary>
internal sealed class WindowGrid(IGlobalGrid moon, GridWindow window) : ITerrainGrid
{
    public string ProductId => "TEST_WINDOW";

    public MapProjection Projection => moon.Projection;

    public int Lines => moon.Lines;

    public int Samples => moon.Samples;

    public GridWindow Window => window;

    public (double Min, double Max) RadiusLimits => moon.RadiusLimits;

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(line, window.FirstLine);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(line, window.EndLine);
        if (window.Samples < moon.Samples)
        {
            ArgumentOutOfRangeException.ThrowIfLessThan(firstSample, window.FirstSample);
            ArgumentOutOfRangeException.ThrowIfGreaterThan(firstSample + radii.Length, window.EndSample);
        }

        moon.ReadRadii(line, firstSample % moon.Samples, radii); // of a window across the prime meridian they count on
    }
}
