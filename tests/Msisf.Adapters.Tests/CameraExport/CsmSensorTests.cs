using System.Globalization;
using Msisf.Adapters.Camera;
using Msisf.Adapters.CameraExport;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Numerics;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.CameraExport;

/// <summary>
/// Lenses by USGSCSM's conventions both ways: from a pixel to its ray as imageToGround has it, from a ray to its pixel as groundToImage has
/// it, with the limits and tolerances of USGSCSM 2.1 (Distortion.cpp).
/// </summary>
public sealed class CsmSensorTests
{
    /// <summary>px: USGSCSM inverts RADIAL and KAGUYALISM to 1e-6 of the unit of the focal plane, a pixel.</summary>
    private const double Tolerance = 2e-6;

    /// <summary>mm: the pixels of the cameras here, where states count in mm.</summary>
    private const double Pitch = 0.007;

    private const double F = 2000.0;

    /// <summary>Of the terms of TRANSVERSE.</summary>
    private static readonly int[] Powers = [0, 1, 1, 2, 2, 2, 3, 3, 3, 3];

    /// <summary>
    /// Each lens of this program: the type in USGSCSM, null for none; the part that USGSCSM lacks, and px that its nearest lens is off
    /// then, by numpy's least squares.
    /// </summary>
    private static readonly (string Name, CameraModel Camera, int? Type, string Missing, double Misfit)[] Lenses =
    [
        ("none", Narrow(null), 0, "", 0.0),
        ("brown-conrady", Narrow(new OpenCvDistortion([-0.1, 0.02, 0.01], [0.002, -0.001])), 7, "", 0.0),
        ("rational", Narrow(new OpenCvDistortion([-0.1, 0.02, 0.01, 0.1], [])), null, "k4 to k6 and s1 to s4", 0.0),
        ("prism", Narrow(new OpenCvDistortion([-0.1], [], [0.001, 0.0, 0.0, 0.0])), null, "k4 to k6 and s1 to s4", 0.0),
        ("fisheye", Narrow(new FisheyeDistortion([0.02])), null, "the model 'fisheye'", 0.0),
        ("factor", Narrow(new RadialDistortion([0.1, 0.02], isDivision: false, 1.0)), 0, "", 0.0),
        ("factor of the sixth power, wide", Wide(new RadialDistortion([0.1, 0.02, 0.01], isDivision: false, 1.0)), 7, "k3 ", 0.0125),
        ("division", Row(new RadialDistortion([0.1], isDivision: true, 1.0), 1.0), 4, "", 0.0),
        ("division of the fourth power", Row(new RadialDistortion([0.1, 0.1], isDivision: true, 1.0), 1.0), null, "k2 and k3", 0.0),
        ("division off the axis", Row(new RadialDistortion([0.1], isDivision: true, 1.0), 5.0), null, "not one row through the axis", 0.0),
        ("division in a frame", Narrow(new RadialDistortion([0.1], isDivision: true, 1.0)), null, "not one row through the axis", 0.0),
        ("polynomial of the radius", Narrow(Polynomial(isRadial: true)), 2, "", 0.0),
        ("polynomial of x", Row(Polynomial(isRadial: false), 1.0), 2, "", 0.0),
        ("polynomial of x off the axis", Row(Polynomial(isRadial: false), -300.0), 2, "", 0.0),
        ("polynomial of x in a frame", Narrow(Polynomial(isRadial: false)), 1, "a polynomial of x in an image of several rows", 3.01e-7),
        ("owen", Narrow(new OwenDistortion([0.0, 0.05, 0.0, 0.0, 0.01, -0.015], 1.0)), 1, "", 0.0),
        ("owen's turn", Narrow(new OwenDistortion([0.01, 0.05, 0.0, 0.0, 0.01, -0.015], 1.0)), null, "e1, e3 and e4", 0.0),
        ("brown", Narrow(new BrownDistortion([0.001, 0.1, 0.02], [], [], default, 1.0)), 0, "", 0.0),
        ("brown's centre", Narrow(OffCentre), 1, "corrections about a centre", 0.00212),
        ("brown's centre, wide", Wide(OffCentre), 7, "corrections about a centre", 1.28),
        ("brown's decentring", Narrow(new BrownDistortion([], [0.01, 0.0], [], default, 1.0)), 1, "corrections about", 9.7e-6),
    ];

    public static TheoryData<string> Names => [.. Lenses.Select(lens => lens.Name)];

    [Theory]
    [MemberData(nameof(Names))]
    public void Of_EachLens_GoesBothWaysOrSaysWhatIsMissing(string name)
    {
        (_, CameraModel camera, int? type, string missing, double misfit) = Lenses.Single(lens => lens.Name == name);

        AssertLens(camera, type, missing, misfit);
    }

    /// <summary>Each preset as it is exported.</summary>
    [Theory]
    [InlineData("lroc-nac-l", 4, 0.0)]
    [InlineData("lroc-nac-r", 4, 0.0)]
    [InlineData("kaguya-tc1", 2, 0.0)]
    [InlineData("chandrayaan-m3", 2, 0.0)]
    [InlineData("clementine-uvvis", 0, 0.0)]
    [InlineData("lroc-wac-415", 7, 0.021)]
    [InlineData("lroc-wac-566", 7, 0.017)]
    [InlineData("lroc-wac-604", 7, 0.016)]
    [InlineData("lroc-wac-643", 7, 0.015)]
    [InlineData("lroc-wac-689", 7, 0.015)]
    public void Of_Preset_GoesBothWaysOrSaysWhatIsMissing(string preset, int type, double misfit) =>
        AssertLens(Preset(preset), type, "k3 (its RADIAL ends with the fourth power)", misfit);

    /// <summary>The NAC's state counts in mm; counted in pixels USGSCSM leaves its lens out, 14.6 px off.</summary>
    [Theory]
    [InlineData("lroc-nac-l", 699.62, 1.81e-5, 14.6)]
    [InlineData("lroc-nac-r", 701.57, 1.83e-5, 15.1)]
    public void Of_NarrowAngleCamera_CountsInMillimetres(string preset, double focalLength, double k, double inPixels)
    {
        CameraModel camera = Preset(preset);
        CsmSensor sensor = CsmSensor.Of(camera, scan: null);

        Assert.Equal(focalLength, sensor.FocalLength, 1e-9);
        Assert.Equal(k, Assert.Single(sensor.Lens.Coefficients), 1e-15);
        Assert.Equal(1.0 / 0.007, sensor.Samples[2], 1e-9);
        Assert.InRange(WorstToImage(camera, In(sensor, 1.0 / 0.007)), inPixels - 0.1, inPixels + 0.1);
    }

    /// <summary>Of the other lenses the unit does not matter but for the tolerances of the inverses, 1e-6 mm.</summary>
    [Theory]
    [InlineData("none")]
    [InlineData("brown-conrady")]
    [InlineData("factor")]
    [InlineData("polynomial of the radius")]
    [InlineData("polynomial of x off the axis")]
    [InlineData("owen")]
    public void Of_StateInMillimetres_IsTheSame(string name)
    {
        CameraModel camera = Lenses.Single(lens => lens.Name == name).Camera;

        Assert.InRange(WorstToImage(camera, In(CsmSensor.Of(camera, scan: null), Pitch)), 0.0, 2e-6 / Pitch);
    }

    /// <summary>A wider row than LROC's is counted in smaller pixels, so that USGSCSM's limit stays far off.</summary>
    [Fact]
    public void Of_RowWiderThanLrocs_StaysWithinTheLimit() => AssertBothWays(new CameraModel(
        16000, 1, (60_000.0, 60_000.0), (1.0, 1.0), 0.0, new RadialDistortion([5.0], isDivision: true, 1.0)));

    private static BrownDistortion OffCentre => new([0.0, 0.1], [], [], (0.1, 0.0), 1.0);

    private static CameraModel Narrow(Distortion? distortion) => new(400, 300, (F, 1.2 * F), (233.5, 117.25), 0.0, distortion);

    private static CameraModel Wide(Distortion? distortion) => new(400, 300, (250.0, 300.0), (233.5, 117.25), 0.0, distortion);

    private static CameraModel Row(Distortion distortion, double line) => new(1500, 1, (F, F), (733.5, line), 0.0, distortion);

    private static PolynomialDistortion Polynomial(bool isRadial) =>
        new([0.001, 0.002, -0.003, 0.0005], [-0.02, 0.001, 0.002], isRadial, 1.0);

    private static CameraModel Preset(string name) =>
        CameraFileReader.Read(Path.Combine(TestParts.RepositoryRoot, "cameras", name + ".yaml"), name).Model;

    /// <summary>Checks which lens of USGSCSM a camera gets, how far off it is, and that states with it go both ways.</summary>
    internal static void AssertLens(CameraModel camera, int? type, string missing, double misfit)
    {
        if (type is null)
        {
            Assert.False(CsmLens.Has(camera));
            Assert.EndsWith(missing, CsmLens.Difference(camera), StringComparison.Ordinal);
            return;
        }

        CsmLens lens = CsmLens.Of(camera);
        Assert.Equal(type, lens.Type);
        Assert.Equal(misfit > 0.0, CsmLens.Difference(camera) is not null);
        Assert.Equal(misfit <= 0.05, CsmLens.Has(camera));
        Assert.InRange(lens.Misfit, 0.0, (1.1 * misfit) + (misfit > 0.0 ? 1e-9 : 0.0));
        if (misfit > 0.0)
        {
            Assert.StartsWith("USGSCSM has no counterpart of ", CsmLens.Difference(camera), StringComparison.Ordinal);
            Assert.Contains(missing, CsmLens.Difference(camera), StringComparison.Ordinal);
            Assert.True(misfit < 1e-6 || lens.Misfit > 0.5 * misfit, lens.Misfit.ToString(CultureInfo.InvariantCulture));
        }

        if (CsmLens.Has(camera))
        {
            AssertBothWays(camera, Tolerance + (1.05 * lens.Misfit)); // between the points where it was measured
        }
    }

    private static void AssertBothWays(CameraModel camera, double tolerance = Tolerance)
    {
        CsmSensor sensor = CsmSensor.Of(camera, scan: null);
        Assert.InRange(WorstToImage(camera, sensor), 0.0, tolerance);
        foreach ((double x, double y) in Pixels(camera))
        {
            (double right, double down) = ToGround(sensor, x - 0.5, y - 0.5);
            (double idealRight, double idealDown) = camera.ToIdeal(x, y);
            double slope = camera.Distortion is null ? 1.0 : 4.0; // px of the ideal image in a measured one, at most
            Assert.Equal(idealRight * camera.FocalX, right * camera.FocalX, slope * tolerance);
            Assert.Equal(idealDown * camera.FocalX, down * camera.FocalX, slope * tolerance);
        }
    }

    private static double WorstToImage(CameraModel camera, CsmSensor sensor) => Pixels(camera).Max(pixel =>
    {
        (double right, double down) = camera.ToIdeal(pixel.X, pixel.Y);
        (double sample, double line) = ToImage(sensor, right, down);
        return double.Hypot(sample + 0.5 - pixel.X, line + 0.5 - pixel.Y);
    });

    private static IEnumerable<(double X, double Y)> Pixels(CameraModel camera) =>
        from i in Enumerable.Range(0, 21)
        from j in Enumerable.Range(0, camera.Height == 1 ? 1 : 11)
        select (1.0 + ((camera.Width - 1.0) * i / 20.0), 1.0 + ((camera.Height - 1.0) * j / 10.0));

    /// <summary>The same state with its focal plane in a unit of which a present one has <paramref name="unit"/>.</summary>
    private static CsmSensor In(CsmSensor sensor, double unit)
    {
        double[] c = sensor.Lens.Coefficients;
        double[] scaled = sensor.Lens.Type switch
        {
            0 => [c[0], c[1] / Math.Pow(unit, 2), c[2] / Math.Pow(unit, 4)],
            1 => [.. c.Select((one, i) => one * Math.Pow(unit, 1 - Powers[i % 10]))],
            2 => [.. c.Select((one, i) => one * Math.Pow(unit, i % 5 == 0 ? 1 : 2 - (i % 5)))],
            4 => [c[0] / (unit * unit)],
            _ => c,
        };
        return sensor with
        {
            FocalLength = sensor.FocalLength * unit,
            Samples = [.. sensor.Samples.Select(one => one / unit)],
            Lines = [.. sensor.Lines.Select(one => one / unit)],
            Lens = sensor.Lens with { Coefficients = scaled },
        };
    }

    /// <summary>Tangents to the right and down, from the sensor's x and y, of which LROLROCNAC's y is along the row.</summary>
    private static (double Right, double Down) ToGround(CsmSensor sensor, double sample, double line)
    {
        (double[] s, double[] l) = (sensor.Samples, sensor.Lines);
        double determinant = (s[1] * l[2]) - (s[2] * l[1]);
        (double ds, double dl) = (sample - sensor.Sample - s[0], line - sensor.Line - l[0]);
        (double x, double y) = Remove(
            sensor.Lens, sensor.FocalLength, ((l[2] * ds) - (s[2] * dl)) / determinant, ((s[1] * dl) - (l[1] * ds)) / determinant);
        return sensor.Lens.IsTurned ? (y / sensor.FocalLength, -x / sensor.FocalLength) : (x / sensor.FocalLength, y / sensor.FocalLength);
    }

    private static (double Sample, double Line) ToImage(CsmSensor sensor, double right, double down)
    {
        double f = sensor.FocalLength;
        (double x, double y) = sensor.Lens.IsTurned
            ? Apply(sensor.Lens, f, -f * down, f * right)
            : Apply(sensor.Lens, f, f * right, f * down);
        return (
            sensor.Samples[0] + (sensor.Samples[1] * x) + (sensor.Samples[2] * y) + sensor.Sample,
            sensor.Lines[0] + (sensor.Lines[1] * x) + (sensor.Lines[2] * y) + sensor.Line);
    }

    /// <summary>Measured to ideal.</summary>
    private static (double X, double Y) Remove(CsmLens lens, double f, double x, double y)
    {
        double[] c = lens.Coefficients;
        (double r2, double r) = ((x * x) + (y * y), double.Hypot(x, y));
        return lens.Type switch
        {
            0 when 1.0 - c[0] - (r2 * (c[1] + (r2 * c[2]))) is var factor => (x * factor, y * factor),
            2 => (x + c[0] + Cubic(c[1..5], r), y + c[5] + Cubic(c[6..], r)),
            4 => (x, y / (1.0 + (c[0] * y * y))),
            _ => Solved(lens, f, x, y),
        };
    }

    /// <summary>Ideal to measured.</summary>
    private static (double X, double Y) Apply(CsmLens lens, double f, double x, double y)
    {
        double[] c = lens.Coefficients;
        return lens.Type switch
        {
            0 => Radial(c, x, y),
            1 => (Dot(c[..10], x, y), Dot(c[10..], x, y)),
            2 => Kaguya(c, x, y),
            4 => Math.Abs(y) > 40.0 ? (x, y) : (x, Nac(c[0], y)), // a point so far off is no point of the image
            _ => Scaled(f, Tangential(c, x / f, y / f)),
        };
    }

    private static (double X, double Y) Radial(double[] c, double x, double y)
    {
        const double DesiredPrecision = 1e-6;
        double ideal = double.Hypot(x, y);
        double part = c[0] + (ideal * ideal * (c[1] + (ideal * ideal * c[2])));
        double r = ideal + (part * ideal);
        for (double before = double.NaN; !(Math.Abs(r - before) <= DesiredPrecision);)
        {
            before = r;
            part = c[0] + (r * r * (c[1] + (r * r * c[2])));
            r = ideal + (part * before);
        }

        return (x / (1.0 - part), y / (1.0 - part));
    }

    private static (double X, double Y) Kaguya(double[] c, double x, double y)
    {
        (double atX, double atY) = (x - c[0], y - c[5]);
        for (int i = 0; i < 50; i++)
        {
            (double beforeX, double beforeY, double r) = (atX, atY, double.Hypot(atX, atY));
            (atX, atY) = (x - Cubic(c[1..5], r) - c[0], y - Cubic(c[6..], r) - c[5]);
            if (Math.Abs(atX - beforeX) < 1e-6 && Math.Abs(atY - beforeY) < 1e-6)
            {
                return (atX, atY);
            }
        }

        return (x, y);
    }

    private static double Nac(double k, double ideal)
    {
        (double at, double before) = (ideal, 1e6);
        for (int i = 0; i < 50 && Math.Abs(at - before) > 1e-10; i++)
        {
            (before, at) = (at, ideal * (1.0 + (k * at * at)));
        }

        return at;
    }

    /// <summary>Newton's method for the two lenses that go from ideal to measured.</summary>
    private static (double X, double Y) Solved(CsmLens lens, double f, double x, double y)
    {
        (double atX, double atY, double step) = (x, y, 1e-5 * f);
        for (int i = 0; i < 50; i++)
        {
            (double X, double Y) here = Apply(lens, f, atX, atY);
            (double X, double Y) right = Apply(lens, f, atX + step, atY);
            (double X, double Y) below = Apply(lens, f, atX, atY + step);
            (double xx, double yx) = ((right.X - here.X) / step, (right.Y - here.Y) / step);
            (double xy, double yy) = ((below.X - here.X) / step, (below.Y - here.Y) / step);
            (double errorX, double errorY, double determinant) = (here.X - x, here.Y - y, (xx * yy) - (xy * yx));
            atX -= ((yy * errorX) - (xy * errorY)) / determinant;
            atY -= ((xx * errorY) - (yx * errorX)) / determinant;
        }

        return (atX, atY);
    }

    private static (double X, double Y) Tangential(double[] c, double x, double y)
    {
        double r2 = (x * x) + (y * y);
        double factor = 1.0 + (r2 * (c[0] + (r2 * (c[1] + (r2 * c[4])))));
        return (
            (x * factor) + (2.0 * c[2] * x * y) + (c[3] * (r2 + (2.0 * x * x))),
            (y * factor) + (c[2] * (r2 + (2.0 * y * y))) + (2.0 * c[3] * x * y));
    }

    private static (double X, double Y) Scaled(double f, (double X, double Y) point) => (f * point.X, f * point.Y);

    private static double Cubic(double[] a, double r) => a[0] + (r * (a[1] + (r * (a[2] + (r * a[3])))));

    private static double Dot(double[] c, double x, double y)
    {
        double[] terms = [1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y];
        return c.Zip(terms, (coefficient, term) => coefficient * term).Sum();
    }
}
