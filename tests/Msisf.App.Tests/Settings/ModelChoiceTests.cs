using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Settings;

/// <summary>A file that --ldem names says itself which resolution it has.</summary>
public sealed class ModelChoiceTests
{
    [RequiresFact(Part.Ldem4)]
    public void ResolutionOf_FileOfTheCall_GoesBeforeThatOfAConfigurationFile()
    {
        OptionValue file = new([TestParts.Ldem4Label!]);
        OptionValue folder = new([Path.GetDirectoryName(TestParts.Ldem4Label!)!]);
        OptionValue finer = new(["64"]);
        OptionValue finerOfConfig = new(["64"], "config.yaml, line 1");

        Assert.Equal(4, Of(("--ldem", file), ("--res", finerOfConfig))); // the file is what this call names
        Assert.Equal(64, Of(("--ldem", file with { Place = "config.yaml, line 2" }), ("--res", finerOfConfig)));
        Assert.Equal(64, Of(("--ldem", file), ("--res", finer))); // contradicts; opening the model says so
        Assert.Equal(64, Of(("--ldem", folder), ("--res", finerOfConfig)));
    }

    private static int? Of(params (string Name, OptionValue Value)[] options) => ModelChoice.ResolutionOf(
        new OptionValues(options.Select(option => KeyValuePair.Create(option.Name, option.Value))), geoTiffs: null).PixelsPerDegree;
}
