using Msisf.TestSupport;
using Xunit;

namespace Msisf.Cli.Tests.Help;

/// <summary>docs/command-line.md has the tables that the program's table of options makes; MSISF_WRITE_DOCS=1 writes them.</summary>
public sealed class OptionTablesTests
{
    private const string Begin = "<!-- options: begin (written by the test OptionTablesTests with MSISF_WRITE_DOCS=1) -->\n\n";
    private const string End = "<!-- options: end -->\n";

    [Fact]
    public void CommandLinePage_HasTheTablesOfTheProgram()
    {
        string path = Path.Combine(TestParts.RepositoryRoot, "docs", "command-line.md");
        string page = File.ReadAllText(path);
        int begin = page.IndexOf(Begin, StringComparison.Ordinal) + Begin.Length;
        int end = page.IndexOf(End, StringComparison.Ordinal);
        Assert.True(begin >= Begin.Length && end >= begin, "docs/command-line.md lacks the marks of its tables");
        if (Environment.GetEnvironmentVariable("MSISF_WRITE_DOCS") == "1")
        {
            File.WriteAllText(path, page[..begin] + OptionTables.Text() + page[end..]);
            return;
        }

        Assert.Equal(OptionTables.Text(), page[begin..end]);
    }
}
