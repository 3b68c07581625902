using Msisf.App.Host;

namespace Msisf.App.Serving;

/// <summary>Collects the warnings of each request for its answer; all other messages go to the log of the server. Thread-safe.</summary>
internal sealed class RequestLog(ILog server) : ILog
{
    private readonly AsyncLocal<List<string>?> _warnings = new();

    /// <summary>Collects the warnings of the current request from now on.</summary>
    /// <returns>Receives them.</returns>
    public IReadOnlyList<string> Collect() => _warnings.Value = [];

    public void Note(string text) => server.Note(text);

    public void Warning(string text)
    {
        if (_warnings.Value is { } collected)
        {
            lock (collected)
            {
                collected.Add(text);
            }
        }
        else
        {
            server.Warning(text);
        }
    }

    public void Error(string text) => server.Error(text);

    public void Raw(string line) => server.Raw(line);
}
