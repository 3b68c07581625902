using Msisf.Adapters.Manifest;
using Xunit;

namespace Msisf.Adapters.Tests.Manifest;

public class SettingsDifferenceTests
{
    private const string Made = """
        {"version":"1.0.0","arguments":"--fov 60 --width 24 --renderer native --samples 4","model":{"product":"LDEM_4","bytes":1,
        "sha256_of_parts":"00112233445566"},"ephemeris":"built-in 1","kernels":[{"name":"a.tls","sha256":"aa"},
        {"name":"b.bsp","sha256":"bb"}],"povray":null}
        """;

    [Theory]
    [InlineData("--fov 60", "--fov 30", "--fov 60, now 30")]
    [InlineData(" --samples 4", "", "--samples 4, now without it")]
    [InlineData("--fov 60", "--fov 60 --ignore-sun", "no --ignore-sun, now with it")]
    [InlineData("--fov 60", "--fov 60 --albedo 0.2", "no --albedo, now 0.2")]
    [InlineData("\"version\":\"1.0.0\"", "\"version\":\"1.1.0\"", "msis 1.0.0, now 1.1.0")]
    [InlineData("LDEM_4", "LDEM_16", "elevation model LDEM_4, now LDEM_16")]
    [InlineData("00112233445566", "ff112233445566", "another LDEM_4 (checksum 001122334455..., now ff1122334455...)")]
    [InlineData("built-in 1", "CSPICE N0067", "ephemeris built-in 1, now CSPICE N0067")]
    [InlineData("\"bb\"", "\"cc\"", "another b.bsp (checksum bb..., now cc...)")]
    [InlineData("b.bsp", "c.bsp", "b.bsp, now without it; no c.bsp, now with it")]
    [InlineData("\"povray\":null", "\"povray\":\"3.7\"", "no POV-Ray, now 3.7")]
    public void Reason_OneDifference_NamesIt(string made, string wanted, string difference) =>
        Assert.Equal($"made with {difference}", Reason(Made, Made.Replace(made, wanted, StringComparison.Ordinal)));

    [Fact]
    public void Reason_SeveralDifferences_NamesEach() => Assert.Equal(
        "made with msis 1.0.0, now 1.1.0; --fov 60, now 30; --width 24, now 48",
        Reason(Made, Made.Replace("1.0.0", "1.1.0", StringComparison.Ordinal)
            .Replace("--fov 60 --width 24", "--fov 30 --width 48", StringComparison.Ordinal)));

    [Fact]
    public void Reason_OtherRenderer_LeavesOutWhatOnlyOneOfThemHas() => Assert.Equal(
        "made with --renderer native, now povray; no POV-Ray, now 3.7",
        Reason(Made, Made.Replace("native --samples 4", "povray", StringComparison.Ordinal)
            .Replace("\"povray\":null", "\"povray\":\"3.7\"", StringComparison.Ordinal)));

    [Fact]
    public void Reason_ValueInQuotes_IsOneValue() => Assert.Equal(
        "made with no --pov-options, now '+A0.3 --x y'",
        Reason(Made, Made.Replace("--fov 60", "--fov 60 --pov-options '+A0.3 --x y'", StringComparison.Ordinal)));

    [Fact]
    public void Reason_SameSettings_IsTheState() => Assert.Equal(
        "made for another time, position, orientation, motion or noise",
        SettingsDifference.Reason(new SettingsRecord("s", Made), new SettingsRecord("s", Made)));

    [Fact]
    public void Reason_SettingsThatTheManifestLacks_SaysLess() => Assert.Equal(
        "made with other settings, or from another state", SettingsDifference.Reason(null, new SettingsRecord("s", Made)));

    [Theory]
    [InlineData("{}")]
    [InlineData("{\"version\":1,\"model\":[],\"kernels\":{\"a\":1},\"arguments\":null}")]
    public void Reason_DescriptionOfAnotherForm_DoesNotFail(string other) =>
        Assert.StartsWith("made with ", Reason(other, Made), StringComparison.Ordinal);

    private static string Reason(string made, string wanted) =>
        SettingsDifference.Reason(new SettingsRecord("old", made), new SettingsRecord("new", wanted));
}
