using Msisf.Adapters.Ephemeris;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

public sealed class LunarOrientationTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private static IReadOnlyList<string> Installed => KernelList.Expand([Path.Combine(TestParts.Kernels, "msisf.tm")]);

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Of_InstalledKernels_NamesWhatGivesTheFrame()
    {
        using KernelCatalogue catalogue = new(Installed);

        Assert.Equal("orientation 31006 of moon_pa_de421_1900-2050.bpc, by moon_080317.tf", LunarOrientation.Of(catalogue));
    }

    [Fact]
    public void Of_SameKernelsTwice_IsNoContradiction()
    {
        using KernelCatalogue catalogue = new([.. Installed, .. Installed]);

        Assert.StartsWith("orientation 31006", LunarOrientation.Of(catalogue), StringComparison.Ordinal);
    }

    [Fact]
    public void Of_FrameKernelOfAnotherEphemeris_IsRefused()
    {
        string other = _folder.Write("moon_de440.tf", "KPL/FK\n\\begindata\nTKFRAME_31007_ANGLES = ( 67.93, 78.57, 0.30 )\n");

        AssertRefused(other, "Two kernels define MOON_ME differently: TKFRAME_31007_ANGLES is set in ", "moon_de440.tf, line 3");
    }

    [Fact]
    public void Of_SecondOrientationOfTheMoon_IsRefused()
    {
        string other = _folder.Write("de440.bpc", new DafBuilder("DAF/PCK").AddPck(31008, 0.0, 1e6, [1.0, 0.4, 3.0]).ToArray());

        AssertRefused(other, "de440.bpc has a second orientation of the Moon (31008); MOON_ME is defined by 31006.", "Leave out");
    }

    [Fact]
    public void Of_OtherAnglesUnderTheSameNumber_AreRefused()
    {
        string other = _folder.Write("edited.bpc", new DafBuilder("DAF/PCK").AddPck(31006, 0.0, 1e6, [1.0, 0.4, 3.0]).ToArray());

        AssertRefused(other, "have different orientations of the Moon", "edited.bpc");
    }

    private static void AssertRefused(string other, params string[] expected)
    {
        using KernelCatalogue catalogue = new([.. Installed, other]);
        BadInputException failure = Assert.Throws<BadInputException>(() => LunarOrientation.Of(catalogue));
        Assert.All(expected, part => Assert.Contains(part, failure.Message, StringComparison.Ordinal));
    }
}
