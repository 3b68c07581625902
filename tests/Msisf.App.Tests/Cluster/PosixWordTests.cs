using Msisf.App.Cluster;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.App.Tests.Cluster;

public sealed class PosixWordTests
{
    [Theory]
    [InlineData("plain", "plain")]
    [InlineData("--width=64", "--width=64")]
    [InlineData("", "''")]
    [InlineData("a b", "'a b'")]
    [InlineData("it's", "'it'\\''s'")]
    public void Of_Text_QuotesWhereNeeded(string text, string expected) => Assert.Equal(expected, PosixWord.Of(text));

    [Theory]
    [InlineData("")]
    [InlineData("a b")]
    [InlineData("M\u00f6nd 'a' \"b\" $HOME;x `id` $(id) \\ 100% !x *? [a] {a,b} ~ #y & | < > (z)")]
    [InlineData("-n")]
    [InlineData("~")]
    [InlineData("two\nlines\t")]
    [InlineData("'")]
    [InlineData("'''")]
    [InlineData("MSIS=x")]
    public void Of_OddText_ReachesAProgramOfARealShellUnchanged(string text)
    {
        ChildRun run = ChildRun.Of("/bin/sh", ["-c", $"printf '[%s]' {PosixWord.Of(text)}"], "/");

        Assert.Equal($"[{text}]", run.Succeeded().Output);
    }
}
