using System.Net;
using System.Net.Http.Headers;
using System.Net.NetworkInformation;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Server.Tests;

/// <summary>Pages of other sites, clients without the token, and addresses that others can reach.</summary>
public sealed class GuardTests(RunningServer server) : IClassFixture<RunningServer>
{
    private const string Token = "0123456789abcdef";

    [RequiresTheory(Part.Ldem4)]
    [InlineData("Host", "moon.example.com")]
    [InlineData("Host", "localhost.example.com")]
    [InlineData("Origin", "http://moon.example.com")]
    [InlineData("Origin", "null")]
    [InlineData("Origin", "http://127.0.0.1:1")]
    [InlineData("Sec-Fetch-Site", "cross-site")]
    public async Task ForeignHostOrOrigin_IsForbidden(string header, string value)
    {
        using HttpRequestMessage request = new(HttpMethod.Get, "/v1/models");
        request.Headers.TryAddWithoutValidation(header, value);

        using HttpResponseMessage answer = await server.Client.SendAsync(request);

        Assert.Equal(HttpStatusCode.Forbidden, answer.StatusCode);
    }

    /// <summary>Names of computers and of schemes have no case (RFC 9110).</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task OwnHost_InCapitals_IsAllowed()
    {
        using HttpRequestMessage request = new(HttpMethod.Get, "/v1/models");
        request.Headers.Host = "LOCALHOST";

        using HttpResponseMessage answer = await server.Client.SendAsync(request);

        Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task OwnOrigin_IsAllowed()
    {
        using HttpRequestMessage request = new(HttpMethod.Get, "/v1/models");
        request.Headers.Add("Origin", server.Address);

        using HttpResponseMessage answer = await server.Client.SendAsync(request);

        Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
        Assert.Contains("frame-ancestors 'none'", answer.Headers.GetValues("Content-Security-Policy").Single(), StringComparison.Ordinal);
    }

    [RequiresFact(Part.Ldem4)]
    public async Task WebSocketOfAForeignPage_IsForbidden()
    {
        using ClientWebSocket socket = new();
        socket.Options.SetRequestHeader("Origin", "http://moon.example.com");

        await Assert.ThrowsAsync<WebSocketException>(
            () => socket.ConnectAsync(new Uri($"{server.Address.Replace("http", "ws", StringComparison.Ordinal)}/v1/stream"), default));
    }

    [RequiresFact(Part.Ldem4)]
    public async Task Token_IsNeeded_AsBearerOrPassword()
    {
        using TemporaryFolder folder = new();
        using RunningServer guarded = await RunningServer.StartAsync((ServeOptions.TokenFile, folder.Write("token", Token + "\n")));

        Assert.Equal(HttpStatusCode.Unauthorized, await StatusAsync(guarded, null));
        Assert.Equal(HttpStatusCode.Unauthorized, await StatusAsync(guarded, new("Bearer", "0123456789abcdeF")));
        Assert.Equal(HttpStatusCode.Unauthorized, await StatusAsync(guarded, new("Basic", "%%%")));
        Assert.Equal(HttpStatusCode.OK, await StatusAsync(guarded, new("Bearer", Token)));
        Assert.Equal(HttpStatusCode.OK, await StatusAsync(guarded, new("bearer", Token)));
        string pair = Convert.ToBase64String(System.Text.Encoding.ASCII.GetBytes($"me:{Token}"));
        Assert.Equal(HttpStatusCode.OK, await StatusAsync(guarded, new("Basic", pair)));
        Assert.Equal(HttpStatusCode.OK, (await guarded.Client.GetAsync("/healthz")).StatusCode);
        await guarded.DisposeAsync();
    }

    /// <summary>Whoever reaches the server over the network needs the token, and is served with it.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task AddressOfTheNetwork_NeedsTheToken()
    {
        using TemporaryFolder folder = new();
        using RunningServer guarded = await RunningServer.StartAsync(
            (ServeOptions.Listen, "0.0.0.0:0"), (ServeOptions.TokenFile, folder.Write("token", Token + "\n")));
        IPAddress own = NetworkInterface.GetAllNetworkInterfaces()
            .SelectMany(network => network.GetIPProperties().UnicastAddresses).Select(address => address.Address)
            .FirstOrDefault(address => address.AddressFamily == AddressFamily.InterNetwork && !IPAddress.IsLoopback(address))
            ?? IPAddress.Parse("127.0.0.2"); // a computer without a network
        guarded.Client.BaseAddress = new Uri($"http://{own}:{new Uri(guarded.Address).Port}");

        Assert.Equal(HttpStatusCode.Unauthorized, await StatusAsync(guarded, null));
        Assert.Equal(HttpStatusCode.OK, await StatusAsync(guarded, new("Bearer", Token)));
        await guarded.DisposeAsync();
    }

    /// <summary>Requests and streams over TLS, with a certificate that is made here.</summary>
    [RequiresFact(Part.Ldem4)]
    public async Task Tls_AnswersWithTheCertificate_AlsoWebSockets()
    {
        using TemporaryFolder folder = new();
        using ECDsa key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        CertificateRequest wanted = new("CN=moon.test", key, HashAlgorithmName.SHA256);
        using X509Certificate2 certificate = wanted.CreateSelfSigned(DateTimeOffset.UtcNow.AddDays(-1), DateTimeOffset.UtcNow.AddDays(1));
        using RunningServer secure = await RunningServer.StartAsync(
            (ServeOptions.Certificate, folder.Write("cert.pem", certificate.ExportCertificatePem())),
            (ServeOptions.CertificateKey, folder.Write("key.pem", key.ExportPkcs8PrivateKeyPem())));
        string? seen = null;
        using SocketsHttpHandler handler = new();
        handler.SslOptions.RemoteCertificateValidationCallback = (_, shown, _, _) =>
            (seen = shown!.GetCertHashString()) == certificate.GetCertHashString();
        using HttpClient client = new(handler);
        using ClientWebSocket socket = new();
        socket.Options.SetRequestHeader("Origin", secure.Address);

        Assert.StartsWith("https://", secure.Address, StringComparison.Ordinal);
        Assert.Equal("ok\n", await client.GetStringAsync(new Uri($"{secure.Address}/healthz")));
        Assert.Equal(certificate.GetCertHashString(), seen);
        await Assert.ThrowsAsync<HttpRequestException>(() => secure.Client.GetStringAsync(new Uri("/healthz", UriKind.Relative)));
        await socket.ConnectAsync(
            new Uri($"{secure.Address.Replace("https", "wss", StringComparison.Ordinal)}/v1/stream"), client, CancellationToken.None);
        Assert.Equal(WebSocketState.Open, socket.State);
        await secure.DisposeAsync();
    }

    [RequiresFact(Part.Ldem4)]
    public async Task WrongCertificate_IsRefused_ByItsName()
    {
        using TemporaryFolder folder = new();
        string certificate = folder.Write("cert.pem", "no certificate\n");

        BadInputException exception = await Assert.ThrowsAsync<BadInputException>(() => RunningServer.StartAsync(
            (ServeOptions.Certificate, certificate), (ServeOptions.CertificateKey, folder.Write("key.pem", "no key\n"))));

        Assert.Contains($"--tls-certificate {certificate}", exception.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("0.0.0.0:8810", "--token-file")]
    [InlineData("192.168.1.1:80", "--token-file")]
    [InlineData("[::]:80", "--token-file")]
    [InlineData("127.0.0.1", "is neither an address with a port")]
    [InlineData("example.com:80", "is neither an address with a port")]
    [InlineData("127.0.0.1:65536", "is neither an address with a port")]
    [InlineData("127.1:80", "is neither an address with a port")]
    public void Listen_OnWhatOthersReach_NeedsAToken(string address, string words)
    {
        UsageException exception = Assert.Throws<UsageException>(() => ServeOptions.Read(Values((ServeOptions.Listen, address))));

        Assert.Contains(words, exception.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("127.0.0.1:0")]
    [InlineData("127.5.5.5:80")]
    [InlineData("[::1]:8810")]
    [InlineData("localhost:8810")]
    [InlineData("./msis.sock")]
    public void Listen_OnLoopbackOrASocket_NeedsNoToken(string address) =>
        Assert.True(ServeOptions.Read(Values((ServeOptions.Listen, address))).Listen.IsLocal);

    [Fact]
    public void ShortToken_IsRefused()
    {
        using TemporaryFolder folder = new();

        BadInputException exception = Assert.Throws<BadInputException>(
            () => ServeOptions.Read(Values((ServeOptions.TokenFile, folder.Write("token", "secret\n")))));

        Assert.Contains("is not a token", exception.Message, StringComparison.Ordinal);
        Assert.DoesNotContain("secret", exception.Message, StringComparison.Ordinal);
    }

    private static async Task<HttpStatusCode> StatusAsync(RunningServer guarded, AuthenticationHeaderValue? authorization)
    {
        using HttpRequestMessage request = new(HttpMethod.Get, "/v1/models");
        request.Headers.Authorization = authorization;
        using HttpResponseMessage answer = await guarded.Client.SendAsync(request);
        return answer.StatusCode;
    }

    private static OptionValues Values(params (OptionSpec Option, string Value)[] options) =>
        new(options.Select(pair => KeyValuePair.Create(pair.Option.Name, new OptionValue([pair.Value]))));
}
