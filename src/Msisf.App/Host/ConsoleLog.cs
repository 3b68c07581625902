namespace Msisf.App.Host;

/// <summary>Writes messages for the user, separate from the results. Thread-safe.</summary>
internal interface ILog
{
    /// <summary>Writes information about the progress of the work.</summary>
    void Note(string text);

    /// <summary>Writes a warning; the run continues.</summary>
    void Warning(string text);

    void Error(string text);

    /// <summary>Writes a line unchanged, for other programs to read.</summary>
    void Raw(string line);
}

/// <summary>Writes log lines to standard error, because standard output is for results only. Thread-safe.</summary>
internal sealed class ConsoleLog(TextWriter error) : ILog
{
    private readonly Lock _gate = new();
    private List<string>? _held;

    public void Note(string text) => Raw($"msis: {text}");

    public void Warning(string text) => Raw($"msis: warning: {text}");

    public void Error(string text) => Raw($"msis: error: {text.ReplaceLineEndings(" ")}");

    /// <summary>
    /// Writes a line unchanged. If writing fails, the line is lost: there is no other place for it, and the run and its exit code are more
    /// important.
    /// </summary>
    public void Raw(string line)
    {
        lock (_gate)
        {
            if (_held is not null)
            {
                _held.Add(line);
                return;
            }

            try
            {
                error.WriteLine(line);
            }
            catch (Exception exception) when (exception.IsFileError())
            {
                return;
            }
        }
    }

    /// <summary>Holds lines back until <see cref="Release"/>.</summary>
    public void Hold()
    {
        lock (_gate)
        {
            _held = [];
        }
    }

    /// <summary>Writes the lines that were held back.</summary>
    public void Release()
    {
        lock (_gate)
        {
            List<string> held = _held ?? [];
            _held = null;
            held.ForEach(Raw);
        }
    }
}

/// <summary>Collects the warnings of each request for its answer; all other messages go to the log of the server. Thread-safe.</summary>
internal sealed class RequestLog(ILog server) : ILog
{
    private readonly AsyncLocal<List<string>?> _warnings = new();

    /// <summary>Collects the warnings of the current request from now on.</summary>
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
