using Msisf.Core.Errors;

namespace Msisf.Server;

/// <summary>A request that the server does not answer: too large, too many, or not what it understands.</summary>
/// <param name="status">HTTP status.</param>
/// <param name="message">What is wrong and what to do.</param>
internal sealed class RefusedException(int status, string message) : MsisfException(exitCode: 1, message, inner: null)
{
    /// <summary>HTTP status.</summary>
    public int Status { get; } = status;
}
