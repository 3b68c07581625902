using System.Data.Common;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.MySql.Tests;

public sealed class DatabaseSettingsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Read_FileAndEnvironment_TheFileComesFirst()
    {
        string file = OptionFile("[mysqld]", "port=1", "[client]", "user = reader # who", "password=\"a\\\"b#c\"", "; no", "port=3307");

        DatabaseSettings settings = DatabaseSettings.Read(file, Variables(("MSISF_DB_USER", "other"), ("MSISF_DB_HOST", "moon")));

        Assert.Equal(
            ("moon", 3307, "reader", "msisf", null), (settings.Host, settings.Port, settings.User, settings.Database, settings.Socket));
        Assert.Equal("a\"b#c", settings.Password);
    }

    [Fact]
    public void Read_FileThatOthersMayRead_IsRefused()
    {
        if (OperatingSystem.IsWindows())
        {
            return; // has no such rights
        }

        string file = OptionFile("[client]", "password=secret");
        File.SetUnixFileMode(file, UnixFileMode.UserRead | UnixFileMode.OtherRead);
        Assert.Contains("chmod 600", Refusal(file).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_LineThatIsNoOption_IsRefusedWithoutShowingIt()
    {
        BadInputException exception = Refusal(OptionFile("[client]", "!include secret"));
        Assert.Contains("line 2", exception.Message, StringComparison.Ordinal);
        Assert.DoesNotContain("secret", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_MissingFile_IsRefused() => Assert.Contains("missing", Refusal(_folder["none.cnf"]).Message, StringComparison.Ordinal);

    [Fact]
    public void Read_NoUser_IsAUsageError() => Assert.Throws<UsageException>(() => DatabaseSettings.Read(null, _ => null));

    [Theory]
    [InlineData("MSISF_DB_DATABASE", "msisf`; DROP TABLE ldem_4; --")]
    [InlineData("MSISF_DB_PORT", "65536")]
    [InlineData("MSISF_DB_PORT", "3306;Database=mysql")]
    public void Read_HostileValue_IsRefused(string variable, string value) =>
        Assert.Throws<BadInputException>(() => DatabaseSettings.Read(null, Variables(("MSISF_DB_USER", "reader"), (variable, value))));

    [Fact]
    public void Open_ProviderInTheFolder_GetsAConnectionStringWithEachValueQuoted()
    {
        DatabaseSettings settings = DatabaseSettings.Read(null, Variables(
            ("MSISF_DB_USER", "reader;Server=elsewhere"), ("MSISF_DB_PASSWORD", "a;b'\"c"), ("MSISF_DB_SOCKET", "/run/my.sock")));

        using DbDataSource source = MySqlProvider.Open(settings, AppContext.BaseDirectory);

        DbConnectionStringBuilder parts = new() { ConnectionString = source.ConnectionString };
        Assert.Equal("reader;Server=elsewhere", parts["User ID"]);
        Assert.Equal("a;b'\"c", parts["Password"]);
        Assert.Equal(("/run/my.sock", "Unix", "msisf"), (parts["Server"], parts["Connection Protocol"], parts["Database"]));
    }

    [Fact]
    public void Open_BuildWithoutTheProvider_SaysSo()
    {
        DatabaseSettings settings = DatabaseSettings.Read(null, Variables(("MSISF_DB_USER", "reader")));
        ExternalPartException exception = Assert.Throws<ExternalPartException>(() => MySqlProvider.Open(settings, _folder["."]));
        Assert.StartsWith("this build of msis has no MySqlConnector", exception.Message, StringComparison.Ordinal);
    }

    private static Func<string, string?> Variables(params (string Name, string Value)[] variables) =>
        name => variables.Where(variable => variable.Name == name).Select(variable => variable.Value).FirstOrDefault();

    private static BadInputException Refusal(string file) => Assert.Throws<BadInputException>(() => DatabaseSettings.Read(file, _ => null));

    private string OptionFile(params string[] lines)
    {
        string path = _folder["my.cnf"];
        File.WriteAllLines(path, lines);
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(path, UnixFileMode.UserRead | UnixFileMode.UserWrite);
        }

        return path;
    }
}
