using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>The format of a sample (SAMPLE_TYPE and SAMPLE_BITS of the label).</summary>
public enum LdemSampleType
{
    /// <summary>LSB_INTEGER, 16 bits: NASA's IMG products.</summary>
    Int16LittleEndian,

    /// <summary>MSB_INTEGER, 16 bits.</summary>
    Int16BigEndian,

    /// <summary>PC_REAL, 32 bits: NASA's FLOAT_IMG products.</summary>
    Float32LittleEndian,

    /// <summary>IEEE_REAL, 32 bits.</summary>
    Float32BigEndian,
}

/// <summary>
/// The values of a lunar elevation model's label, checked for consistency. The model may cover a part of the Moon only.
/// </summary>
/// <param name="ImagePath">Path of the image; the label's own for an attached label.</param>
/// <param name="ImageOffset">Bytes of the image's file before the first sample.</param>
/// <param name="ProductId">PRODUCT_ID, e.g. "LDEM_4": letters, digits, '_', '-' and '.'.</param>
/// <param name="Body">TARGET_NAME: the body.</param>
/// <param name="PixelsPerDegree">MAP_RESOLUTION of a cylindrical model: samples a degree; 0 for a polar map.</param>
/// <param name="SampleType">SAMPLE_TYPE with SAMPLE_BITS.</param>
/// <param name="ScalingFactor">SCALING_FACTOR, turned into m a step.</param>
/// <param name="Offset">OFFSET, turned into m: the radius that sample value 0 means.</param>
/// <param name="Minimum">MINIMUM, or the least plausible height if that is more: no sample value is below.</param>
/// <param name="Maximum">MAXIMUM, or the greatest plausible height if that is less: no sample value is above.</param>
/// <param name="FileBytes">Bytes that the image's file must have; null if the label names no number of records.</param>
/// <param name="Polar">The projection of a polar map; null for a cylindrical model.</param>
/// <param name="NorthDegrees">MAXIMUM_LATITUDE, degrees: of a cylindrical model the northern border of line 1.</param>
/// <param name="SouthDegrees">MINIMUM_LATITUDE, degrees.</param>
/// <param name="WestDegrees">
/// WESTERNMOST_LONGITUDE, degrees: of a cylindrical model the western border of sample 1, 0 to 360.
/// </param>
/// <param name="EastDegrees">EASTERNMOST_LONGITUDE, degrees; above the western border.</param>
/// <param name="CoordinateSystem">COORDINATE_SYSTEM_NAME.</param>
public sealed record LdemLabel(
    string LabelPath, string ImagePath, long ImageOffset, string ProductId, CelestialBody Body, int PixelsPerDegree, int Lines,
    int LineSamples, LdemSampleType SampleType, double ScalingFactor, double Offset, double Minimum, double Maximum,
    long? FileBytes = null, PolarStereographic? Polar = null, double NorthDegrees = double.NaN, double SouthDegrees = double.NaN,
    double WestDegrees = double.NaN, double EastDegrees = double.NaN, string CoordinateSystem = "")
{
    /// <summary>Stands in every name and label of a synthetic product.</summary>
    public const string SyntheticMark = "SYNTHETIC";

    /// <summary>
    /// Whether samples may have no data: the label limits them to no plausible heights, or declares a value for missing ones.
    /// </summary>
    public bool MayHaveGaps { get; init; }

    /// <summary>MISSING_CONSTANT or a synonym: the sample value that the label declares as no data; null if there is none.</summary>
    public double? Missing { get; init; }

    /// <summary>Other files with samples, of a raster that names them, such as a VRT.</summary>
    public IReadOnlyList<string> OtherFiles { get; init; } = [];

    /// <summary>Whether this is a synthetic product (docs/elevation-models.md).</summary>
    public bool IsSynthetic => ProductId.Contains(SyntheticMark, StringComparison.Ordinal);

    /// <summary>The samples are 16-bit integers.</summary>
    public bool HasIntegers => SampleType is LdemSampleType.Int16LittleEndian or LdemSampleType.Int16BigEndian;

    /// <summary>m: the limits of all radii. Floats may exceed the printed MINIMUM and MAXIMUM a little.</summary>
    public (double Min, double Max) RadiusLimits =>
        (Offset + (ScalingFactor * (Minimum - Slack)), Offset + (ScalingFactor * (Maximum + Slack)));

    /// <summary>By how much a sample value may be outside the limits.</summary>
    internal double Slack => HasIntegers ? 0.0 : Tolerances.FloatSampleLimits * (Maximum - Minimum);

    /// <summary>m: radius of the sphere of the heights: LOLA's for the Moon, whatever OFFSET is, otherwise that of the label.</summary>
    public double ReferenceRadius => Body.IsMoon ? MoonConstants.ReferenceRadius : Offset;

    /// <summary>Bytes of a sample.</summary>
    public int SampleBytes => HasIntegers ? sizeof(short) : sizeof(float);

    /// <summary>Bytes of a line.</summary>
    public long LineBytes => (long)LineSamples * SampleBytes;

    /// <summary>Bytes of all samples.</summary>
    public long ImageBytes => LineBytes * Lines;

    /// <summary>Whether it covers latitudes -90 to 90 and all longitudes, from whichever on.</summary>
    public bool CoversWholeMoon =>
        Polar is null && (NorthDegrees, SouthDegrees, EastDegrees - WestDegrees) == (90.0, -90.0, 360.0);

    /// <summary>The same label with a western border from 0 on; the eastern one lies beyond 360 if the prime meridian is inside.</summary>
    internal LdemLabel FromPrimeMeridian()
    {
        double turned = 360.0 * Math.Floor(WestDegrees / 360.0);
        return this with { WestDegrees = WestDegrees - turned, EastDegrees = EastDegrees - turned };
    }
}
