using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Run;

/// <summary>The commands of docs/missions.md for LRO run as they are written, with the kernels where they are.</summary>
public sealed class MissionPageTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RequiresFact(Part.LroNac, Part.Ldem4)]
    public void Page_CommandsForLro_RunAsWritten()
    {
        string page = File.ReadAllText(Path.Combine(TestParts.RepositoryRoot, "docs", "missions.md"));
        string[][] commands =
        [
            .. page.Split("```sh\n").Skip(1).Select(block => block.Split("```")[0].Replace("\\\n", " ", StringComparison.Ordinal))
                .Where(block => block.Contains(" lro/", StringComparison.Ordinal))
                .Select(block => block.Split((char[])[' ', '\n'], StringSplitOptions.RemoveEmptyEntries)[1..]
                    .Select(word => word.StartsWith("lro/", StringComparison.Ordinal) ? Path.Combine(LroNac.Folder, word[4..]) : word)
                    .ToArray()),
        ];

        Assert.Equal(2, commands.Length);
        Assert.Equal(0, CommandLineRun.Of(commands[0]).ExitCode);
        CommandLineRun picture = CommandLineRun.Of([.. commands[1], "--output-dir", _folder["out"]]);
        Assert.True(picture.ExitCode == 0, picture.Error);
        Assert.Single(Directory.GetFiles(_folder["out"], "*.png"));
    }
}
