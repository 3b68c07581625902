using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Tracing;
using Xunit;

namespace Msisf.Core.Tests.Metadata;

public class PixelSamplerTests
{
    /// <summary>degrees: half a unit in the last place of 360 degrees, four times over.</summary>
    private const double Rounding = 1.2e-13;

    [Fact]
    public void Sample_ModerateCameras_MeetsReferenceTo1e12Degrees()
    {
        foreach (ReferencePixel expected in ReferencePixel.Read("moderate"))
        {
            PixelRecord actual = RecordOf(expected);

            Assert.InRange(LatitudeError(expected, actual), 0.0, TestSupport.Rounding.OfChains);
            Assert.InRange(LongitudeError(expected, actual), 0.0, TestSupport.Rounding.OfChains);
            Assert.InRange(DirectionError(expected, actual), 0.0, TestSupport.Rounding.OfChains);
        }
    }

    /// <summary>
    /// The errors grow only as the geometry makes them: towards the limb, longitude at the poles, direction at the sub-solar point.
    /// </summary>
    [Theory]
    [InlineData("one_metre_above")]
    [InlineData("limb")]
    [InlineData("pole")]
    [InlineData("subsolar")]
    [InlineData("light_at_camera")]
    public void Sample_HardScenes_LosesNoMoreThanTheGeometryDoes(string scene)
    {
        foreach (ReferencePixel expected in ReferencePixel.Read(scene))
        {
            PixelRecord actual = RecordOf(expected);
            double cosLatitude = Math.Cos(double.DegreesToRadians(expected.LatitudeDegrees));

            Assert.InRange(LatitudeError(expected, actual) * expected.CosEmission, 0.0, Rounding);
            Assert.InRange(LongitudeError(expected, actual) * expected.CosEmission * cosLatitude, 0.0, Rounding);
            Assert.InRange(DirectionError(expected, actual) * expected.CosEmission * expected.Sine, 0.0, 1e-12);
        }
    }

    [Fact]
    public void Sample_CameraAt1e12Metres_IsAsGoodAsARoundedRay()
    {
        // A ray's direction is rounded by about 3e-16 rad: 3e-4 m at the Moon, 1e-8 degrees, more towards the limb.
        foreach (ReferencePixel expected in ReferencePixel.Read("far"))
        {
            PixelRecord actual = RecordOf(expected);

            Assert.InRange(LatitudeError(expected, actual) * expected.CosEmission, 0.0, 2e-8);
            Assert.InRange(DirectionError(expected, actual) * expected.CosEmission, 0.0, 2e-8);
        }
    }

    [Fact]
    public void Sample_MoonFillsPartOfTheImage_GoesByRowsFromTheTop()
    {
        PixelRecord[] records = [.. SamplerFor(LooksAlongX(0.0), spacing: 10).Sample()];

        Assert.Equal(records.OrderBy(r => r.V).ThenBy(r => r.H), records);
        Assert.All(records, r => Assert.True(r.H % 10 == 0 && r.V % 10 == 0));
        Assert.InRange(records.Length, 20, 99);
    }

    [Fact]
    public void Sample_Spacing1_TakesPixel1ToLast()
    {
        PixelRecord[] records = [.. SamplerFor(LooksAlongX(0.0, fov: 0.1), spacing: 1).Sample()];

        Assert.Equal(100 * 100, records.Length);
        Assert.Equal((1, 1), (records[0].H, records[0].V));
        Assert.Equal((100, 100), (records[^1].H, records[^1].V));
    }

    [Fact]
    public void Sample_MoonBehindTheCamera_IsEmpty() =>
        Assert.Empty(SamplerFor(LooksAlongX(Math.PI), spacing: 1).Sample());

    [Fact]
    public void Sample_SpacingLargerThanImage_IsEmpty() =>
        Assert.Empty(SamplerFor(LooksAlongX(0.0), spacing: 101).Sample());

    [Fact]
    public void Sample_LightAtTheCamera_HasNoDirectionOnlyAtTheNadirPixel()
    {
        PinholeCamera camera = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 0.1, 101, 101);

        PixelSampler sampler = new(camera, new PixelGrid(101, 101, 1, 1), ReferenceSphere.Lola,
            new(camera.PositionBodyFixed, IsSun: false));

        PixelRecord withoutDirection = Assert.Single(sampler.Sample(), record => record.IlluminationDirection is null);
        Assert.Equal((51, 51), (withoutDirection.H, withoutDirection.V));
    }

    [Fact]
    public void Constructor_SunNotFinite_IsBadInput() =>
        Assert.Throws<BadInputException>(() => new PixelSampler(
            LooksAlongX(0.0), new PixelGrid(100, 100, 1, 1), ReferenceSphere.Lola, new(new Vector3D(double.NaN, 0.0, 0.0), IsSun: true)));

    private static PixelRecord RecordOf(ReferencePixel pixel)
    {
        PixelGrid grid = new(pixel.Camera.Width, pixel.Camera.Height, pixel.X, pixel.Y);
        PixelRecord[] row = new PixelRecord[grid.Columns];
        new PixelSampler(pixel.Camera, grid, ReferenceSphere.Lola, new(pixel.Sun, IsSun: true)).SampleRow(0, row);
        return row.Single(record => (record.H, record.V) == (pixel.X, pixel.Y));
    }

    private static double LatitudeError(ReferencePixel expected, PixelRecord actual) =>
        Math.Abs(double.RadiansToDegrees(actual.Point.Latitude) - expected.LatitudeDegrees);

    private static double LongitudeError(ReferencePixel expected, PixelRecord actual) =>
        ReferencePixel.Apart(double.RadiansToDegrees(actual.Point.Longitude), expected.LongitudeDegrees);

    private static double DirectionError(ReferencePixel expected, PixelRecord actual) =>
        ReferencePixel.Apart(double.RadiansToDegrees(actual.IlluminationDirection!.Value), expected.DirectionDegrees);

    /// <summary>A camera on the x axis, turned about the vertical: 0 looks at the Moon.</summary>
    private static PinholeCamera LooksAlongX(double turn, double fov = 1.2) =>
        new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.FromAxisAngle(Vector3D.UnitZ, turn), fov, 100, 100);

    private static PixelSampler SamplerFor(PinholeCamera camera, int spacing) =>
        new(camera, new PixelGrid(100, 100, spacing, spacing), ReferenceSphere.Lola, new(new Vector3D(1e11, 1e11, 0.0), IsSun: true));
}
