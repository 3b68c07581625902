using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Time;
using Xunit;

namespace Msisf.Core.Tests.Ephemeris;

public class KernelCoverTests
{
    [Fact]
    public void Describe_PckOf1900To2050_RoundsInwardsToTheSecond()
    {
        // The ends of moon_pa_de421_1900-2050.bpc; CSPICE N0067, et2utc_c: 1899-12-31T23:59:18.816 and 2050-12-31T23:58:50.816.
        KernelCover cover = new(SampleScale.Naif0012, TdbCover.Union([new TdbInterval(-3155716800.0, 1609416000.0)]));

        Assert.Equal("1899-12-31T23:59:19Z to 2050-12-31T23:58:50Z", cover.Describe());
    }

    [Fact]
    public void Outside_TimeIn2060_NamesTimeAndCover()
    {
        KernelCover cover = new(SampleScale.Naif0012, TdbCover.Union([new TdbInterval(0.0, 86400.0), new TdbInterval(864000.0, 950400.0)]));

        SpiceException failure = cover.Outside(new ModifiedJulianDate(73459.5));

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
        KernelCover cover = new(SampleScale.Naif0012, TdbCover.Union([new TdbInterval(0.0, 86400.0)]));

        Assert.Equal(
            "The sunlight of 2000-01-01T12:00:00Z (MJD 51544.5) left the Sun some 500 s earlier, outside the kernels' cover: "
                + "the kernels cover "
            + "2000-01-01T11:58:56Z to 2000-01-02T11:58:55Z. Choose a later time, other kernels, or --aberration none.",
            cover.LightFromOutside(new ModifiedJulianDate(51544.5)).Message);
    }

    [Fact]
    public void Describe_NoCommonTime_SaysWhatIsMissing() =>
        Assert.StartsWith("no time at all", new KernelCover(SampleScale.Naif0012, TdbCover.Empty).Describe(), StringComparison.Ordinal);

    [Fact]
    public void Describe_LongerThanTheCalendar_StaysInTheCalendar()
    {
        KernelCover cover = new(SampleScale.Naif0012, TdbCover.Union([new TdbInterval(-5e12, 5e12)]));

        Assert.Equal("0001-01-01T00:00:00Z to 9999-12-31T23:59:59Z", cover.Describe());
    }
}
