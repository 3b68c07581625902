using Msisf.Core.Errors;

namespace Msisf.Stress.Time;

/// <summary>Whether an input gets a clear error.</summary>
internal static class Refusals
{
    /// <summary>The message of the error that the user would read; null if there is none. Any other exception goes on.</summary>
    public static string? Of(Func<object> action)
    {
        try
        {
            _ = action();
            return null;
        }
        catch (MsisfException exception)
        {
            return exception.Message;
        }
    }
}
