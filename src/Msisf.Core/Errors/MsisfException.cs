namespace Msisf.Core.Errors;

/// <summary>An expected failure: its message says what is wrong, where, and what to do; it never needs a stack trace.</summary>
public abstract class MsisfException : Exception
{
    /// <summary>Makes the failure.</summary>
    /// <param name="exitCode">Exit code of the program (docs/command-line-rules.md).</param>
    /// <param name="message">One line: what, where, what to do.</param>
    /// <param name="inner">The foreign exception behind it, if there is one.</param>
    protected MsisfException(int exitCode, string message, Exception? inner)
        : base(message, inner) => ExitCode = exitCode;

    /// <summary>Exit code of the program when this failure ends it.</summary>
    public int ExitCode { get; }

    /// <summary>
    /// Long names of the options that the failure is about, e.g. "--fov"; empty if there are none or they are not set yet.
    /// </summary>
    public IReadOnlyList<string> Options { get; set; } = [];
}
