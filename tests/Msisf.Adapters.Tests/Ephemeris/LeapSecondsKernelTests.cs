using Msisf.Adapters.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

public class LeapSecondsKernelTests
{
    private const string Constants =
        "DELTET/DELTA_T_A = 32.184\nDELTET/K = 1.657D-3\nDELTET/EB = 1.671D-2\nDELTET/M = ( 6.239996D0 1.99096871D-7 )\n";

    [Fact]
    public void ReadScale_TwoEntries_TurnsUtcIntoTdb()
    {
        var scale = LeapSecondsKernel.ReadScale(SamplePool.Of(Constants + "DELTET/DELTA_AT = ( 10, @1972-JAN-1 11, @1972-JUL-1 )"));

        // tests/reference/ephemeris.py, CSPICE N0067: 1972-07-01, at the second entry.
        Assert.Equal(-867931156.8159056, scale.InstantOfMjd(41499.0).Tdb.Seconds, 3e-7);
    }

    [Theory]
    [InlineData("", "DELTET/DELTA_AT")]
    [InlineData("DELTET/DELTA_AT = ( 10, @1972-JAN-1 11 )", "must be pairs")]
    [InlineData("DELTET/DELTA_AT = ( 'x' )", "must be pairs")]
    [InlineData("DELTET/DELTA_AT = ( 10, @1972-JUL-1 11, @1972-JAN-1 )", "must rise; pair 2")]
    [InlineData("DELTET/DELTA_AT = ( 10, @1972-JAN-1 )\nDELTET/M = 6", "DELTET/M has 1 numbers, 2 expected")]
    public void ReadScale_Wrong_SaysWhat(string table, string expected)
    {
        BadInputException failure = Assert.Throws<BadInputException>(() => LeapSecondsKernel.ReadScale(SamplePool.Of(Constants + table)));

        Assert.Contains(expected, failure.Message, StringComparison.Ordinal);
    }
}
