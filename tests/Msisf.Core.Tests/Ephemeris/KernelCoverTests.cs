using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class KernelCoverTests
{
    [Fact]
    public void Describe_PckOf1900To2050_RoundsInwardsToTheSecond()
    {
        // The ends of moon_pa_de421_1900-2050.bpc; CSPICE N0067, et2utc_c: 1899-12-31T23:59:18.816 and 2050-12-31T23:58:50.816.
        KernelCover cover = new(Moments.Naif0012, TdbCover.Union([new TdbInterval(-3155716800.0, 1609416000.0)]));

        Assert.Equal("1899-12-31T23:59:19Z to 2050-12-31T23:58:50Z", cover.Describe());
    }

    [Fact]
    public void Outside_TimeIn2060_NamesTimeAndCover()
    {
        KernelCover cover = new(Moments.Naif0012, TdbCover.Union([new TdbInterval(0.0, 86400.0), new TdbInterval(864000.0, 950400.0)]));

        SpiceException failure = cover.Outside(Moments.OfMjd(73459.5));

        Assert.Equal(
            "2060-01-01T12:00:00Z (MJD 73459.5) is outside the kernels' cover: "
                + "the kernels cover 2000-01-01T11:58:56Z to 2000-01-02T11:58:55Z"
            + " and 2000-01-11T11:58:56Z to 2000-01-12T11:58:55Z. Choose a time inside, or other kernels.",
            failure.Message);
        Assert.Equal(3, failure.ExitCode);
    }

    [Fact]
    public void LightFromOutside_FirstMinutes_NamesTimeCoverAndWayOut()
    {
        KernelCover cover = new(Moments.Naif0012, TdbCover.Union([new TdbInterval(0.0, 86400.0)]));

        Assert.Equal(
            "The sunlight of 2000-01-01T12:00:00Z (MJD 51544.5) left the Sun some 500 s earlier, outside the kernels' cover: "
                + "the kernels cover "
            + "2000-01-01T11:58:56Z to 2000-01-02T11:58:55Z. Choose a later time, other kernels, or --aberration none.",
            cover.LightFromOutside(Moments.OfMjd(51544.5)).Message);
    }

    /// <summary>2000-01-01T11:58:55.816 UTC is J2000 to the millisecond.</summary>
    [Theory]
    [InlineData(0.25, 0.25, "2000-01-01T11:58:56.066073Z")]
    [InlineData(0.25, 0.75, "2000-01-01T11:58:56.066073Z to 2000-01-01T11:58:56.566072Z")]
    [InlineData(0.15, 0.25, "2000-01-01T11:58:55.966073Z to 2000-01-01T11:58:56.066072Z")]
    [InlineData(0.15, 1.25, "2000-01-01T11:58:56Z to 2000-01-01T11:58:57Z")]
    public void Describe_ShortTime_NeverEndsBeforeItsBeginning(double start, double end, string expected) => Assert.Equal(
        expected, new KernelCover(Moments.Naif0012, TdbCover.Union([new TdbInterval(start, end)])).Describe());

    [Fact]
    public void Describe_ManyInstants_NamesSomeAndTheLast()
    {
        TdbCover cover = TdbCover.Union(Enumerable.Range(0, 500).Select(i => new TdbInterval(10.0 * i, 10.0 * i)));

        string text = new KernelCover(Moments.Naif0012, cover).Describe();

        Assert.StartsWith("2000-01-01T11:58:55.816073Z and 2000-01-01T11:59:05.816073Z and ", text, StringComparison.Ordinal);
        Assert.EndsWith(" and 494 more and 2000-01-01T13:22:05.816071Z", text, StringComparison.Ordinal);
    }

    [Fact]
    public void InstantNear_TimesAboutAnInstant_AreItWithinAMillisecond()
    {
        TdbCover cover = TdbCover.Union([new TdbInterval(10.0, 10.0), new TdbInterval(20.0, 30.0), new TdbInterval(40.0, 40.0)]);

        Assert.Equal(10.0, cover.InstantNear(10.0009));
        Assert.Equal(40.0, cover.InstantNear(39.9995));
        Assert.Null(cover.InstantNear(10.002));
        Assert.Null(cover.InstantNear(19.9999));
        Assert.Null(cover.InstantNear(25.0));
        Assert.Null(TdbCover.Empty.InstantNear(25.0));
    }

    [Fact]
    public void Describe_NoCommonTime_SaysWhatIsMissing() =>
        Assert.StartsWith("no time at all", new KernelCover(Moments.Naif0012, TdbCover.Empty).Describe(), StringComparison.Ordinal);

    [Fact]
    public void Describe_LongerThanTheCalendar_StaysInTheCalendar()
    {
        KernelCover cover = new(Moments.Naif0012, TdbCover.Union([new TdbInterval(-5e12, 5e12)]));

        Assert.Equal("0001-01-01T00:00:00Z to 9999-12-31T23:59:59Z", cover.Describe());
    }
}
