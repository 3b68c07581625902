using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Surface;
using Xunit;

namespace Msisf.Core.Tests.Render.Shadows;

public sealed class CasterBoundsTests
{
    private const double Radius = 1_737_400.0;
    private const double SteepestSlope = 10.0; // tangent: any facet may face away
    private static readonly Vector3D Sun = 1.496e11 * Vector3D.UnitX;

    /// <summary>Facets within some metres of a point 100 km on the Sun's side of a receiver and so many metres aside.</summary>
    [Theory]
    [InlineData(0.0, 0.0, true)]
    [InlineData(300.0, 0.0, false)]
    [InlineData(-300.0, 0.0, false)]
    [InlineData(300.0, 0.00465, true)]
    [InlineData(-300.0, 0.00465, true)]
    [InlineData(600.0, 0.00465, false)]
    public void MayCast_CapAsideOfTheRay_DependsOnTheSizeOfTheSun(double aside, double slope, bool expected)
    {
        Vector3D receiver = new(0.0, 0.0, Radius);
        Vector3D caster = receiver + new Vector3D(100e3, aside, 0.0);
        Assert.Equal(
            expected,
            Bounds(receiver, slope).MayCast(new TerrainNode(CapAt(caster), caster.Length - 5.0, caster.Length + 5.0, SteepestSlope)));
    }

    [Theory]
    [InlineData(100e3, true)]
    [InlineData(-100e3, false)] // behind the receiver
    public void MayCast_CapOnTheRay_MustBeOnTheSunsSide(double towardsSun, bool expected)
    {
        Vector3D receiver = new(0.0, 0.0, Radius);
        Vector3D caster = receiver + new Vector3D(towardsSun, 0.0, 0.0);
        Assert.Equal(
            expected,
            Bounds(receiver, slope: 0.0).MayCast(new TerrainNode(CapAt(caster), caster.Length - 5.0, caster.Length + 5.0, SteepestSlope)));
    }

    /// <summary>
    /// Under a Sun 30 degrees high facets face away whose slope is above 30 degrees, or a little less for the disc's lower edge.
    /// </summary>
    [Theory]
    [InlineData(30.1, 0.0, true)]
    [InlineData(29.9, 0.0, false)]
    [InlineData(29.9, 0.00465, true)]
    [InlineData(29.6, 0.00465, false)]
    public void MayCast_Slope_MustPassTheSunsElevation(double slopeDegrees, double slope, bool expected)
    {
        Vector3D direction = new(Math.Sin(Math.PI / 6.0), 0.0, Math.Cos(Math.PI / 6.0));
        Vector3D receiver = Radius * direction;
        CasterBounds bounds = Bounds(receiver, slope);
        Assert.Equal(
            expected,
            bounds.MayCast(new TerrainNode(CapAt(receiver), Radius - 10.0, Radius + 10.0, Math.Tan(slopeDegrees * Math.PI / 180.0))));
    }

    private static SphericalCap CapAt(Vector3D position)
    {
        double angle = 1.0 / position.Length;
        return new SphericalCap(position.Normalized(), Math.Cos(angle), Math.Sin(angle));
    }

    private static CasterBounds Bounds(Vector3D receiver, double slope)
    {
        ReceiverJob job = new(new PointReceivers([receiver], 1), new NightZone(1e6, slope), Hide: _ => { }, Threads: 1, default);
        PlacedReceivers receivers = new ReceiverSort().Read(job, new LightSource(Sun, slope));
        return new CasterBounds(receivers, slope, Radius + 10e3);
    }
}
