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
    public void Defaults_AreOfTheRange()
    {
        OptionSpec[] options = [.. CommandTable.OptionsOfRun.Where(option => option is { DefaultValue: not null, ValueName: not null })];

        Assert.NotEmpty(options);
        Assert.All(
            options.Where(option => option is NumberSpec or WholeNumberSpec),
            option => Assert.NotNull(RenderSettingsReader.Read(Given.Options(
                $"--renderer native {WithWhichItGoes(option)} {option.Name} {option.DefaultValue}"))));
    }

    private static string WithWhichItGoes(OptionSpec option) => option == NativeOptions.RefineCell ? "--refine 1" : string.Empty;

    private static CommandSpec Command(string path) => CommandTable.All.Single(entry => entry.Path == path).Command;
}
