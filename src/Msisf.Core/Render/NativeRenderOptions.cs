using Msisf.Core.Render.Photometry;

namespace Msisf.Core.Render;

/// <summary>How the program's own renderer draws. Immutable.</summary>
public sealed record NativeRenderOptions
{
    /// <summary>The most samples along a pixel's edge: 256 samples a pixel.</summary>
    public const int MostSamplesAcross = 16;

    private readonly int _samplesAcross = 1;

    /// <summary>Law that turns angles into radiance.</summary>
    public required IReflectance Reflectance { get; init; }

    /// <summary>Point or disc.</summary>
    public SunModel Sun { get; init; } = SunModel.Point;

    /// <summary>Facet or smooth.</summary>
    public NormalModel Normals { get; init; } = NormalModel.Facet;

    /// <summary>Samples along a pixel's edge, 1 to <see cref="MostSamplesAcross"/>; their squares lie regularly in the pixel, and their mean is the pixel.</summary>
    public int SamplesAcross
    {
        get => _samplesAcross;
        init
        {
            ArgumentOutOfRangeException.ThrowIfLessThan(value, 1);
            ArgumentOutOfRangeException.ThrowIfGreaterThan(value, MostSamplesAcross);
            _samplesAcross = value;
        }
    }

    /// <summary>Whether the frame shall know what its pixels' centres show; a picture of an even number of samples has to look again for it.</summary>
    public bool KeepTruth { get; init; }
}
