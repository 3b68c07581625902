using Msisf.Core.Camera;
using Msisf.Core.Navigation;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Navigation;

/// <summary>A crater whose rim stands 10 % farther out than the catalogue has it.</summary>
public class TerrainRimTests
{
    private const double Radius = 100e3;

    private const double RimHeight = 2000.0;

    [Fact]
    public void Find_RimFartherOut_FitsTheHighestGround()
    {
        MemoryElevationGrid grid = new("RING", 16, (line, sample) =>
        {
            double latitude = 90.0 - ((line + 0.5) / 16.0);
            double longitude = (sample + 0.5) / 16.0;
            double across = double.Hypot(latitude, (longitude - 180.0) * Math.Cos(double.DegreesToRadians(latitude)));
            double away = (across * double.DegreesToRadians(1_737_400.0)) - (1.1 * Radius);
            return 1_737_400.0 + Math.Max(0.0, RimHeight - (0.05 * Math.Abs(away)));
        });
        PinholeCamera camera = new(
            new Vector3D(-1_737_400.0 - 1e6, 0.0, 0.0), UnitQuaternion.FromComponents(0.0, 0.0, 1.0, 0.0), 0.5, 800, 800);
        CraterCatalogue catalogue = new([new Crater(1, "1", null, 0.0, 180.0, 2.0 * Radius)]);

        CraterView disc = Assert.Single(new CraterFinder(catalogue, CraterRim.Disc, 0.0).Find(camera, Light, grid).Views);
        CraterView rim = Assert.Single(new CraterFinder(catalogue, CraterRim.Terrain, 0.0).Find(camera, Light, grid).Views);

        // Of the ring's top: the way along the ground is 1.1 times the radius, and it stands over the plane of the centre by less.
        double angle = 1.1 * Radius / 1_737_400.0;
        double top = 1_737_400.0 + RimHeight;
        double seen = camera.Model.FocalX * top * Math.Sin(angle) / (1_737_400.0 + 1e6 - (top * Math.Cos(angle)));
        Assert.Equal(camera.Model.FocalX * Radius / 1e6, disc.Ellipse.SemiMajor, 1e-3); // the ground is flat between two samples
        Assert.Null(disc.Residual);
        Assert.Equal(seen, rim.Ellipse.SemiMajor, 0.03 * seen); // places are steps of 5 % of the radius, cells 2 %
        Assert.Equal(seen, rim.Ellipse.SemiMinor, 0.03 * seen);
        Assert.Equal(64, rim.Curve.Count);
        Assert.InRange(rim.Residual!.Value, 1e-6, 0.03 * seen);
    }

    private static SceneLight Light => new(new Vector3D(-1.5e11, 0.0, 1e10), IsSun: true);
}
