using System.Text;

namespace Msisf.Cli.Output;

/// <summary>
/// Writes to standard output; if that is closed or its disk is full, the error message says so and does not report a bug.
/// </summary>
internal sealed class ResultsWriter : TextWriter
{
    private readonly TextWriter _output;
    private StringBuilder? _held;

    public ResultsWriter(TextWriter output) => _output = output;

    public override Encoding Encoding => _output.Encoding;

    public override void Write(char value) => Write(value.ToString());

    public override void Write(string? value)
    {
        if (_held is not null)
        {
            _held.Append(value);
        }
        else
        {
            Checked(() => _output.Write(value));
        }
    }

    public override void WriteLine(string? value)
    {
        if (_held is not null)
        {
            _held.Append(value).Append(_output.NewLine);
        }
        else
        {
            Checked(() => _output.WriteLine(value));
        }
    }

    public override void Flush() => Checked(_output.Flush);

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
