namespace Msisf.Server;

/// <summary>
/// Who asks what is worked on: clients share the server evenly. It is the name that a client gives itself, to distinguish programs of one
/// computer; otherwise its address, the kind of program, and the connections that it opened together.
/// </summary>
internal static class AskingClient
{
    /// <summary>Header with a name that a client makes up for itself.</summary>
    public const string Header = "X-Msisf-Client";

    /// <summary>Characters of the name that count.</summary>
    private const int Longest = 64;

    private static readonly AsyncLocal<string?> Current = new();

    /// <summary>The client of the request that is answered; empty for work of the server's own.</summary>
    public static string Name => Current.Value ?? string.Empty;

    /// <summary>Notes whose request it is, for all that is done to answer it.</summary>
    public static Task NoteAsync(HttpContext context, RequestDelegate next)
    {
        string named = context.Request.Headers[Header].ToString();
        string name = named.Length > 0
            ? $"{Header} {Short(named)}"
            : $"{context.Features.Get<Connection>()?.Burst} {Short(context.Request.Headers.UserAgent.ToString())}";
        Current.Value = $"{context.Connection.RemoteIpAddress} {name}";
        return next(context);
    }

    private static string Short(string text) => text[..Math.Min(text.Length, Longest)];
}
