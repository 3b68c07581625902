using Msisf.App.Cluster;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Cluster;

/// <summary>By the rules of cmd (percent signs) and of Windows's programs (backslashes before a quotation mark).</summary>
public sealed class CmdWordTests
{
    [Theory]
    [InlineData("plain", "plain")]
    [InlineData(@"C:\Moon\output", @"C:\Moon\output")]
    [InlineData("", "\"\"")]
    [InlineData("a b", "\"a b\"")]
    [InlineData(@"C:\a b\", @"""C:\a b\\""")]
    [InlineData("100%", "\"100%%\"")]
    [InlineData("%PATH%", "\"%%PATH%%\"")]
    [InlineData("M\u00f6nd", "\"M\u00f6nd\"")]
    [InlineData("a&b|c^d", "\"a&b|c^d\"")]
    [InlineData("--width=64", "\"--width=64\"")]
    public void Of_Text_IsOneWordForCmd(string text, string expected) => Assert.Equal(expected, CmdWord.Of(text));

    [Theory]
    [InlineData("a\"b")]
    [InlineData("two\nlines")]
    public void Of_WhatCmdCantPass_IsRefused(string text) => Assert.Throws<UsageException>(() => CmdWord.Of(text));
}
