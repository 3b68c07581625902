namespace Msisf.Core.Errors;

/// <summary>An ephemeris engine failed: CSPICE itself, or a kernel that it or the built-in reader can't use (exit code 3).</summary>
public sealed class SpiceException : ExternalPartException
{
    /// <summary>Makes the failure.</summary>
    /// <param name="message">One line: what, where, what to do.</param>
    /// <param name="inner">The foreign exception behind it, if there is one.</param>
    public SpiceException(string message, Exception? inner = null)
        : base(message, inner)
    {
    }
}
