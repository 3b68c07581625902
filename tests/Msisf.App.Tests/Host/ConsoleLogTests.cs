using Msisf.App.Host;
using Xunit;

namespace Msisf.App.Tests.Host;

public sealed class ConsoleLogTests
{
    [Fact]
    public void Messages_HaveTheNameOfTheProgramAndTheirKind_ErrorsOnOneLine()
    {
        using StringWriter error = new() { NewLine = "\n" };
        ConsoleLog log = new(error);

        log.Note("a note");
        log.Warning("a warning");
        log.Error("first\nsecond");
        log.Raw("as it is");

        Assert.Equal("msis: a note\nmsis: warning: a warning\nmsis: error: first second\nas it is\n", error.ToString());
    }

    [Fact]
    public void HeldLines_AreWrittenAtTheRelease_InTheirOrder()
    {
        using StringWriter error = new() { NewLine = "\n" };
        ConsoleLog log = new(error);

        log.Hold();
        log.Note("first");
        log.Note("second");
        Assert.Empty(error.ToString());
        log.Release();
        log.Note("third");

        Assert.Equal("msis: first\nmsis: second\nmsis: third\n", error.ToString());
    }

    /// <summary>As when standard error is a pipe whose reader has gone: the run matters more than the line.</summary>
    [Fact]
    public void LineThatCannotBeWritten_IsLost_AndTheNextOnesAreTried()
    {
        using FailingWriter error = new();
        ConsoleLog log = new(error);

        log.Note("first");
        log.Note("second");

        Assert.Equal(2, error.Tries);
    }

    private sealed class FailingWriter : StringWriter
    {
        public int Tries { get; private set; }

        public override void WriteLine(string? value)
        {
            Tries++;
            throw new IOException("Broken pipe");
        }
    }
}
