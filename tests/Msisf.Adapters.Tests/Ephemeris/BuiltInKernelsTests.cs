using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

public sealed class BuiltInKernelsTests : IDisposable
{
    private const double Day = 86400.0;
    private readonly TemporaryFolder _folder = new();

    private static string Lsk => Path.Combine(TestParts.Kernels, "naif0012.tls");

    private static string Fk => Path.Combine(TestParts.Kernels, "moon_080317.tf");

    public void Dispose() => _folder.Dispose();

    // tests/reference/ephemeris.py, CSPICE N0067. utc2et_c may round a time to the neighbouring double, which turns the Sun by 1.3e-12 in
    // 1900.
    [Theory]
    [InlineData(55289.0, 1.074955473280883E+11, -1.042430734878975E+11, 4.036164305561261E+09)]
    [InlineData(15020.0, -1.465028045921120E+11, -8.047417975708220E+09, 1.317699260302871E+09)]
    [InlineData(33447.5, -1.514823536644676E+11, 3.361237775372025E+09, 4.072551833814494E+09)]
    [InlineData(70171.0, 1.290098437583221E+11, -7.128088901058037E+10, 3.575734496054910E+09)]
    public void SunPositionMoonMe_ShippedKernels_IsCSpices(double mjd, double x, double y, double z)
    {
        using BuiltInKernels kernels = new(KernelList.Expand([Path.Combine(TestParts.Kernels, "msisf.tm")]));

        Vector3D sun = kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(mjd));

        // At 55289, a whole day, CSPICE has the nearest double: half of its step of 6e-8 s is 1 mm of the Sun's way; elsewhere see above.
        Assert.InRange((sun - new Vector3D(x, y, z)).Length / sun.Length, 0.0, mjd == 55289.0 ? 1e-14 : 2e-12);
    }

    // tests/reference/sun_aberration.py: a reader of its own, 40 digits. TDB as a double is rounded by up to 0.24 microseconds in 1900, 0.1
    // m of the Sun's way.
    [Theory]
    [InlineData(55289.0, Aberration.None, 107495547328.10955, -104243073487.87562, 4036164305.5612552)]
    [InlineData(55289.0, Aberration.LightTime, 107495552584.33277, -104243072240.34128, 4036164348.1696652)]
    [InlineData(55289.0, Aberration.LightTimeAndStellar, 107484946064.26609, -104254008175.25747, 4036174812.4498082)]
    [InlineData(15021.0, Aberration.None, -144899773050.3998, 23068662894.97253, 1383171535.6831909)]
    [InlineData(15021.0, Aberration.LightTime, -144899778320.07427, 23068658274.460285, 1383171563.8543751)]
    [InlineData(15021.0, Aberration.LightTimeAndStellar, -144897530579.96047, 23082791102.444086, 1382860121.5937862)]
    [InlineData(33447.5, Aberration.LightTime, -151482357955.2543, 3361240482.6960928, 4072551880.4167607)]
    [InlineData(33447.5, Aberration.LightTimeAndStellar, -151482041052.37138, 3375565363.3400181, 4072491273.2241893)]
    [InlineData(52000.123456789, Aberration.LightTime, 1347603610.8659327, 149408027998.20195, -3968171292.1920138)]
    [InlineData(52000.123456789, Aberration.LightTimeAndStellar, 1362446716.2003092, 149407894625.39335, -3968124463.8447728)]
    [InlineData(57754.0, Aberration.LightTime, -117988310370.76381, 87231924440.16131, 3305399267.9933829)]
    [InlineData(57754.0, Aberration.LightTimeAndStellar, -117979733405.02962, 87243517746.397364, 3305572100.9744199)]
    [InlineData(70171.0, Aberration.LightTime, 129009845303.3278, -71280893659.32635, 3575734584.9533883)]
    [InlineData(70171.0, Aberration.LightTimeAndStellar, 129002446335.89379, -71294293255.563085, 3575535264.4617218)]
    public void SunPositionMoonMe_WithAberration_IsTheReferences(double mjd, Aberration aberration, double x, double y, double z)
    {
        using BuiltInKernels kernels = new(KernelList.Expand([Path.Combine(TestParts.Kernels, "msisf.tm")]));

        Vector3D sun = kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(mjd), aberration);

        Assert.InRange((sun - new Vector3D(x, y, z)).Length / sun.Length, 0.0, 2e-12);
    }

    [Fact]
    public void BodyFromJ2000_ShippedKernels_IsCSpices()
    {
        using BuiltInKernels kernels = new(KernelList.Expand([Path.Combine(TestParts.Kernels, "msisf.tm")]));

        RotationMatrix rotation = kernels.Ephemeris.BodyFromJ2000(kernels.Ephemeris.TimeScale.InstantOfMjd(55289.0).Tdb);

        Assert.Equal(
            0.0, (rotation.Row0 - new Vector3D(0.5411226728469083, 0.7793513872318866, 0.3159076892871575)).Length, Rounding.OfUnits);
        Assert.Equal(
            0.0, (rotation.Row1 - new Vector3D(-0.8405477223153277, 0.4897273771791698, 0.2316174055457097)).Length, Rounding.OfUnits);
        Assert.Equal(
            0.0, (rotation.Row2 - new Vector3D(0.025802702213767535, -0.3908689182589793, 0.9200846207265518)).Length, Rounding.OfUnits);
    }

    [Theory]
    [InlineData(15019.999, "1899-12-31T23:58:33.6Z")]
    [InlineData(70172.0, "2051-01-01T00:00:00Z")]
    public void SunPositionMoonMe_OutsideTheShippedKernels_NamesTheCover(double mjd, string time)
    {
        using BuiltInKernels kernels = new(KernelList.Expand([Path.Combine(TestParts.Kernels, "msisf.tm")]));

        SpiceException failure = Assert.Throws<SpiceException>(
            () => kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(mjd)));

        Assert.StartsWith(time, failure.Message, StringComparison.Ordinal);
        Assert.Contains("the kernels cover 1899-12-31T23:59:19Z to 2050-12-31T23:58:50Z", failure.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(2, false)]
    [InlineData(2, true)]
    [InlineData(3, false)]
    [InlineData(3, true)]
    public void SunPositionMoonMe_SpkType2And3InEitherByteOrder_AreReadAlike(int type, bool bigEndian)
    {
        // From -1 day in two records of 2 days: TDB = 0 is the middle of the first, TDB = +1.5 days a quarter into the second.
        byte[] spk = new DafBuilder("DAF/SPK", bigEndian)
            .AddSpk(10, 0, -Day, 2.0 * Day, type, [100.0, 200.0, 300.0], [400.0, 500.0, 600.0])
            .AddSpk(301, 0, -Day, 4.0 * Day, type, [0.0, 0.0, 0.0])
            .ToArray();
        using BuiltInKernels kernels = Open(spk, bigEndian);

        // The sample scale below puts TDB = UTC + 0 s, and the series rise by 1 km from a record's middle to its end.
        Assert.Equal(new Vector3D(100_500.0, 200_500.0, 300_500.0),
            kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(51544.5)));
        Assert.Equal(new Vector3D(399_250.0, 499_250.0, 599_250.0),
            kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(51546.0)));
    }

    [Theory]
    [InlineData(2, 1.0 / Day)]
    [InlineData(3, 99.0)]
    public void SunPositionMoonMe_StellarAberration_TakesTheVelocitiesOfType3AndTheSlopesOfType2(int type, double kilometresPerSecond)
    {
        byte[] spk = new DafBuilder("DAF/SPK")
            .AddSpk(10, 0, -Day, 2.0 * Day, type, [1e6, 0.0, 0.0])
            .AddSpk(301, 0, -Day, 2.0 * Day, type, [0.0, 0.0, 0.0])
            .ToArray();
        using BuiltInKernels kernels = Open(spk, bigEndian: false);

        // At a record's middle, seen along x: y and z are v/c of the distance.
        Vector3D sun = kernels.Ephemeris.SunPositionBodyFixed(
            kernels.Ephemeris.TimeScale.InstantOfMjd(51544.5), Aberration.LightTimeAndStellar)
            - kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(51544.5), Aberration.LightTime);
        Assert.Equal(1e9 * kilometresPerSecond / 299_792.458, sun.Y, 1e-3 * kilometresPerSecond * 1e3);
        Assert.Equal(sun.Y, sun.Z, 1e-3);
    }

    [Fact]
    public void SunPositionMoonMe_EndOfTheLastRecord_IsHeld()
    {
        byte[] spk = new DafBuilder("DAF/SPK").AddSpk(
            10, 0, -Day, 2.0 * Day, 2, [100.0, 200.0, 300.0]).AddSpk(301, 0, -Day, 2.0 * Day, 2, [0.0, 0.0, 0.0]).ToArray();
        using BuiltInKernels kernels = Open(spk, bigEndian: false);

        Assert.Equal(new Vector3D(100_000.0, 200_000.0, 300_000.0),
            kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(51545.5)));
    }

    [Fact]
    public void SunPositionMoonMe_TwoKernelsHoldTheSun_TheLaterWins()
    {
        string early = _folder.Write(
            "early.bsp",
            new DafBuilder("DAF/SPK").AddSpk(10, 0, -Day, 2.0 * Day, 2, [1.0, 1.0, 1.0]).AddSpk(
                301, 0, -Day, 2.0 * Day, 2, [0.0, 0.0, 0.0]).ToArray());
        string late = _folder.Write("late.bsp", new DafBuilder("DAF/SPK").AddSpk(10, 0, -Day, 2.0 * Day, 2, [2.0, 2.0, 2.0]).ToArray());
        using BuiltInKernels lateWins = new([.. Frames(bigEndian: false), early, late]);
        using BuiltInKernels earlyWins = new([.. Frames(bigEndian: false), late, early]);

        Assert.Equal(2000.0, lateWins.Ephemeris.SunPositionBodyFixed(Moments.OfMjd(51544.5)).X);
        Assert.Equal(1000.0, earlyWins.Ephemeris.SunPositionBodyFixed(Moments.OfMjd(51544.5)).X);
    }

    [Fact]
    public void SunPositionMoonMe_SpkTypeUnknown_FailsOnlyWhenNeeded()
    {
        byte[] spk = new DafBuilder("DAF/SPK")
            .AddRaw(-Day, Day, [10, 0, 1, 20], [0.0])
            .AddRaw(-Day, Day, [-85, 301, 1, 17], [0.0])
            .AddSpk(301, 0, -Day, 2.0 * Day, 2, [0.0, 0.0, 0.0]).ToArray();
        using BuiltInKernels kernels = Open(spk, bigEndian: false);

        SpiceException failure = Assert.Throws<SpiceException>(() =>
            kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(51544.5)));

        Assert.Contains("body 10 is given by SPK type 20", failure.Message, StringComparison.Ordinal);
        Assert.True(kernels.Ephemeris.BodyFromJ2000(kernels.Ephemeris.TimeScale.InstantOfMjd(51544.5).Tdb).Row0.IsFinite);
    }

    [Theory]
    [InlineData(2.0, 7.0, "does not fit its size")]
    [InlineData(0.0, 8.0, "does not fit its size")]
    [InlineData(double.NaN, 8.0, "does not fit its size")]
    public void Open_DirectoryContradictsSize_IsDamaged(double recordSeconds, double size, string expected)
    {
        byte[] spk = new DafBuilder("DAF/SPK").AddRaw(
            0.0, 2.0, [10, 0, 1, 2], [1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, recordSeconds, size, 1.0]).ToArray();

        Assert.Contains(expected, Assert.Throws<BadInputException>(() => Open(spk, bigEndian: false)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(double.NaN, 1.0, "not finite")]
    [InlineData(0.0, 0.0, "has no length")]
    public void SunPositionMoonMe_RecordDamaged_SaysWhich(double coefficient, double halfLength, string expected)
    {
        byte[] spk = new DafBuilder("DAF/SPK")
            .AddRaw(-Day, Day, [10, 0, 1, 2], [0.0, halfLength, coefficient, 0.0, 0.0, -Day, 2.0 * Day, 5.0, 1.0]).ToArray();
        using BuiltInKernels kernels = Open(spk, bigEndian: false);

        BadInputException failure = Assert.Throws<BadInputException>(
            () => kernels.Ephemeris.SunPositionBodyFixed(kernels.Ephemeris.TimeScale.InstantOfMjd(51544.5)));

        Assert.Contains(expected, failure.Message, StringComparison.Ordinal);
        Assert.Contains("body 10", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_NoLeapSeconds_SaysWhatIsMissing() => Assert.Contains(
        "DELTET/DELTA_AT", Assert.Throws<BadInputException>(() => new BuiltInKernels([Fk])).Message, StringComparison.Ordinal);

    [Fact]
    public void Open_NoFrameKernel_SaysWhatIsMissing() => Assert.Contains(
        "MOON_ME", Assert.Throws<BadInputException>(() => new BuiltInKernels([Lsk])).Message, StringComparison.Ordinal);

    [Theory]
    [InlineData("NAIF/DAF garbage", "neither a text kernel nor a binary SPK, CK or PCK")]
    [InlineData("DAFETF NAIF DAF ENCODED TRANSFER FILE", "neither a text kernel")]
    [InlineData("\0\0\u0001\u0002binary", "neither a text kernel")]
    [InlineData("<html>not found</html>", "no line \\begindata")]
    [InlineData("", "the file is empty")]
    public void Open_NotAKernel_SaysSo(string content, string expected) => Assert.Contains(
        expected,
        Assert.Throws<BadInputException>(() => new BuiltInKernels([Lsk, Fk, _folder.Write("x.bin", content)])).Message,
        StringComparison.Ordinal);

    [Fact]
    public void Open_ShapeKernel_IsPassedOver()
    {
        string shape = _folder.Write("x.bds", "DAS/DSK and so on");
        using BuiltInKernels kernels = new([Lsk, Fk, shape]);

        Assert.Empty(kernels.Ephemeris.Cover.Times.Intervals);
    }

    [Fact]
    public void SunPositionMoonMe_ManyThreads_GiveTheSameBitsAsOne()
    {
        double[] times = [.. Enumerable.Range(0, 2000).Select(i => 15021.0 + (i * 27.5))];
        IReadOnlyList<string> paths = KernelList.Expand([Path.Combine(TestParts.Kernels, "msisf.tm")]);
        using BuiltInKernels one = new(paths);
        using BuiltInKernels many = new(paths);
        Vector3D[] expected = [.. times.Select(time => one.Ephemeris.SunPositionBodyFixed(Moments.OfMjd(time)))];
        Vector3D[] found = new Vector3D[times.Length];

        // Eight loops over the same times, so that threads meet at records that none has read.
        Parallel.For(0, 8 * times.Length, new ParallelOptions { MaxDegreeOfParallelism = 8 }, i =>
        {
            int k = i % times.Length;
            found[k] = many.Ephemeris.SunPositionBodyFixed(Moments.OfMjd(times[k]));
        });

        Assert.Equal(expected, found);
    }

    /// <summary>A scale without offset, MOON_ME = PA, and a PCK that turns nothing (its angles are 0 at a record's middle).</summary>
    private string[] Frames(bool bigEndian) =>
    [
        _folder.Write(
            "flat.tls",
            "KPL/LSK\n\\begindata\nDELTET/DELTA_T_A = 0\nDELTET/K = 0\nDELTET/EB = 0\nDELTET/M = ( 0 0 )\nDELTET/DELTA_AT = ( 0, "
                + "@1000-JAN-1 )\n"),
        _folder.Write("flat.tf", "KPL/FK\n\\begindata\nFRAME_MOON_ME = 7\nFRAME_7_CLASS = 2\nFRAME_7_CLASS_ID = 31006\n"),
        _folder.Write(
            "flat.bpc",
            new DafBuilder("DAF/PCK", bigEndian).AddRaw(
                -9.0 * Day, 9.0 * Day, [31006, 1, 2], [0.0, 9.0 * Day, 0.0, 0.0, 0.0, -9.0 * Day, 18.0 * Day, 5.0, 1.0]).ToArray()),
    ];

    private BuiltInKernels Open(byte[] spk, bool bigEndian) => new([.. Frames(bigEndian), _folder.Write("sample.bsp", spk)]);
}
