using FsCheck;
using FsCheck.Fluent;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Tracing;

public class ReferenceSphereTests
{
    private const double Radius = MoonConstants.ReferenceRadius;

    private static readonly Gen<double> Parts = Gen.Choose(0, 1_000_000).Select(i => i / 1e6);

    [Theory]
    [InlineData(1e-9)]
    [InlineData(1.0)]
    [InlineData(1e6)]
    [InlineData(1e12)]
    [InlineData(1e300)]
    public void TryFirstHit_StraightDown_HitsBelowTheOrigin(double altitude)
    {
        bool hit = ReferenceSphere.Lola.TryFirstHit(
            new Ray(new Vector3D(0.0, 0.0, Radius + altitude), new Vector3D(0.0, 0.0, -7.0)), out Vector3D point);

        Assert.True(hit);
        Assert.Equal(new Vector3D(0.0, 0.0, Radius), point);
    }

    [Theory]
    [InlineData(10.0)]
    [InlineData(1e12)]
    public void TryFirstHit_OffsetRay_HitsTheNearSide(double distance)
    {
        // 3-4-5: at offset 0.6 R the half chord is 0.8 R.
        bool hit = ReferenceSphere.Lola.TryFirstHit(
            new Ray(new Vector3D(Radius + distance, 0.6 * Radius, 0.0), new Vector3D(-1.0, 0.0, 0.0)), out Vector3D point);

        Assert.True(hit);
        Assert.InRange((point - (Radius * new Vector3D(0.8, 0.6, 0.0))).Length, 0.0, Rounding.OfPlaces);
    }

    [Theory]
    [InlineData(1.0, true)]
    [InlineData(1.0 + 1e-15, false)]
    public void TryFirstHit_TangentRay_HitsUpToTheRadiusItself(double radii, bool expected)
    {
        bool hit = ReferenceSphere.Lola.TryFirstHit(
            new Ray(new Vector3D(1e12, 0.0, radii * Radius), new Vector3D(-1.0, 0.0, 0.0)), out Vector3D point);

        Assert.Equal(expected, hit);
        Assert.Equal(expected ? new Vector3D(0.0, 0.0, Radius) : default, point);
    }

    [Fact]
    public void TryFirstHit_SphereBehindTheOrigin_Misses() =>
        Assert.False(ReferenceSphere.Lola.TryFirstHit(new Ray(new Vector3D(2e6, 0.0, 0.0), Vector3D.UnitX), out _));

    [Theory]
    [InlineData(-1.0)]
    [InlineData(1.0)]
    public void TryFirstHit_CameraInACraterBelowTheRadius_DoesNotShowTheFarWall(double side) =>
        Assert.False(ReferenceSphere.Lola.TryFirstHit(
            new Ray(new Vector3D(Radius - 3000.0, 0.0, 0.0), new Vector3D(side, 0.01, 0.0)), out _));

    [Fact]
    public void TryFirstHit_OriginOnTheSphere_HitsWhereItStands()
    {
        Assert.True(ReferenceSphere.Lola.TryFirstHit(new Ray(Radius * Vector3D.UnitX, new Vector3D(-1.0, 0.0, 0.0)), out Vector3D point));
        Assert.Equal(Radius * Vector3D.UnitX, point);
    }

    [Fact]
    public void TryFirstHit_RayFromTheSun_IsNotOffByTheDiscriminant()
    {
        // tests/reference/sphere.py (mpmath, 50 digits). Eq. 8.4 in doubles is 3.9 m off; a rounded direction is 5e-5 m.
        Vector3D sun = new(1.074955473280880e11, -1.042430734878980e11, 4.036164305561260e9);
        Vector3D target = new(1e6, 1.2e6, 5e5);

        Assert.True(ReferenceSphere.Lola.TryFirstHit(new Ray(sun, target - sun), out Vector3D point));

        Vector3D expected = new(1492697.8647896334269, 722199.66276732735959, 518497.33996543114361);
        Assert.InRange((point - expected).Length, 0.0, 1e-4);
    }

    [Fact]
    public void TryFirstHit_AnyHit_LiesOnTheSphereAndOnTheRay() =>
        Prop.ForAll(
            Arb.From(Gen.Zip(Gen.Zip(Parts, Parts), Gen.Zip(Parts, Parts))),
            parts =>
            {
                ((double a, double b), (double c, double d)) = parts;
                Vector3D zenith = new SelenographicPoint(Math.PI * (a - 0.5), 6.28 * b).ToDirectionBodyFixed();
                Vector3D origin = (Radius + Math.Pow(10.0, 7.0 * c)) * zenith;
                Ray ray = new(origin, new SelenographicPoint(3.0 * (d - 0.5), 6.28 * a).ToDirectionBodyFixed());
                if (!ReferenceSphere.Lola.TryFirstHit(ray, out Vector3D point))
                {
                    return true;
                }

                double offRay = Vector3D.Cross(point - origin, ray.Direction).Length;
                bool isNearSide = Vector3D.Dot(point, ray.Direction) <= 0.0;
                return isNearSide && Math.Abs(point.Length - Radius) <= 2e-9 && offRay <= 2e-8;
            })
            .Check(Config.QuickThrowOnFailure.WithMaxTest(2000).WithReplay(20120222UL, 1UL));

    [Theory]
    [InlineData(0.0)]
    [InlineData(-1.0)]
    [InlineData(double.NaN)]
    public void Constructor_RadiusNotPositive_IsACallersBug(double radius) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new ReferenceSphere(radius));
}
