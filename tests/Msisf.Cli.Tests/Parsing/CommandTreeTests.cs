using System.CommandLine;
using Msisf.Cli.Parsing;
using Xunit;

namespace Msisf.Cli.Tests.Parsing;

/// <summary>Building all options takes longer than the rest of the start: a call builds those that it may need.</summary>
public sealed class CommandTreeTests
{
    [Theory]
    [InlineData("status orbit", "status")]
    [InlineData("ldem pyramid --res 4", "pyramid")]
    [InlineData("--fov 40", "")]
    [InlineData("", "")]
    [InlineData("--version --fov 40", "")]
    [InlineData("--fov 40 status orbit", " status")] // the error needs both
    public void Options_OfACall_AreThoseOfItsCommands(string words, string paths)
    {
        CommandTree tree = Tree(words.Split(' ', StringSplitOptions.RemoveEmptyEntries));

        Assert.Equal(
            paths.Split(' ').Order(StringComparer.Ordinal),
            Built(tree.Root, string.Empty).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Options_OfTheVersionAlone_AreNone() => Assert.Empty(Built(Tree(["--version"]).Root, string.Empty));

    [Fact]
    public void Options_OfAFileOfArguments_AreAll() =>
        Assert.True(Built(Tree(["@arguments"]).Root, string.Empty).Count() > 10);

    private static CommandTree Tree(string[] arguments) => new(arguments, (_, _) => { }, (_, _, _) => Task.FromResult(0));

    /// <summary>The last words of the commands that have options of their own.</summary>
    private static IEnumerable<string> Built(Command command, string name) =>
        command.Subcommands.SelectMany(inner => Built(inner, inner.Name)).Concat(
            command.Options.Any(option => option.Name is not ("--help" or "--version")) ? [name] : []);
}
