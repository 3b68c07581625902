using System.Globalization;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Metadata;

public class PhotometricAnglesTests
{
    /// <summary>
    /// Degrees: four units in the last place of 180 degrees. The differences to light and camera are rounded once, the angles to a few more
    /// such steps.
    /// </summary>
    private const double Rounding = 1.2e-13;

    [Theory]
    [InlineData("anywhere", 150)]
    [InlineData("one_metre_above", 50)]
    [InlineData("far", 50)]
    [InlineData("small_phase", 50)]
    [InlineData("grazing", 50)]
    [InlineData("lamp_at_camera", 50)]
    public void At_References_AreMetToTheLastDigits(string scene, int count)
    {
        double[][] lines = Read(scene);

        Assert.Equal(count, lines.Length);
        foreach (double[] n in lines)
        {
            PhotometricAngles actual = PhotometricAngles.At(Vector(n, 0), Vector(n, 3), Vector(n, 6), Vector(n, 9));

            Assert.InRange(double.RadiansToDegrees(actual.Incidence), n[12] - Rounding, n[12] + Rounding);
            Assert.InRange(double.RadiansToDegrees(actual.Emission), n[13] - Rounding, n[13] + Rounding);
            Assert.InRange(double.RadiansToDegrees(actual.Phase), n[14] - Rounding, n[14] + Rounding);
        }
    }

    [Fact]
    public void At_LightAtTheCamera_HasNoPhaseAtAll()
    {
        foreach (double[] n in Read("lamp_at_camera"))
        {
            Assert.Equal(0.0, PhotometricAngles.At(Vector(n, 0), Vector(n, 3), Vector(n, 6), Vector(n, 9)).Phase);
        }
    }

    [Fact]
    public void At_LightBehindTheSurface_HasAnIncidenceAboveARightAngle()
    {
        Vector3D point = new(1_737_400.0, 0.0, 0.0);

        PhotometricAngles angles = PhotometricAngles.At(point, Vector3D.UnitX, 2.0 * point, -1e5 * point);

        Assert.Equal(new PhotometricAngles(Math.PI, 0.0, Math.PI), angles);
    }

    private static Vector3D Vector(double[] numbers, int first) => new(numbers[first], numbers[first + 1], numbers[first + 2]);

    /// <summary>
    /// Lines of tests/golden/photometric_angles.tsv: point, normal, camera, light; then the angles that
    /// tests/reference/photometric_angles.py found.
    /// </summary>
    private static double[][] Read(string scene)
    {
        double[][] lines = [.. File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "photometric_angles.tsv"))
            .Select(line => line.Split('\t'))
            .Where(fields => fields[0] == scene)
            .Select(fields => fields.Skip(1).Select(field => double.Parse(field, CultureInfo.InvariantCulture)).ToArray())];
        Assert.NotEmpty(lines);
        return lines;
    }
}
