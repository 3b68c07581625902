using Msisf.App.Host;
using Msisf.Core.Errors;

namespace Msisf.Cli.Output;

/// <summary>Lines on standard error; standard output is for results only. Safe for several threads.</summary>
internal sealed class ConsoleLog(TextWriter error) : ILog
{
    private readonly Lock _gate = new();
    private List<string>? _held;

    /// <inheritdoc/>
    public void Note(string text) => Raw($"msis: {text}");

    /// <inheritdoc/>
    public void Warning(string text) => Raw($"msis: warning: {text}");

    /// <inheritdoc/>
    public void Error(string text) => Raw($"msis: error: {text.ReplaceLineEndings(" ")}");

    /// <summary>
    /// A line as it is. One that can't be written is lost: there is no other place to tell, and the run and its exit code are worth more.
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

    /// <summary>Keeps lines back until <see cref="Release"/>.</summary>
    public void Hold()
    {
        lock (_gate)
        {
            _held = [];
        }
    }

    /// <summary>Writes the lines that were kept back.</summary>
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
