using Msisf.Core.Render.Photometry;

namespace Msisf.Core.Render;

/// <summary>How the program's own renderer draws. Immutable.</summary>
public sealed record NativeRenderOptions
{
    /// <summary>The most samples along a pixel's edge: 256 samples a pixel.</summary>
    public const int MaxSubsamplesPerAxis = 16;

    private readonly int _subsamplesPerAxis = 1;

    /// <summary>Law that turns angles into radiance.</summary>
    public required IReflectance Reflectance { get; init; }

    /// <summary>Point or disc.</summary>
    public SunModel Sun { get; init; } = SunModel.Point;

    /// <summary>Facet or smooth.</summary>
    public NormalModel Normals { get; init; } = NormalModel.Facet;

    /// <summary>
    /// Samples along a pixel's edge, 1 to <see cref="MaxSubsamplesPerAxis"/>; their squares lie regularly in the pixel, and their mean is
    /// the pixel.
    /// </summary>
    public int SubsamplesPerAxis
    {
        get => _subsamplesPerAxis;
        init
        {
            ArgumentOutOfRangeException.ThrowIfLessThan(value, 1);
            ArgumentOutOfRangeException.ThrowIfGreaterThan(value, MaxSubsamplesPerAxis);
            _subsamplesPerAxis = value;
        }
    }

    /// <summary>
    /// Whether the frame shall know what its pixels' centres show; an image of an even number of samples has to look again for it.
    /// </summary>
    public bool KeepGroundTruth { get; init; }
}
