namespace Msisf.App.Host;

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
