using Msisf.App.Illumination;
using Msisf.Core.Time;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Illumination;

public sealed class PointSpanTests
{
    private static readonly (bool IsRise, Instant Time)[] SetAndRise =
        [(false, Moments.OfMjd(60000.5)), (true, Moments.OfMjd(60003.0))];

    [Fact]
    public void Of_SunsetAndSunrise_AreThreeSpansInTurn() => Assert.Equal(
        [
            new PointSpan(true, Moments.OfMjd(60000.0), Moments.OfMjd(60000.5)),
            new PointSpan(false, Moments.OfMjd(60000.5), Moments.OfMjd(60003.0)),
            new PointSpan(true, Moments.OfMjd(60003.0), Moments.OfMjd(60004.0)),
        ],
        PointSpan.Of(Days(60000.0, 60004.0), isLit: true, SetAndRise));

    [Fact]
    public void Of_NoEvent_IsOneSpan() =>
        Assert.Equal(
            [new PointSpan(false, Moments.OfMjd(60000.0), Moments.OfMjd(60001.0))],
            PointSpan.Of(Days(60000.0, 60001.0), isLit: false, []));

    [Fact]
    public void LongestOf_EachKind_IsInHours()
    {
        PointSpan[] spans = PointSpan.Of(Days(60000.0, 60004.0), isLit: true, SetAndRise);

        Assert.Equal(24.0, PointSpan.LongestOf(spans, isLit: true)!.Value.Hours);
        Assert.Equal(60.0, PointSpan.LongestOf(spans, isLit: false)!.Value.Hours);
        Assert.Null(PointSpan.LongestOf(spans[..1], isLit: false));
    }

    private static Instant[] Days(double start, double end) => [Moments.OfMjd(start), Moments.OfMjd(end)];
}
