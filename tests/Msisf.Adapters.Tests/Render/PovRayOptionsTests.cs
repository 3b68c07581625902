using Msisf.Adapters.Render;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Render;

public sealed class PovRayOptionsTests
{
    [Fact]
    public void Parse_SwitchesAndSettings_AreSplitAtBlanks() =>
        Assert.Equal(["Antialias=Off", "+Q9", "-J"], PovRayOptions.Parse("  Antialias=Off  +Q9 -J"));

    [Fact]
    public void Parse_Empty_IsNoOption() => Assert.Empty(PovRayOptions.Parse(string.Empty));

    [Theory]
    [InlineData("+Ifile.pov")]
    [InlineData("-Oelsewhere.png")]
    [InlineData("+W64")]
    [InlineData("+WT8")]
    [InlineData("+FN16")]
    [InlineData("+L/tmp")]
    [InlineData("+")]
    [InlineData("Output_File_Name=a.png")]
    [InlineData("width=64")]
    [InlineData("Work_Threads=9")]
    [InlineData("Frame_Step=2")]
    [InlineData("+SC0.5")]
    [InlineData("+KFI2")]
    [InlineData("other.ini")]
    public void Parse_WhatTheProgramSetsItself_IsRefused(string option)
    {
        UsageException exception = Assert.Throws<UsageException>(() => PovRayOptions.Parse(option));
        Assert.Contains(option, exception.Message, StringComparison.Ordinal);
    }
}
