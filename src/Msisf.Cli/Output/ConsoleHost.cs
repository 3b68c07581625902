using System.Text;
using Msisf.App.Host;

namespace Msisf.Cli.Output;

/// <summary>Makes the host of the command-line program: results go to standard output, everything else to standard error.</summary>
internal static class ConsoleHost
{
    public static ProgramHost Create(
        TextWriter results, TextWriter error, Func<TextReader> standardInput, TimeProvider clock, Func<string, string?> environment,
        bool holdsServer = false)
    {
        ResultsWriter output = new(results);
        ConsoleLog log = new(error);
        return new ProgramHost(clock, environment)
        {
            Results = output,
            Log = log,
            Progress = new ProgressDisplay(output, log, clock),
            StandardInput = standardInput,
            HoldsServer = holdsServer,
        };
    }
}

/// <summary>
/// Writes to standard output; if that is closed or its disk is full, the error message says so and does not report a bug.
/// </summary>
internal sealed class ResultsWriter(TextWriter output) : TextWriter
{
    private StringBuilder? _held;

    public override Encoding Encoding => output.Encoding;

    public override void Write(char value) => Write(value.ToString());

    public override void Write(string? value)
    {
        if (_held is not null)
        {
            _held.Append(value);
        }
        else
        {
            Checked(() => output.Write(value));
        }
    }

    public override void WriteLine(string? value)
    {
        if (_held is not null)
        {
            _held.Append(value).Append(output.NewLine);
        }
        else
        {
            Checked(() => output.WriteLine(value));
        }
    }

    public override void Flush() => Checked(output.Flush);

    /// <summary>Holds text back until <see cref="Release"/>.</summary>
    public void Hold() => _held = new StringBuilder();

    /// <summary>Writes the text that was held back.</summary>
    public void Release()
    {
        string? held = _held?.ToString();
        _held = null;
        Write(held);
    }

    private static void Checked(Action write) => FileErrors.ToExternalPart("standard output can't be written", write);
}
