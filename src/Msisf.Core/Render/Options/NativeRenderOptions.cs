using Msisf.Core.Render.Photometry;

namespace Msisf.Core.Render.Options;

/// <summary>Settings of the program's own renderer. Immutable.</summary>
public sealed record NativeRenderOptions
{
    /// <summary>Maximum number of samples along a pixel's edge: 16 x 16 = 256 samples per pixel.</summary>
    public const int MaxSubsamplesPerAxis = 16;

    private readonly int _subsamplesPerAxis = 1;

    /// <summary>Reflectance law, which gives the radiance factor from the angles of light and view.</summary>
    public required IReflectance Reflectance { get; init; }

    /// <summary>Map by which the law's radiance factors are scaled; null for the law alone.</summary>
    public AlbedoMap? Albedo { get; init; }

    /// <summary>Maps of parts of the Moon that count before <see cref="Albedo"/> where they have data, the finest last.</summary>
    public IReadOnlyList<AlbedoMap> AlbedoSites { get; init; } = [];

    /// <summary>Whether there is a map of the reflectance.</summary>
    public bool HasMap => Albedo is not null || AlbedoSites.Count > 0;

    /// <summary>Hapke's parameters by place, which then replace <see cref="Reflectance"/>; null for the same law everywhere.</summary>
    public HapkeMap? Hapke { get; init; }

    /// <summary>Whether the Sun is a point or a disc.</summary>
    public SunModel Sun { get; init; } = SunModel.Point;

    /// <summary>Whether facet normals or smooth normals shade the surface.</summary>
    public NormalModel Normals { get; init; } = NormalModel.Facet;

    /// <summary>
    /// Number of samples along a pixel's edge, 1 to <see cref="MaxSubsamplesPerAxis"/>. The square of this number of samples lies on a
    /// regular grid in the pixel, and the pixel's value is their mean.
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
    /// More samples where they matter, instead of as many in each pixel; null for these. With it <see cref="SubsamplesPerAxis"/> is 1.
    /// </summary>
    public AdaptiveSampling? Adaptive { get; init; }

    /// <summary>The light that ground throws on ground; null for the Sun's alone.</summary>
    public IndirectLight? Indirect { get; init; }

    /// <summary>A light beside the Sun; null for none.</summary>
    public SecondLight? Second { get; init; }

    /// <summary>
    /// Is told, from any thread, which part of a frame's light from the ground is done, from 0 to 1; null for nobody. The first samples
    /// show how many more are needed: until then the part is a guess.
    /// </summary>
    public IProgress<double>? Progress { get; init; }

    /// <summary>Samples along a pixel's edge for which the level of detail is chosen.</summary>
    public int DetailSubsamplesPerAxis => Adaptive is null ? SubsamplesPerAxis : AdaptiveSampling.SubsamplesPerAxis;

    /// <summary>
    /// Whether the frame keeps the ground truth of its pixels' centres. With an even number of samples along a pixel's edge this takes one
    /// more pass.
    /// </summary>
    public bool KeepGroundTruth { get; init; }
}

/// <summary>The normal with which a point of a facet is shaded. The point and its shadow always belong to the facet itself.</summary>
public enum NormalModel
{
    /// <summary>The normal of the facet.</summary>
    Facet,

    /// <summary>A normal interpolated between those of the surrounding samples, so that edges between facets are not visible.</summary>
    Smooth,
}

/// <summary>How the renderer models the Sun.</summary>
public enum SunModel
{
    /// <summary>A point at the Sun's centre: shadows have sharp borders, as in POV-Ray's scene.</summary>
    Point,

    /// <summary>A disc of the Sun's true angular size: shadows have penumbras.</summary>
    Disc,
}
