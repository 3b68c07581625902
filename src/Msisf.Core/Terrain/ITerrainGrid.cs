using Msisf.Core.Errors;

namespace Msisf.Core.Terrain;

/// <summary>Radii of the Moon on a regular grid in a map projection, of all of it or of a part. Safe for several threads.</summary>
public interface ITerrainGrid
{
    /// <summary>The product's name, e.g. "LDEM_4" or "LDEM_80S_20M".</summary>
    string ProductId { get; }

    /// <summary>Where the samples lie.</summary>
    MapProjection Projection { get; }

    /// <summary>Number of lines of the whole grid.</summary>
    int Lines { get; }

    /// <summary>Number of samples of a line of the whole grid.</summary>
    int Samples { get; }

    /// <summary>The part of the grid that the model has.</summary>
    GridWindow Window => new(0, Lines, 0, Samples);

    /// <summary>m: radius of the sphere over which heights are counted; that of the Moon unless the model is of another body.</summary>
    double ReferenceRadius => MoonConstants.ReferenceRadius;

    /// <summary>
    /// Minimum and maximum radius that samples can have, m, known without reading any. The default is the maximum relief of the Moon.
    /// </summary>
    (double Min, double Max) RadiusLimits => (ReferenceRadius - MoonConstants.MaxRelief, ReferenceRadius + MoonConstants.MaxRelief);

    /// <summary>Radii of consecutive samples of one line.</summary>
    /// <param name="line">0 to <see cref="Lines"/> - 1, from the top; within the window.</param>
    /// <param name="firstSample">
    /// 0 to <see cref="Samples"/> - 1; the samples of a model of the whole Moon continue across the prime meridian.
    /// </param>
    /// <param name="radii">Filled with m from the Moon's centre; 1 to <see cref="Samples"/> of them.</param>
    /// <exception cref="BadInputException">A sample can't be right: the file is damaged.</exception>
    void ReadRadii(int line, int firstSample, Span<double> radii);

    /// <summary>Minimum and maximum radius of a block of samples, m.</summary>
    /// <param name="firstLine">Top line.</param>
    /// <param name="lines">How many lines.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    /// <param name="samples">How many samples; the block of a model of the whole Moon continues across the prime meridian.</param>
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
