namespace Msisf.TestSupport;

/// <summary>The program that tests start in a process of its own: that of MSISF_PROGRAM, or the one that is built with the tests.</summary>
internal static class TestedProgram
{
    /// <summary>What MSISF_PROGRAM names; null without.</summary>
    public static string? Named { get; } = Environment.GetEnvironmentVariable("MSISF_PROGRAM");

    /// <summary>The file to start.</summary>
    public static string File => Named ?? Environment.ProcessPath!; // tests run in .NET's own program

    /// <summary>The words to start it with.</summary>
    /// <param name="arguments">Of msis.</param>
    public static string[] Words(params IReadOnlyList<string> arguments) =>
        Named is null ? [Path.Combine(AppContext.BaseDirectory, "msis.dll"), .. arguments] : [.. arguments];
}
