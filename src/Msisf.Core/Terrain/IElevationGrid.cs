using Msisf.Core.Errors;

namespace Msisf.Core.Terrain;

/// <summary>
/// A whole Moon of radii on a regular latitude-longitude grid, pixel registered: line i (0 northernmost) lies at latitude
/// 90 - (i + 0.5) / res degrees, sample j (0 westernmost) at longitude (j + 0.5) / res degrees. Safe for several threads.
/// </summary>
public interface IElevationGrid
{
    /// <summary>The product's name, e.g. "LDEM_4".</summary>
    string ProductId { get; }

    /// <summary>Samples a degree.</summary>
    int PixelsPerDegree { get; }

    /// <summary>
    /// Minimum and maximum radius that samples can have, m, known without reading any. The default is the maximum relief of the Moon.
    /// </summary>
    (double Min, double Max) RadiusLimits =>
        (MoonConstants.ReferenceRadius - MoonConstants.MaxRelief, MoonConstants.ReferenceRadius + MoonConstants.MaxRelief);

    /// <summary>Radii of consecutive samples of one line.</summary>
    /// <param name="line">0 to 180 res - 1, northernmost first.</param>
    /// <param name="firstSample">0 to 360 res - 1; the samples continue across the prime meridian.</param>
    /// <param name="radii">Filled with m from the Moon's centre; 1 to 360 res of them.</param>
    /// <exception cref="BadInputException">A sample can't be right: the file is damaged.</exception>
    void ReadRadii(int line, int firstSample, Span<double> radii);

    /// <summary>Minimum and maximum radius of a block of samples, m.</summary>
    /// <param name="firstLine">Northernmost line.</param>
    /// <param name="lines">How many lines.</param>
    /// <param name="firstSample">Westernmost sample.</param>
    /// <param name="samples">How many samples; the block continues across the prime meridian.</param>
    /// <exception cref="BadInputException">A sample of the block can't be right: the file is damaged.</exception>
    (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples);

    /// <summary>
    /// Tells the grid that most of the samples read so far are not needed again soon, so that their memory may be released. Reading is
    /// still possible.
    /// </summary>
    void ReleasePages()
    {
    }
}
