using System.Net;
using System.Security.Cryptography;
using System.Text;
using Microsoft.Extensions.Primitives;
using Msisf.Adapters.Input;
using Msisf.App.Settings;

namespace Msisf.Server;

/// <summary>
/// Refuses requests that a page of another site makes a browser send (by its Origin, or by a name of its own for this computer), and those
/// without the token. Puts the headers on every answer that keep a browser from mixing it with other sites.
/// </summary>
internal sealed class RequestGuard(ServeSettings settings)
{
    /// <summary>Path that needs no token, so that it can be asked by whoever watches the server.</summary>
    public const string HealthPath = "/healthz";

    private const string ContentSecurityPolicy =
        "default-src 'self'; img-src 'self' blob: data:; connect-src 'self'; object-src 'none'; base-uri 'none'; frame-ancestors 'none'";

    private readonly byte[]? _token = settings.Token is { } token ? SHA256.HashData(Encoding.UTF8.GetBytes(token)) : null;

    /// <summary>Sets the headers of an answer, and checks its request.</summary>
    /// <exception cref="RefusedException">The request is refused.</exception>
    public void Check(HttpContext context)
    {
        IHeaderDictionary headers = context.Response.Headers;
        headers.ContentSecurityPolicy = ContentSecurityPolicy;
        headers.XContentTypeOptions = "nosniff";
        headers.CacheControl = "no-cache";
        headers["Referrer-Policy"] = "no-referrer";
        headers["Cross-Origin-Resource-Policy"] = "same-origin";
        HttpRequest request = context.Request;
        if (!IsOwnHost(request.Host.Host))
        {
            throw new RefusedException(
                StatusCodes.Status403Forbidden,
                $"the request is for the host '{request.Host.Host}', which is not this server. Use its address, or start it "
                    + "with --allow-host.");
        }

        if (request.Headers.Origin is { Count: > 0 } origin && origin != $"{request.Scheme}://{request.Host}")
        {
            throw new RefusedException(
                StatusCodes.Status403Forbidden,
                $"the request comes from a page of {NumberText.Shown(origin.ToString())}; pages of other sites are refused.");
        }

        if (request.Headers["Sec-Fetch-Site"] is ["cross-site" or "same-site"] && request.Path != "/")
        {
            throw new RefusedException(StatusCodes.Status403Forbidden, "the request comes from a page of another site, which is refused.");
        }

        if (_token is not null && request.Path != HealthPath && !HasToken(request.Headers.Authorization))
        {
            headers.WWWAuthenticate = "Basic realm=\"msis\", charset=\"UTF-8\"";
            throw new RefusedException(
                StatusCodes.Status401Unauthorized, "the token of the server's --token-file is needed, as 'Authorization: Bearer TOKEN'.");
        }
    }

    /// <summary>An address can't be another site's name for this computer; only names can.</summary>
    private bool IsOwnHost(string host) =>
        host.Equals("localhost", StringComparison.OrdinalIgnoreCase) || IPAddress.TryParse(host.Trim('[', ']'), out _)
        || settings.Hosts.Contains(host, StringComparer.OrdinalIgnoreCase);

    private bool HasToken(StringValues authorization)
    {
        string[] words = authorization.ToString().Split(' ', 2);
        string? given = words is not [var scheme, var credentials] ? null
            : scheme.Equals("Bearer", StringComparison.OrdinalIgnoreCase) ? credentials.Trim()
            : scheme.Equals("Basic", StringComparison.OrdinalIgnoreCase) ? PasswordOf(credentials)
            : null;
        return given is not null && CryptographicOperations.FixedTimeEquals(SHA256.HashData(Encoding.UTF8.GetBytes(given)), _token!);
    }

    private static string? PasswordOf(string pair)
    {
        byte[] bytes = new byte[pair.Length];
        return Convert.TryFromBase64String(pair, bytes, out int count)
            && Encoding.UTF8.GetString(bytes, 0, count).Split(':', 2) is [_, var password]
                ? password
                : null;
    }
}
