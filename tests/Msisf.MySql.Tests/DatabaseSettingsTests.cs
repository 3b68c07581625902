using System.Text.Json;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using MySqlConnector;
using Xunit;

namespace Msisf.MySql.Tests;

public sealed class DatabaseSettingsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public static TheoryData<string> Connections => [.. OptionFileCases.Names(areRefused: false)];

    public static TheoryData<string> Refused => [.. OptionFileCases.Names(areRefused: true)];

    public void Dispose() => _folder.Dispose();

    [Theory]
    [MemberData(nameof(Connections))]
    public void Read_OptionFile_IsTheConnectionOfTheTable(string name)
    {
        DatabaseSettings settings = Read(name);

        Dictionary<string, string> found = new()
        {
            ["user"] = settings.User,
            ["password"] = settings.Password,
            ["database"] = settings.Database,
            ["host"] = settings.Host,
            ["port"] = $"{settings.Port}",
            ["socket"] = settings.Socket == DatabaseSettings.DefaultSocket(DatabaseSettings.DefaultSockets)
                ? "default"
                : settings.Socket ?? string.Empty,
            ["tls"] = settings.Tls.Mode == TlsMode.VerifyIdentity ? "verify-identity" : settings.Tls.Mode.ToString().ToLowerInvariant(),
            ["ca"] = settings.Tls.CertificateAuthority ?? string.Empty,
            ["unverified"] = $"{settings.IsUnverified}",
        };
        Assert.Equal(OptionFileCases.Expected(name).ToDictionary(pair => pair.Key, pair => InFolder(pair.Value)), found);
    }

    [Theory]
    [MemberData(nameof(Refused))]
    public void Read_OptionFile_IsRefusedWithTheMessageOfTheTable(string name)
    {
        MsisfException exception = Assert.ThrowsAny<MsisfException>(() => Read(name));
        Assert.Contains(
            InFolder(OptionFileCases.Of(name).GetProperty("refused").GetString()!), exception.Message, StringComparison.Ordinal);
        Assert.DoesNotContain("secret", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void DefaultSocket_IsTheFirstThatIsThere()
    {
        Assert.Equal(OptionFileCases.DefaultSockets, DatabaseSettings.DefaultSockets);
        string there = _folder.Write("there", string.Empty);
        Assert.Equal(there, DatabaseSettings.DefaultSocket([_folder["a"], there, _folder["b"]]));
        Assert.Equal(_folder["a"], DatabaseSettings.DefaultSocket([_folder["a"], _folder["b"]]));
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
        Assert.Contains(
            "chmod 600", Assert.Throws<BadInputException>(() => DatabaseSettings.Read(file, _ => null)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_MissingFile_IsRefused() =>
        Assert.Contains(
            "missing",
            Assert.Throws<BadInputException>(() => DatabaseSettings.Read(_folder["none.cnf"], _ => null)).Message,
            StringComparison.Ordinal);

    [Fact]
    public void ConnectionString_AnyValue_IsQuoted()
    {
        MySqlConnectionStringBuilder parts = ConnectionString(
            "user=\"reader;Server=elsewhere\"", "password=\"a;b'\\\"c\"", "socket=/run/my.sock");

        Assert.Equal("reader;Server=elsewhere", parts.UserID);
        Assert.Equal("a;b'\"c", parts.Password);
        Assert.Equal(
            ("/run/my.sock", MySqlConnectionProtocol.UnixSocket, "msisf"), (parts.Server, parts.ConnectionProtocol, parts.Database));
        Assert.False(parts.ConnectionReset);
        Assert.Equal(MySqlSslMode.Preferred, parts.SslMode);
    }

    [Theory]
    [InlineData("ssl-mode=DISABLED", MySqlSslMode.Disabled, false)]
    [InlineData("ssl-mode=REQUIRED", MySqlSslMode.Required, false)]
    [InlineData("ssl-mode=VERIFY_IDENTITY", MySqlSslMode.VerifyFull, false)]
    [InlineData("ssl-ca={folder}/ca.pem", MySqlSslMode.VerifyFull, true)]
    public void ConnectionString_Tls_IsWhatTheProviderCallsIt(string option, MySqlSslMode mode, bool hasAuthority)
    {
        MySqlConnectionStringBuilder parts = ConnectionString("user=me", "host=db", "port=3307", option);

        Assert.Equal(("db", 3307u, mode), (parts.Server, parts.Port, parts.SslMode));
        Assert.Equal(hasAuthority ? _folder["ca.pem"] : string.Empty, parts.SslCa);
        Assert.Equal(MySqlConnectionProtocol.Socket, parts.ConnectionProtocol);
    }

    private DatabaseSettings Read(string name)
    {
        _folder.Write("ca.pem", string.Empty);
        JsonElement item = OptionFileCases.Of(name);
        string file = OptionFile([.. item.GetProperty("file").EnumerateArray().Select(line => InFolder(line.GetString()!))]);
        return DatabaseSettings.Read(
            file,
            variable => item.TryGetProperty("environment", out JsonElement variables)
                && variables.TryGetProperty(variable, out JsonElement value) ? InFolder(value.GetString()!) : null);
    }

    private MySqlConnectionStringBuilder ConnectionString(params string[] options)
    {
        _folder.Write("ca.pem", string.Empty);
        string file = OptionFile(["[client]", .. options.Select(InFolder)]);
        return new(ConnectionText.Of(DatabaseSettings.Read(file, _ => null)));
    }

    private string InFolder(string text) => text.Replace("{folder}", _folder.Path, StringComparison.Ordinal);

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
