using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Metadata;

/// <summary>A line of tests/golden/illumination.tsv: a scene and what tests/reference/illumination.py (mpmath, 50 digits) found.</summary>
internal sealed record ReferencePixel(
    PinholeCamera Camera,
    int X,
    int Y,
    Vector3D Sun,
    double LatitudeDegrees,
    double LongitudeDegrees,
    double DirectionDegrees,
    double CosEmission,
    double Sine)
{
    /// <summary>The lines of a scene; at least one.</summary>
    public static ReferencePixel[] Read(string scene)
    {
        ReferencePixel[] pixels = [.. File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "illumination.tsv"))
            .Select(line => line.Split('\t'))
            .Where(fields => fields[0] == scene)
            .Select(Parse)];
        Assert.NotEmpty(pixels);
        return pixels;
    }

    /// <summary>The smaller way round between two angles, degrees.</summary>
    public static double Apart(double a, double b) => Math.Abs(Math.IEEERemainder(a - b, 360.0));

    private static ReferencePixel Parse(string[] fields)
    {
        double[] n = [.. fields.Skip(1).Select(field => double.Parse(field, CultureInfo.InvariantCulture))];
        PinholeCamera camera = new(
            new Vector3D(n[0], n[1], n[2]), UnitQuaternion.FromComponents(n[3], n[4], n[5], n[6]), n[7], (int)n[8], (int)n[9]);
        return new ReferencePixel(
            camera, (int)n[10], (int)n[11], new Vector3D(n[12], n[13], n[14]), n[15], n[16], n[17], n[18], n[19]);
    }
}
