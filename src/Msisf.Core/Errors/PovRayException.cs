namespace Msisf.Core.Errors;

/// <summary>POV-Ray is missing or failed (exit code 3).</summary>
public sealed class PovRayException : ExternalPartException
{
    /// <summary>Makes the failure.</summary>
    /// <param name="message">One line: what, where, what to do.</param>
    /// <param name="inner">The foreign exception behind it, if there is one.</param>
    public PovRayException(string message, Exception? inner = null)
        : base(message, inner)
    {
    }
}
