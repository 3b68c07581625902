using Msisf.Adapters.IO;
using Xunit;

namespace Msisf.Adapters.Tests.IO;

public sealed class WindowsNamesTests
{
    [Theory]
    [InlineData("nul")]
    [InlineData("CON.png")]
    [InlineData("com9 .tar.gz")]
    [InlineData("a:b")]
    [InlineData("a?")]
    [InlineData("frame.")]
    [InlineData("frame ")]
    public void FaultOf_NameThatWindowsRefuses_SaysWhy(string name) => Assert.NotNull(WindowsNames.FaultOf(name));

    [Theory]
    [InlineData("CONE_000001.png")]
    [InlineData("com10")]
    [InlineData("Moon {step}")]
    [InlineData("nul_1")]
    [InlineData(".hidden")]
    public void FaultOf_OtherName_IsNull(string name) => Assert.Null(WindowsNames.FaultOf(name));
}
