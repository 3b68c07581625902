namespace Msisf.Core.Errors;

/// <summary>Valid input that contains no frame: an empty batch file or interval (exit code 4).</summary>
public sealed class NothingToRenderException : MsisfException
{
    /// <summary>Makes the failure.</summary>
    /// <param name="message">One line: what, where, what to do.</param>
    /// <param name="inner">The foreign exception behind it, if there is one.</param>
    public NothingToRenderException(string message, Exception? inner = null)
        : base(exitCode: 4, message, inner)
    {
    }
}
