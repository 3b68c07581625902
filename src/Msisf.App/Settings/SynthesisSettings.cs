using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.App.Settings;

/// <summary>Describes the synthetic elevation model to make.</summary>
/// <param name="PixelsPerDegree">Resolution of a model of latitude and longitude, px/deg; 0 for a polar map.</param>
/// <param name="Seed">Seed of the random terrain.</param>
/// <param name="BaseModel">Label or image of the model that it continues to smaller scales; null for an invented Moon.</param>
/// <param name="Region">Part of the Moon that gets the detail.</param>
/// <param name="Rest">What lies outside the region.</param>
/// <param name="SampleType">How samples are stored; null for the default of the resolution.</param>
/// <param name="Unattended">Whether to draw no progress bar.</param>
internal sealed record SynthesisSettings(
    int PixelsPerDegree,
    ulong Seed,
    string? BaseModel,
    MoonRegion Region,
    SyntheticRest Rest,
    LdemSampleType? SampleType,
    string Folder,
    bool Unattended)
{
    /// <summary>The polar map to make; null for a model of latitude and longitude.</summary>
    public SyntheticMapSettings? Map { get; init; }

    public CelestialBody Body { get; init; } = CelestialBody.Moon;
}

/// <summary>Describes a synthetic polar map to make.</summary>
/// <param name="IsSouth">Whether it is of the south pole.</param>
/// <param name="MetresPerPixel">Map scale, m.</param>
/// <param name="LatitudeDegrees">Absolute latitude of the middle of the map's sides.</param>
internal sealed record SyntheticMapSettings(bool IsSouth, double MetresPerPixel, double LatitudeDegrees);
