namespace Msisf.TestSupport;

/// <summary>
/// How much of a random comparison is done: enough for every day, or, with MSISF_LONG_TESTS=1, what the accuracy that the documents
/// state was shown with. Either way the tests run; none is skipped.
/// </summary>
internal static class TestLength
{
    /// <summary>Whether the long form was asked for.</summary>
    public static bool IsLong { get; } = Environment.GetEnvironmentVariable("MSISF_LONG_TESTS") == "1";

    /// <summary>The amount of work.</summary>
    public static int Of(int everyDay, int longForm) => IsLong ? longForm : everyDay;
}
