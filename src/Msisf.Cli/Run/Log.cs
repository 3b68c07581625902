namespace Msisf.Cli.Run;

/// <summary>Lines for the user on standard error; standard output is for results only. Safe for several threads.</summary>
internal sealed class Log
{
    private readonly TextWriter _error;

    public Log(TextWriter error) => _error = TextWriter.Synchronized(error);

    public void Note(string text) => Raw($"msis: {text}");

    public void Warning(string text) => Raw($"msis: warning: {text}");

    public void Error(string text) => Raw($"msis: error: {text.ReplaceLineEndings(" ")}");

    /// <summary>A line as it is, for machines. One that can't be written is lost: there is no other place to tell, and the run and its exit code are worth more.</summary>
    public void Raw(string line)
    {
        try
        {
            _error.WriteLine(line);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            return;
        }
    }
}
