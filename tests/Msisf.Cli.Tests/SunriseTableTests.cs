using System.Globalization;
using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Time;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests;

/// <summary>
/// The times in <c>sunrises.csv</c> against rays of the tracer a second before and a second after: to 4,096 points of the upper half of
/// the Sun's edge, which the program does not share. A point of the lower half is free of ground only where one over it is.
/// </summary>
public sealed class SunriseTableTests : IDisposable
{
    private const double Height = 2.0;
    private const double SunRadius = 695_700e3;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.Ldem4)]
    public void Sunrises_OfPlacesAnywhere_AreWithinASecondOfTheTracers()
    {
        Random random = new(5);
        for (int call = 0; call < TestLength.Of(1, 30); call++)
        {
            Check([.. Enumerable.Range(0, 2).Select(
                _ => (-90.0 + (15.0 * random.NextDouble()), Math.Round(360.0 * random.NextDouble(), 3)))]);
        }
    }

    private void Check((double Latitude, double Longitude)[] places)
    {
        string list = _folder.Write("sites.csv", "id,lat,lon\n" + string.Concat(places.Select((place, i) => string.Create(
            CultureInfo.InvariantCulture, $"{i},{place.Latitude:R},{place.Longitude:R}\n"))));
        CommandLineRun run = CommandLineRun.Of([
            "illumination", "--points", list, "--above-ground", "2", "--time-interval", "61041:1h:61071", "--ldem", TestParts.Ldem4Label!,
            "--ephemeris", "builtin", "--batch", "--output-dir", _folder["out"]]);
        Assert.True(run.ExitCode == 0, run.Error);

        using OpenedEphemeris opened = EphemerisFactory.Open(new EphemerisRequest(
            EphemerisChoice.BuiltIn, [Path.Combine(TestParts.RepositoryRoot, "kernels", "msisf.tm")], TestParts.RepositoryRoot, null));
        TerrainTracer tracer = new(LdemImage.Open(LdemCatalog.Find(4, TestParts.Ldem4Label!, [])));
        string[][] rows = [.. File.ReadLines(_folder["out/sunrises.csv"]).Skip(1).Select(row => row.Split(','))];
        Assert.NotEmpty(rows);
        foreach (string[] row in rows)
        {
            (double latitude, double longitude) = places[int.Parse(row[0], CultureInfo.InvariantCulture)];
            Vector3D direction = new SelenographicPoint(
                double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();
            Assert.True(tracer.TryTrace(new Ray(1_760_000.0 * direction, -direction), out SurfaceHit ground));
            Vector3D place = (ground.PointBodyFixed.Length + Height) * direction;
            DateTime time = DateTime.Parse(row[3], CultureInfo.InvariantCulture);
            double days = (time - DateTime.UnixEpoch).TotalDays + 40587.0;
            bool isRise = row[2] == "sunrise";
            Assert.Equal(!isRise, IsLit(days - (1.0 / 86400.0)));
            Assert.Equal(isRise, IsLit(days + (1.0 / 86400.0)));

            bool IsLit(double at) => IsAnyInView(tracer, place, opened.Engine.SunPositionBodyFixed(Moments.OfMjd(at)));
        }
    }

    private static bool IsAnyInView(TerrainTracer tracer, Vector3D place, Vector3D sun)
    {
        Vector3D toSun = sun - place;
        double distance = toSun.Length;
        double radius = distance * Math.Tan(Math.Atan2(SunRadius, Math.Sqrt((distance * distance) - (SunRadius * SunRadius))));
        Vector3D right = Vector3D.Cross(toSun, place).Normalized();
        Vector3D up = Vector3D.Cross(right, toSun).Normalized();
        return Enumerable.Range(0, 4096).AsParallel().Any(point =>
        {
            (double sine, double cosine) = Math.SinCos(2.0 * Math.PI * (point + 0.37) / 8192.0);
            return !tracer.TryTrace(new Ray(place, toSun + (radius * ((cosine * right) + (sine * up)))), out _);
        });
    }
}
