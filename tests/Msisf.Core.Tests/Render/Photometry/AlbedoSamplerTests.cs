using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Photometry;

public class AlbedoSamplerTests
{
    private const double Radius = 1_737_400.0;

    [Theory]
    [InlineData(3e6, 1.0)]
    [InlineData(1e9, 0.0005)]
    [InlineData(1.75e6, 1.0)]
    public void Scale_EvenMap_IsItsReflectance(double distance, double pixelScale)
    {
        AlbedoMap map = SyntheticMaps.Of(301, (_, _) => 2000);
        PinholeCamera camera = Nadir(distance, 20.0, 179.9, pixelScale * 0.5);

        // 2000 codes of 1e-4, over the law's 0.05 in the map's geometry.
        Assert.All(Samples(map, camera), factor => Assert.Equal(4.0, factor, 1e-9));
    }

    [Fact]
    public void Scale_NearTheMap_IsLinearBetweenItsPixels()
    {
        // One pixel a degree, codes that grow with the longitude: at x degrees from the left edge the code is 1000 + 10 (x - 0.5).
        AlbedoMap map = SyntheticMaps.Of(360, (column, _) => 1000 + (10 * column));
        double code = CodeAt(map, latitude: 12.3, longitude: 33.8, Nadir(1.7375e6, 12.3, 33.8, 1e-3));

        Assert.Equal(1000.0 + (10.0 * (213.8 - 0.5)), code, 1e-6);
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(60.0)]
    [InlineData(-85.0)]
    public void Scale_AcrossTheSeam_GoesOn(double latitude)
    {
        AlbedoMap map = SyntheticMaps.Of(361, (column, _) => (int)(3000.0 + (1000.0 * Math.Cos(2.0 * Math.PI * (column + 0.5) / 361.0))));
        PinholeCamera camera = Nadir(1.74e6, latitude, 180.0, 1e-3);

        double east = CodeAt(map, latitude, -179.9999, camera);
        double west = CodeAt(map, latitude, 179.9999, camera);

        Assert.Equal(east, west, 0.1);
        Assert.InRange(east, 3998.0, 4000.5); // the cosine's greatest value, at the left edge
    }

    [Fact]
    public void Scale_OverThePole_GoesOn()
    {
        AlbedoMap map = SyntheticMaps.Of(360, (_, row) => row < 2 ? 1000 + (500 * row) : 5000);
        PinholeCamera camera = Nadir(1.74e6, 90.0, 0.0, 1e-3);

        // Both sides of the pole see the first row's pixels; half a degree from it is their middle.
        Assert.Equal(1000.0, CodeAt(map, 89.5, 10.0, camera), 1.0);
        Assert.Equal(1000.0, CodeAt(map, 89.99, 10.0, camera), 1.0);
        Assert.Equal(1000.0, CodeAt(map, 89.99, -170.0, camera), 1.0);
    }

    [Fact]
    public void Scale_ChequersFromFarAway_AreGrey()
    {
        AlbedoMap map = SyntheticMaps.Of(4096, (column, row) => (column + row) % 2 == 0 ? 1000 : 3000);
        PinholeCamera camera = Nadir(1e9, 0.0, 0.0, 0.25);

        double[] codes = [.. Samples(map, camera).Select(factor => factor * 0.05 / 1e-4)];

        Assert.All(codes, code => Assert.InRange(code, 1990.0, 2010.0));
    }

    [Fact]
    public void Scale_MeridianStripesAtTheLimbAndThePole_AreNotAliased()
    {
        // Stripes of one pixel along meridians; each footprint is wider than 16 of them.
        AlbedoMap map = SyntheticMaps.Of(8192, (column, _) => column % 2 == 0 ? 1000 : 3000);
        foreach ((double latitude, double longitude) in new[] { (85.0, 20.0), (40.0, 80.0), (-89.9, 0.0), (0.0, 86.0) })
        {
            double code = CodeAt(map, latitude, longitude, Nadir(4e8, 0.0, 0.0, 0.25));
            Assert.InRange(code, 1900.0, 2100.0);
        }
    }

    [Fact]
    public void Scale_NoData_LeavesTheLawAlone()
    {
        AlbedoMap map = SyntheticMaps.Of(90, 30, new MapExtent(0.0, 0.5, 1.0, 0.3), (_, row) => row < 15 ? 2000 : 0);

        Assert.Equal([1.0], Samples(map, Nadir(1.74e6, 10.0, 200.0, 1e-3), (10.0, 200.0)));
        Assert.Equal([1.0], Samples(map, Nadir(1.74e6, 12.0, 20.0, 1e-3), (12.0, 20.0)));
        Assert.Equal([4.0], Samples(map, Nadir(1.74e6, 27.0, 20.0, 1e-3), (27.0, 20.0)));
    }

    private static double CodeAt(AlbedoMap map, double latitude, double longitude, PinholeCamera camera) =>
        Samples(map, camera, (latitude, longitude))[0] * 0.05 / 1e-4;

    /// <summary>Factors by which radiance factors at places are scaled; at 200 places round the camera's nadir if none is named.</summary>
    private static double[] Samples(AlbedoMap map, PinholeCamera camera, params (double Latitude, double Longitude)[] places)
    {
        Vector3D nadir = camera.PositionBodyFixed;
        double latitude = double.RadiansToDegrees(Math.Atan2(nadir.Z, double.Hypot(nadir.X, nadir.Y)));
        double longitude = double.RadiansToDegrees(Math.Atan2(nadir.Y, nadir.X));
        (double Latitude, double Longitude)[] wanted = places.Length > 0
            ? places
            : [.. Enumerable.Range(0, 200).Select(i => (latitude + (0.02 * (i % 14)), longitude + (0.03 * (i / 14))))];
        SunlitPoints points = new();
        points.Clear(wanted.Length);
        foreach ((double lat, double lon) in wanted)
        {
            Vector3D up = Direction(lat, lon);
            points.Add(points.Count, 1.0, Radius * up, up, 0.5);
        }

        points.Factors.AsSpan().Fill(1.0);
        new AlbedoSampler().Scale(points, camera, width: 1.0, map, factorOfReference: 0.05, points.Factors);
        return points.Factors[..points.Count];
    }

    private static PinholeCamera Nadir(double distance, double latitude, double longitude, double fieldOfView)
    {
        Vector3D position = distance * Direction(latitude, longitude);
        return new PinholeCamera(position, NadirPointing.MoonFromCamera(position), fieldOfView, 512, 512);
    }

    private static Vector3D Direction(double latitude, double longitude)
    {
        (double sinLatitude, double cosLatitude) = Math.SinCos(double.DegreesToRadians(latitude));
        (double sinLongitude, double cosLongitude) = Math.SinCos(double.DegreesToRadians(longitude));
        return new Vector3D(cosLatitude * cosLongitude, cosLatitude * sinLongitude, sinLatitude);
    }
}
