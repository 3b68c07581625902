using System.Globalization;
using Msisf.Core.Numerics;
using Msisf.Stress.Reference;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Stress.Tests.Reference;

/// <summary>
/// The reference of the stress tests against tests/golden/stress_pixels.tsv (tests/reference/stress_pixels.py, mpmath, 50 digits).
/// </summary>
public sealed class PrecisePixelTests
{
    /// <summary>
    /// degrees: the stress tests measure errors from 1e-15 degrees up; what cancels at the limb and from 1e12 m costs some of the 32
    /// digits.
    /// </summary>
    private const double Agreement = 1e-19;

    [Fact]
    public void At_CamerasOfAllKinds_MeetsMpmath()
    {
        int pixels = 0;
        List<string> wrong = [];
        PreciseCamera? camera = null;
        Vector3D sun = default;
        foreach (string[] fields in Lines())
        {
            double[] n = [.. fields.Skip(1).Take(13).Select(field => double.Parse(field, CultureInfo.InvariantCulture))];
            if (fields[0] == "camera")
            {
                camera = new PreciseCamera(new Vector3D(n[0], n[1], n[2]), (n[3], n[4], n[5], n[6]), n[7], (int)n[8], (int)n[9]);
                sun = new Vector3D(n[10], n[11], n[12]);
                continue;
            }

            PrecisePixel pixel = PrecisePixel.At(camera!, (int)n[0], (int)n[1])!;
            double error = Errors(pixel, sun, fields).Max();
            pixels++;
            if (!(error <= Agreement))
            {
                wrong.Add($"{string.Join(' ', fields)}: {error} degrees");
            }
        }

        Assert.True(wrong.Count == 0, $"{wrong.Count}: {string.Join(Environment.NewLine, wrong.Take(5))}");
        Assert.Equal(8509, pixels);
    }

    private static IEnumerable<string[]> Lines() =>
        File.ReadLines(Path.Combine(TestParts.RepositoryRoot, "tests", "golden", "stress_pixels.tsv"))
            .Where(line => !line.StartsWith('#'))
            .Select(line => line.Split('\t'));

    /// <summary>Degrees: of latitude, of longitude along its parallel, of the direction.</summary>
    private static double[] Errors(PrecisePixel pixel, Vector3D sun, string[] fields)
    {
        PreciseVector point = pixel.Point;
        DoubleWord across = DoubleWord.Sqrt((point.X * point.X) + (point.Y * point.Y));
        (DoubleWord down, DoubleWord right) = pixel.IlluminationDirection(sun);
        double[] radians =
        [
            PreciseMath.AngleError(Angle(fields[3]), across, point.Z),
            across.High > 0.0 ? PreciseMath.AngleError(Angle(fields[4]), point.X, point.Y) * (across.High / point.Length.High) : 0.0,
            PreciseMath.AngleError(Angle(fields[5]), down, right) * pixel.DirectionSine(sun),
        ];
        return [.. radians.Select(error => Math.Abs(double.RadiansToDegrees(error)))];
    }

    /// <summary>rad, of degrees printed with 24 digits: 12 decimals as a quotient of whole numbers, and the rest.</summary>
    private static DoubleWord Angle(string degrees)
    {
        const double Parts = 1e12;
        decimal all = decimal.Parse(degrees, NumberStyles.Float, CultureInfo.InvariantCulture);
        decimal whole = decimal.Truncate(all * (decimal)Parts);
        return PreciseMath.Degree * (((DoubleWord)(double)whole / Parts) + (double)(all - (whole / (decimal)Parts)));
    }
}
