using System.Text;
using Msisf.Core.Errors;

namespace Msisf.Cli.Run;

/// <summary>Standard output; that it is closed or its disk is full is told as what it is, and not as a bug.</summary>
internal sealed class ResultsWriter : TextWriter
{
    private readonly TextWriter _output;

    public ResultsWriter(TextWriter output) => _output = output;

    public override Encoding Encoding => _output.Encoding;

    public override void Write(char value) => Checked(() => _output.Write(value));

    public override void Write(string? value) => Checked(() => _output.Write(value));

    public override void WriteLine(string? value) => Checked(() => _output.WriteLine(value));

    public override void Flush() => Checked(_output.Flush);

    private static void Checked(Action write)
    {
        try
        {
            write();
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new ExternalPartException($"standard output can't be written: {exception.Message}", exception);
        }
    }
}
