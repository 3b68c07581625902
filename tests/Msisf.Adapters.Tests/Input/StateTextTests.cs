using Msisf.Adapters.Input;
using Msisf.Core.Errors;
using Msisf.Core.Time;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public class StateTextTests
{
    private static readonly string[] RateFields = ["dpx", "dpy", "dpz"];

    [Theory]
    [InlineData("{1,-2.5,3E2}")]
    [InlineData("{ 1 , -2.5,\t3E2 }")]
    [InlineData("{1,", "-2.5,", "3E2}")] // cut at blanks
    [InlineData("1", "-2.5", "3E2")] // braces expanded by the shell
    [InlineData("1 -2.5 3E2")] // expanded, then quoted
    [InlineData("1,-2.5,3E2")]
    [InlineData("{", "1,-2.5,3E2", "}")]
    public void ParseNumbers_AnyShell_MeansTheSame(params string[] words) =>
        Assert.Equal([1.0, -2.5, 300.0], StateText.ParseNumbers("--rate", words, RateFields));

    [Theory]
    [InlineData("--rate: 2 numbers, 3 expected: {dpx,dpy,dpz}. Commas separate the numbers, decimals take a point.", "{1,2}")]
    [InlineData("--rate: 4 numbers, 3 expected", "{1,5,2,3}")]
    [InlineData("--rate: 1 number, 3 expected", "1")]
    [InlineData("--rate: 0 numbers, 3 expected", "{}")]
    [InlineData("--rate: 0 numbers, 3 expected")]
    [InlineData("--rate, number 2 (dpy): a number is missing.", "{1,,3}")]
    [InlineData("--rate, number 3 (dpz): a number is missing.", "{1,2,}")]
    [InlineData("--rate, number 1 (dpx): 'a' is not a number; write", "{a,2,3}")]
    [InlineData("--rate, number 2 (dpy): 'NaN' is not finite", "1", "NaN", "3")]
    [InlineData("--rate, number 2 (dpy): '2;5' is not a number", "{1,2;5,3}")]
    [InlineData("--rate: 2 numbers, 3 expected", "{1 2,3}")]
    [InlineData(
        "--rate: '{1,2,3' has unbalanced '{' and '}'; {dpx,dpy,dpz} is expected, quoted so that the shell leaves it alone.", "{1,2,3")]
    [InlineData("--rate: '1,2,3}' has unbalanced", "1,2,3}")]
    [InlineData("--rate: '{{1,2,3}}' has unbalanced", "{{1,2,3}}")]
    [InlineData("--rate: '{1},{2},{3}' has unbalanced", "{1},{2},{3}")]
    [InlineData("--rate: '{' has unbalanced", "{")]
    [InlineData("--rate, number 1 (dpx): '[1' is not a number", "[1,2,3]")]
    public void ParseNumbers_Wrong_NamesOptionAndField(string message, params string[] words) =>
        Assert.StartsWith(
            message,
            Assert.Throws<BadInputException>(() => StateText.ParseNumbers("--rate", words, RateFields)).Message,
            StringComparison.Ordinal);

    [Theory]
    [InlineData(1, "{55289}")]
    [InlineData(1, "55289")]
    [InlineData(3, "{55289,55290.5,55291}")]
    [InlineData(3, "55289", "55290.5", "55291")]
    public void ParseList_OneOrMore_AllOfThem(int count, params string[] words)
    {
        double[] times = StateText.ParseList("--times", words, "MJD");
        Assert.Equal(new[] { 55289.0, 55290.5, 55291.0 }[..count], times);
    }

    [Theory]
    [InlineData("--times: the list is empty; {MJD1,MJD2,...} is expected.", "{ }")]
    [InlineData("--times, number 2 (MJD2): '1e999' is too large", "{55289,1e999}")]
    [InlineData("--times, number 3 (MJD3): a number is missing", "{55289,55290,}")]
    public void ParseList_Wrong_NamesOptionAndPlace(string message, params string[] words) =>
        Assert.StartsWith(
            message,
            Assert.Throws<BadInputException>(() => StateText.ParseList("--times", words, "MJD")).Message,
            StringComparison.Ordinal);

    [Theory]
    [InlineData("[55289:0.25:55290]")]
    [InlineData("[ 55289 : 0.25 : 55290 ]")]
    [InlineData("[55289:", "2.5E-1", ":55290]")]
    [InlineData("55289:+0.25:55290")]
    public void ParseInterval_StartStepEnd_MatlabsColon(params string[] words)
    {
        TimeInterval interval = StateText.ParseInterval("--time-interval", words);
        Assert.Equal([55289.0, 55289.25, 55289.5, 55289.75, 55290.0], interval.Select(time => time.Mjd));
    }

    [Theory]
    [InlineData("[55289:21600s:55290]")]
    [InlineData("[55289:360min:55290]")]
    [InlineData("[55289:6h:55290]")]
    [InlineData("55289:0.25 d:55290")]
    public void ParseInterval_StepWithUnit_IsInDays(string text) => Assert.Equal(
        [55289.0, 55289.25, 55289.5, 55289.75, 55290.0], StateText.ParseInterval("--time-interval", [text]).Select(time => time.Mjd));

    // 2024-01-19T12:00:00Z is MJD 60328.5 (TimeTextTests).
    [Theory]
    [InlineData("[2024-01-19T12:00:00Z:0.5:2024-01-20T12:00:00Z]")]
    [InlineData("2024-01-19T12:00:00Z:0.5:60329.5")]
    [InlineData("[60328.5:0.5:2024-01-20T14:00:00.0+02:00]")]
    [InlineData("[ 2024-01-19T14:00+02:00 : 0.5 : 2024-020T12:00Z ]")]
    [InlineData("[2024-01-19T14:00:00+0200:0.5:2024-01-20T12:00Z]")]
    public void ParseInterval_CalendarTimes_AreThoseOfTheirMjd(string text) => Assert.Equal(
        [60328.5, 60329.0, 60329.5], StateText.ParseInterval("--time-interval", [text]).Select(time => time.Mjd));

    [Fact]
    public void ParseState_Time_TakesCalendarTimes()
    {
        (CalendarTime time, double[] numbers) = StateText.ParseState("--state", ["{2024-01-19T12:00:00Z,7}"], ["MJD", "rx"]);
        Assert.Equal(60328.5, time.Mjd);
        Assert.Equal([7.0], numbers);
        Assert.Equal([60328.5, 55289.0], StateText.ParseTimes("--times", ["2024-01-19T12:00:00Z", "55289"]).Select(each => each.Mjd));
        Assert.StartsWith(
            "--state, number 2 (rx): '2024-01-19T12:00:00Z' is not a number",
            Assert.Throws<BadInputException>(
                () => StateText.ParseState("--state", ["{1,2024-01-19T12:00:00Z}"], ["MJD", "rx"])).Message,
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--time-interval: 7 numbers, 3 expected", "[2024-01-19T12:00:00:0.5:2024-01-20T12:00:00]")]
    [InlineData("--time-interval, number 2 (step): '2024-01-19T12:00:00Z' is not a number", "[1:2024-01-19T12:00:00Z:2]")]
    [InlineData("--time-interval, number 3 (end): '2460329' looks like a Julian Date; its MJD is 60328.5", "[60328:1:2460329]")]
    [InlineData(
        "--time-interval: The time interval begins in a leap second", "[2016-12-31T23:59:60Z:1:60329]")]
    public void ParseInterval_WrongCalendarTimes_SaysWhatToWrite(string message, string text) => Assert.StartsWith(
        message,
        Assert.Throws<BadInputException>(() => StateText.ParseInterval("--time-interval", [text])).Message,
        StringComparison.Ordinal);

    [Theory]
    [InlineData(
        "--time-interval: 2 numbers, 3 expected: [start:step:end] in MJD, days (or 10s, 5min, 2h), MJD; colons separate the numbers.",
        "[55289:55290]")]
    [InlineData("--time-interval: 1 number, 3 expected", "[55289,0.1,55290]")]
    [InlineData("--time-interval, number 2 (step): a number is missing.", "[55289::55290]")]
    [InlineData("--time-interval, number 3 (end): '00;00' is not", "[55289:1:00;00]")]
    [InlineData("--time-interval, number 2 (step): a number is missing", "[55289:s:55290]")]
    [InlineData("--time-interval, number 2 (step): '10m' is not a number", "[55289:10m:55290]")]
    [InlineData("--time-interval: '[55289:1:55290' has unbalanced '[' and ']'", "[55289:1:55290")]
    [InlineData("--time-interval: The step of the time interval is 0 days", "[55289:0:55290]")]
    [InlineData("--time-interval, number 1 (start): The MJD 5528900 is not a date", "[5528900:1:55290]")]
    public void ParseInterval_Wrong_NamesOptionAndPlace(string message, params string[] words) =>
        Assert.StartsWith(
            message,
            Assert.Throws<BadInputException>(() => StateText.ParseInterval("--time-interval", words)).Message,
            StringComparison.Ordinal);
}
