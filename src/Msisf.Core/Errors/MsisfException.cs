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

/// <summary>Wrong, missing or forbidden options (exit code 1).</summary>
/// <param name="message">One line: what, where, what to do.</param>
/// <param name="inner">The foreign exception behind it, if there is one.</param>
public sealed class UsageException(string message, Exception? inner = null) : MsisfException(exitCode: 1, message, inner);

/// <summary>A file or a value does not hold what it should (exit code 2).</summary>
/// <param name="message">One line: what, where, what to do.</param>
/// <param name="inner">The foreign exception behind it, if there is one.</param>
public sealed class BadInputException(string message, Exception? inner = null) : MsisfException(exitCode: 2, message, inner);

/// <summary>CSPICE, POV-Ray, a database or the file system failed or is missing (exit code 3).</summary>
/// <param name="message">One line: what, where, what to do.</param>
/// <param name="inner">The foreign exception behind it, if there is one.</param>
public class ExternalPartException(string message, Exception? inner = null) : MsisfException(exitCode: 3, message, inner);

/// <summary>An ephemeris engine failed: CSPICE itself, or a kernel that it or the built-in reader can't use (exit code 3).</summary>
/// <param name="message">One line: what, where, what to do.</param>
/// <param name="inner">The foreign exception behind it, if there is one.</param>
public sealed class SpiceException(string message, Exception? inner = null) : ExternalPartException(message, inner);

/// <summary>POV-Ray is missing or failed (exit code 3).</summary>
/// <param name="message">One line: what, where, what to do.</param>
/// <param name="inner">The foreign exception behind it, if there is one.</param>
public sealed class PovRayException(string message, Exception? inner = null) : ExternalPartException(message, inner);

/// <summary>Valid input that contains no frame: an empty batch file or interval (exit code 4).</summary>
/// <param name="message">One line: what, where, what to do.</param>
/// <param name="inner">The foreign exception behind it, if there is one.</param>
public sealed class NothingToRenderException(string message, Exception? inner = null) : MsisfException(exitCode: 4, message, inner);
