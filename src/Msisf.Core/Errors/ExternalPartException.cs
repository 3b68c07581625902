namespace Msisf.Core.Errors;

/// <summary>CSPICE, POV-Ray, a database or the file system failed or is missing (exit code 3).</summary>
public class ExternalPartException : MsisfException
{
    /// <summary>Makes the failure.</summary>
    /// <param name="message">One line: what, where, what to do.</param>
    /// <param name="inner">The foreign exception behind it, if there is one.</param>
    public ExternalPartException(string message, Exception? inner = null)
        : base(exitCode: 3, message, inner)
    {
    }
}
