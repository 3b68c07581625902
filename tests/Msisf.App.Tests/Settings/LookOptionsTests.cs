using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Settings;

/// <summary>Looks stand for their options, of which any can be given.</summary>
public class LookOptionsTests
{
    [Theory]
    [InlineData(
        "--look photo", "--renderer native --samples auto --shading smooth --sun disc --reflectance moon --refine 1 --exposure auto")]
    [InlineData("--look truth", "--renderer native --samples 1 --shading facet --sun point --surface terrain")]
    [InlineData("--look thesis", "--renderer povray --lod off --surface sphere --aberration none")]
    [InlineData(
        "--look PHOTO --samples 9 --sun point",
        "--renderer native --samples 9 --shading smooth --sun point --reflectance moon --refine 1 --exposure auto")]
    [InlineData(
        "--look photo --refine none --fov 20",
        "--renderer native --samples auto --shading smooth --sun disc --reflectance moon --refine none --fov 20 --exposure auto")]
    [InlineData(
        "--look photo --lod-error 1",
        "--renderer native --samples auto --shading smooth --sun disc --reflectance moon --lod-error 1 --exposure auto")]
    [InlineData(
        "--look photo --reflectance lambert",
        "--renderer native --samples auto --shading smooth --sun disc --reflectance lambert --refine 1 --exposure auto")]
    [InlineData("--look thesis --lod-error 1 --ignore-sun", "--renderer povray --lod-error 1 --surface sphere --ignore-sun")]
    [InlineData(
        "--look thesis --renderer native",
        "--renderer native --lod off --surface sphere --aberration none --samples 1 --shading facet --sun point --reflectance lambert")]
    public void Behind_Look_IsItsOptions(string given, string expected)
    {
        OptionValues looked = LookOptions.Behind(Given.Options(given));
        OptionValues same = Given.Options(expected);

        Assert.All(
            CommandTable.OptionsOfRun, option => Assert.Equal((option.Name, same.Text(option)), (option.Name, looked.Text(option))));
        RenderSettings settings = RenderSettingsReader.Read(looked);
        RenderSettings named = RenderSettingsReader.Read(same);
        Assert.Equal(FrameArguments.OfSettings(named, null), FrameArguments.OfSettings(settings, null));
        Assert.DoesNotContain("--look", FrameArguments.OfSettings(settings, null), StringComparison.Ordinal);
    }

    [Fact]
    public void Behind_NoLook_IsWhatIsGiven()
    {
        OptionValues given = Given.Options("--samples 4 --renderer native");
        Assert.Same(given, LookOptions.Behind(given));
    }

    [Theory]
    [InlineData(
        "--look photo --renderer povray",
        "--look photo is drawn by the native renderer. Leave --renderer povray out, or give --look thesis.")]
    [InlineData("--look truth --renderer povray", "--look truth is drawn by the native renderer.")]
    [InlineData("--look foto", "--look is 'foto'; one of thesis, truth, photo is needed: did you mean photo?")]
    public void Behind_WrongLook_SaysWhatToDo(string given, string expected) => Assert.StartsWith(
        expected, Assert.Throws<UsageException>(() => LookOptions.Behind(Given.Options(given))).Message, StringComparison.Ordinal);

    /// <summary>What the message recommends works.</summary>
    [Theory]
    [InlineData("--look thesis --renderer povray")]
    [InlineData("--look photo")]
    public void Behind_AdviceOfTheMessage_IsTaken(string given) =>
        Assert.NotNull(RenderSettingsReader.Read(LookOptions.Behind(Given.Options(given))));

    [Fact]
    public void MessageOf_ValueOfALook_NamesTheLook()
    {
        OptionValues looked = LookOptions.Behind(Given.Options("--look photo"));
        UsageException wrong = new UsageException("--refine is wrong.").About(NativeOptions.Refine);

        Assert.Equal("--refine is wrong. --refine comes from --look photo.", looked.MessageOf(wrong));
        Assert.Equal(new UsageException("x").ExitCode, looked.ExitCodeOf(wrong));
    }
}
