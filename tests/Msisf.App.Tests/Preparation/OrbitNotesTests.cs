using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.App.Tests.Settings;
using Xunit;

namespace Msisf.App.Tests.Preparation;

/// <summary>What the defaults of an orbit's frames cost is said where they are used.</summary>
public sealed class OrbitNotesTests
{
    private const string Orbit = "--kepler-set {1.9E6,0.05,0.7,1.1,0.9,2.0} --epoch 55289";

    // docs/deviations.md, row 22: 33 km and 1.1 degrees in two hours.
    [Theory]
    [InlineData($"{Orbit} --time 2010-04-03T02:00:00Z", "2 h from the epoch its ground track is off by 1.1 degrees, up to 33.3 km.")]
    [InlineData($"{Orbit} --time 2010-04-02T22:00:00Z", "2 h from the epoch")]
    [InlineData($"{Orbit} --time-interval [55289:1:55299]", "10 days from the epoch its ground track is off by 132 degrees, up to 4")]
    [InlineData($"{Orbit} --time 65289", "1E+04 days from the epoch its ground track is off by 366 turns of the Moon. ")]
    [InlineData($"{Orbit} --time 65289", "take --orbit-frame moon-me-epoch ")]
    public void Of_DefaultFrame_SaysWhatItCosts(string words, string message) =>
        Assert.Contains(message, Assert.Single(Of(words)), StringComparison.Ordinal);

    [Fact]
    public void Of_AttitudeInAnotherFrameThanTheOrbit_SaysInWhich() => Assert.Contains(
        "--attitude is taken in Moon axes that turn with the Moon (the default, --attitude-frame moon-me), the orbit in j2000.",
        Assert.Single(Of($"{Orbit} --time 55290 --orbit-frame j2000 --attitude {{0,0,0,1}}")),
        StringComparison.Ordinal);

    [Theory]
    [InlineData($"{Orbit} --time 55289")] // at the epoch nothing has turned yet
    [InlineData($"{Orbit} --time 55290 --orbit-frame moon-me")] // chosen
    [InlineData($"{Orbit} --time 55290 --orbit-frame j2000")]
    [InlineData($"{Orbit} --time 55290 --orbit-frame j2000 --attitude {{0,0,0,1}} --attitude-frame moon-me")]
    public void Of_NothingUnexpected_NoNote(string words) => Assert.Empty(Of(words));

    private static IEnumerable<string> Of(string words) => OrbitNotes.Of(
        (OrbitSettings)TrajectorySettingsReader.Read(Given.Options(words)));
}
