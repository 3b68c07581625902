using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Xunit;

namespace Msisf.Core.Tests.Surface;

public sealed class GroundFacingTests
{
    private const double Radius = 1_737_400.0;

    /// <summary>
    /// Facets from some angle on, each tilted to the viewpoint as steeply as allowed, looked at one by one: the part is turned away if none
    /// of them faces the viewpoint.
    /// </summary>
    [Theory]
    [InlineData(2_000_000.0, 20.0, 0.0, false)]
    [InlineData(2_000_000.0, 40.0, 0.0, true)]
    [InlineData(2_000_000.0, 40.0, 0.5, false)]
    [InlineData(2_000_000.0, 90.0, 0.5, true)]
    [InlineData(1.5e11, 89.0, 0.0, false)]
    [InlineData(1.5e11, 91.0, 0.01, true)]
    [InlineData(1_735_000.0, 0.01, 1.7, false)] // from the floor of a crater its wall is seen, though the ground right above is not
    [InlineData(1_735_000.0, 1.0, 0.0, true)]
    public void IsTurnedAway_IsSoOfEachFacet(double distance, double fromDegrees, double maxSlope, bool expected)
    {
        SineCosine nearest = SineCosine.OfDegrees((long)(fromDegrees * 100.0), 100);
        bool isTurnedAway = GroundFacing.IsTurnedAway(nearest, distance, Radius, maxSlope);
        bool isAnyFacing = false;
        for (double degrees = fromDegrees; degrees < 180.0; degrees += 0.01)
        {
            (double sine, double cosine) = Math.SinCos(double.DegreesToRadians(degrees));
            Vector3D towards = new Vector3D(distance, 0.0, 0.0) - (Radius * new Vector3D(cosine, sine, 0.0));
            for (double slope = 0.0; slope <= maxSlope; slope += 0.01)
            {
                // Up at the facet, tilted towards the viewpoint.
                Vector3D normal = new Vector3D(cosine, sine, 0.0) + (slope * new Vector3D(sine, -cosine, 0.0));
                isAnyFacing |= Vector3D.Dot(normal, towards) > 0.0;
            }
        }

        Assert.Equal(expected, isTurnedAway);
        Assert.Equal(!expected, isAnyFacing);
    }
}
