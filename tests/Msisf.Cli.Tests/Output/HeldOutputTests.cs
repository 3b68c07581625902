using Msisf.App.Host;
using Msisf.Cli.Output;
using Xunit;

namespace Msisf.Cli.Tests.Output;

/// <summary>What would be drawn over by a progress bar is kept back while there is one.</summary>
public sealed class HeldOutputTests
{
    [Fact]
    public void Log_Held_IsWrittenInItsOrderWhenReleased()
    {
        using StringWriter error = new() { NewLine = "\n" };
        ConsoleLog log = new(error);

        log.Note("a");
        log.Hold();
        log.Warning("b");
        log.Error("c\nd");
        Assert.Equal("msis: a\n", error.ToString());

        log.Release();
        log.Note("e");
        Assert.Equal("msis: a\nmsis: warning: b\nmsis: error: c d\nmsis: e\n", error.ToString());
    }

    [Fact]
    public void Results_Held_AreWrittenWhenReleased()
    {
        using StringWriter output = new() { NewLine = "\n" };
        using ResultsWriter results = new(output);

        results.WriteLine("a");
        results.Hold();
        results.WriteLine("b");
        results.Write("c");
        results.Flush();
        Assert.Equal("a\n", output.ToString());

        results.Release();
        results.WriteLine("d");
        Assert.Equal("a\nb\ncd\n", output.ToString());
    }
}
