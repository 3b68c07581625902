using Msisf.Core.Render.Photometry;

namespace Msisf.Core.Render.Options;

/// <summary>
/// More samples where they matter: in pixels in which facets, silhouettes or borders of shadows of differing brightness meet.
/// </summary>
public sealed class AdaptiveSampling
{
    /// <summary>Levels of 255: the smallest error that may be asked for.</summary>
    public const double MinError = 0.05;

    /// <summary>Levels of 255: the largest error that may be asked for.</summary>
    public const double MaxError = 50.0;

    /// <summary>Levels of 255: about the error of 16 samples in every pixel, seen from near (docs/native-renderer.md).</summary>
    public const double DefaultError = 0.4;

    /// <summary>Samples along a pixel's edge for the choice of the level of detail.</summary>
    public const int SubsamplesPerAxis = 4;

    /// <summary>Bits of the levels from which contrasts are computed.</summary>
    private const int LevelBits = 16;

    /// <summary>Takes the error and the grey levels in which it is meant.</summary>
    /// <param name="error">Root mean square error against 64 samples in every pixel, in levels of 255.</param>
    /// <param name="grey">From radiance factors to grey levels.</param>
    /// <exception cref="Errors.BadInputException">The error is out of range.</exception>
    public AdaptiveSampling(double error, GreyScale grey)
    {
        Error = Guard.InRange(error, MinError, MaxError, "error of the samples");
        Grey = new GreyTable(grey, LevelBits);
    }

    /// <summary>Root mean square error against 64 samples in every pixel, in levels of 255.</summary>
    public double Error { get; }

    /// <summary>From radiance factors to levels of 65535.</summary>
    internal GreyTable Grey { get; }
}
