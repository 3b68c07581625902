using Msisf.App.Settings;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.App.Tests.Settings;

public sealed class ListenAddressTests
{
    [Theory]
    [InlineData("127.0.0.1:8810", "127.0.0.1:8810", true)]
    [InlineData("localhost:0", "127.0.0.1:0", true)]
    [InlineData("[::1]:65535", "[::1]:65535", true)]
    [InlineData("0.0.0.0:80", "0.0.0.0:80", false)]
    [InlineData("[::]:80", "[::]:80", false)]
    [InlineData("/run/msis.sock", "/run/msis.sock", true)]
    public void Parse_AddressOrSocket_IsWhereAndWhoReachesIt(string text, string shown, bool isLocal)
    {
        ListenAddress address = ListenAddress.Parse(text);

        Assert.Equal(shown, address.ToString());
        Assert.Equal(isLocal, address.IsLocal);
    }

    [Fact]
    public void Parse_RelativeSocket_IsInTheWorkingDirectory() =>
        Assert.Equal(Path.Combine(Environment.CurrentDirectory, "msis.sock"), ListenAddress.Parse("./msis.sock").SocketPath);

    [Theory]
    [InlineData("8810")]
    [InlineData(":8810")]
    [InlineData("127.0.0.1")]
    [InlineData("127.0.0.1:65536")]
    [InlineData("127.0.0.1:-1")]
    [InlineData("127.1:80")] // IPAddress takes it for 127.0.0.1
    [InlineData("::1:80")] // which of the parts is the port?
    [InlineData("db.example.org:80")]
    [InlineData("msis.sock")]
    public void Parse_AnythingElse_IsRefusedWithExamples(string text) => Assert.StartsWith(
        $"'{text}' is neither an address with a port, such as 127.0.0.1:8810",
        Assert.Throws<BadInputException>(() => ListenAddress.Parse(text)).Message, StringComparison.Ordinal);
}
