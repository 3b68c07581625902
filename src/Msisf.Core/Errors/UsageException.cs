namespace Msisf.Core.Errors;

/// <summary>Wrong, missing or forbidden options (exit code 1).</summary>
public sealed class UsageException : MsisfException
{
    /// <summary>Makes the failure.</summary>
    /// <param name="message">One line: what, where, what to do.</param>
    /// <param name="inner">The foreign exception behind it, if there is one.</param>
    public UsageException(string message, Exception? inner = null)
        : base(exitCode: 1, message, inner)
    {
    }
}
