using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// The values of a lunar elevation model's label, checked for consistency. The model may cover a part of the Moon only.
/// </summary>
public sealed record LdemLabel
{
    /// <summary>Stands in every name and label of a synthetic product.</summary>
    public const string SyntheticMark = "SYNTHETIC";

    /// <summary>Path of the label.</summary>
    public required string LabelPath { get; init; }

    /// <summary>Path of the image; the label's own for an attached label.</summary>
    public required string ImagePath { get; init; }

    /// <summary>Bytes of the image's file before the first sample.</summary>
    public required long ImageOffset { get; init; }

    /// <summary>Bytes that the image's file must have; null if the label names no number of records.</summary>
    public required long? FileBytes { get; init; }

    /// <summary>PRODUCT_ID, e.g. "LDEM_4": letters, digits, '_', '-' and '.'.</summary>
    public required string ProductId { get; init; }

    /// <summary>TARGET_NAME: the body.</summary>
    public CelestialBody Body { get; init; } = CelestialBody.Moon;

    /// <summary>MAP_RESOLUTION of a cylindrical model: samples a degree; 0 for a polar map.</summary>
    public required int PixelsPerDegree { get; init; }

    /// <summary>The projection of a polar map; null for a cylindrical model.</summary>
    public PolarStereographic? Polar { get; init; }

    /// <summary>LINES.</summary>
    public required int Lines { get; init; }

    /// <summary>LINE_SAMPLES.</summary>
    public required int LineSamples { get; init; }

    /// <summary>SAMPLE_TYPE with SAMPLE_BITS.</summary>
    public required LdemSampleType SampleType { get; init; }

    /// <summary>SCALING_FACTOR, turned into m a step.</summary>
    public required double ScalingFactor { get; init; }

    /// <summary>OFFSET, turned into m: the radius that sample value 0 means.</summary>
    public required double Offset { get; init; }

    /// <summary>MINIMUM: no sample value is below.</summary>
    public required double Minimum { get; init; }

    /// <summary>MAXIMUM: no sample value is above.</summary>
    public required double Maximum { get; init; }

    /// <summary>MAXIMUM_LATITUDE, degrees: of a cylindrical model the northern border of line 1.</summary>
    public required double NorthDegrees { get; init; }

    /// <summary>MINIMUM_LATITUDE, degrees.</summary>
    public required double SouthDegrees { get; init; }

    /// <summary>WESTERNMOST_LONGITUDE, degrees: of a cylindrical model the western border of sample 1.</summary>
    public required double WestDegrees { get; init; }

    /// <summary>EASTERNMOST_LONGITUDE, degrees.</summary>
    public required double EastDegrees { get; init; }

    /// <summary>COORDINATE_SYSTEM_NAME.</summary>
    public required string CoordinateSystem { get; init; }

    /// <summary>Whether this is a synthetic product (docs/synthetic-ldem.md).</summary>
    public bool IsSynthetic => ProductId.Contains(SyntheticMark, StringComparison.Ordinal);

    /// <summary>The samples are 16-bit integers.</summary>
    public bool HasIntegers => SampleType is LdemSampleType.Int16LittleEndian or LdemSampleType.Int16BigEndian;

    /// <summary>m: the limits of all radii. Floats may exceed the printed MINIMUM and MAXIMUM a little.</summary>
    public (double Min, double Max) RadiusLimits
    {
        get
        {
            double slack = HasIntegers ? 0.0 : Tolerances.FloatSampleLimits * (Maximum - Minimum);
            return (Offset + (ScalingFactor * (Minimum - slack)), Offset + (ScalingFactor * (Maximum + slack)));
        }
    }

    /// <summary>m: radius of the sphere of the heights: LOLA's for the Moon, whatever OFFSET is, else that of the label.</summary>
    public double ReferenceRadius => Body.IsMoon ? MoonConstants.ReferenceRadius : Offset;

    /// <summary>Bytes of a sample.</summary>
    public int SampleBytes => HasIntegers ? sizeof(short) : sizeof(float);

    /// <summary>Bytes of a line.</summary>
    public long LineBytes => (long)LineSamples * SampleBytes;

    /// <summary>Bytes of all samples.</summary>
    public long ImageBytes => LineBytes * Lines;

    /// <summary>Whether it covers latitudes -90 to 90 and longitudes 0 to 360 degrees.</summary>
    public bool CoversWholeMoon => Polar is null && (NorthDegrees, SouthDegrees, WestDegrees, EastDegrees) == (90.0, -90.0, 0.0, 360.0);
}
