namespace Msisf.Core.Errors;

/// <summary>A file or a value does not hold what it should (exit code 2).</summary>
public sealed class BadInputException : MsisfException
{
    /// <summary>Makes the failure.</summary>
    /// <param name="message">One line: what, where, what to do.</param>
    /// <param name="inner">The foreign exception behind it, if there is one.</param>
    public BadInputException(string message, Exception? inner = null)
        : base(exitCode: 2, message, inner)
    {
    }
}
