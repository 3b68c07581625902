using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Xunit;

namespace Msisf.App.Tests.Settings;

public sealed class CommandTableTests
{
    public static TheoryData<string> Paths => new(CommandTable.All.Select(entry => entry.Path));

    [Theory]
    [MemberData(nameof(Paths))]
    public void Names_OfACommandsOptions_StandOnce(string path)
    {
        string[] names = [.. Command(path).Options.SelectMany(option => option.Aliases.Append(option.Name))];

        Assert.Equal(names.Distinct(StringComparer.Ordinal), names);
    }

    [Fact]
    public void Names_AreLongAndLikeTheThesis() => Assert.All(
        CommandTable.All.SelectMany(entry => entry.Command.Options),
        option => Assert.Matches("^--[a-z]+(-[a-z]+)*[HV]?$", option.Name));

    [Fact]
    public void Help_IsOneSentenceWithoutItsFullStop() => Assert.All(
        CommandTable.All.SelectMany(entry => entry.Command.Options),
        option => Assert.Matches(@"^[A-Z].*([^.\s]|\.\.\.)$", option.Help));

    [Fact]
    public void Defaults_AsTheHelpHasThem_ReadBackToTheDefaultsAndAreOfTheRange()
    {
        OptionSpec[] options = [.. CommandTable.All.SelectMany(entry => entry.Command.Options)];
        NumberSpec[] numbers = [.. options.OfType<NumberSpec>().Where(option => option.Default is not null)];
        WholeNumberSpec[] wholeNumbers = [.. options.OfType<WholeNumberSpec>().Where(option => option.Default is not null)];

        Assert.All(numbers, option => Assert.Equal(option.Default, option.ReadIfGiven(WithDefault(option))));
        Assert.All(wholeNumbers, option => Assert.Equal(option.Default, option.ReadIfGiven(WithDefault(option))));
        Assert.Contains(numbers, option => option.Limits is not null);
        Assert.Contains(ImageOptions.Width, wholeNumbers);
    }

    /// <summary>A client names no file of the server's computer.</summary>
    [Fact]
    public void OptionsOfARequest_SayWhatOneImageIs_AndNameNoFileButMapsAndLists()
    {
        OptionSpec[] options = [.. CommandTable.OptionsOfRequest];

        Assert.Equal([AlbedoOptions.Map, NativeOptions.HapkeMap, .. NavigationOptions.Lists], options.OfType<PathSpec>());
        Assert.All(options, option => Assert.IsType<DecidesBytes>(option.Role));
        OptionSpec[] some =
            [CameraOptions.FixedState, PointingOptions.Position, ImageOptions.Camera, OutputOptions.Grid, NativeOptions.NoiseSeed];
        Assert.Empty(some.Except(options));
        Assert.Empty(options.Intersect(
            [CameraOptions.Times, .. BatchOptions.All, SurfaceOptions.Body, OutputOptions.Annotation, PovOptions.MoreOptions,
                OutputOptions.Folder, RunOptions.Jobs]));
    }

    /// <summary>An option that is left out would make other tiles than the run needs.</summary>
    [Fact]
    public void OptionsThatDecideTiles_AreThoseOfCameraSunAndLevels() => Assert.Equal(
        [
            ImageOptions.FieldOfView, ImageOptions.Width, ImageOptions.Height, ImageOptions.Camera, LightOptions.IgnoreSun,
            LightOptions.Aberration, LightOptions.Kernels, SurfaceOptions.Resolution, SurfaceOptions.Ldem, SurfaceOptions.LevelOfDetail,
            SurfaceOptions.LevelOfDetailError, PovOptions.PatternRepository,
        ],
        PatternsOptions.Deciding);

    private static OptionValues WithDefault(OptionSpec option) =>
        new([KeyValuePair.Create(option.Name, new OptionValue([option.DefaultValue!]))]);

    private static CommandSpec Command(string path) => CommandTable.All.Single(entry => entry.Path == path).Command;
}
