namespace Msisf.Cli.Run;

/// <summary>Lines for the user on standard error; standard output is for results only. Safe for several threads.</summary>
internal sealed class Log
{
    private readonly TextWriter _error;

    public Log(TextWriter error) => _error = TextWriter.Synchronized(error);

    public void Note(string text) => _error.WriteLine($"msis: {text}");

    public void Warning(string text) => _error.WriteLine($"msis: warning: {text}");

    public void Error(string text) => _error.WriteLine($"msis: error: {text.ReplaceLineEndings(" ")}");

    /// <summary>A line as it is, for machines.</summary>
    public void Raw(string line) => _error.WriteLine(line);
}
