namespace Msisf.TestSupport;

/// <summary>Models that <c>msis ldem synthesize</c> makes, with seed 1.</summary>
internal static class SyntheticModels
{
    /// <returns>Path of the model's label.</returns>
    public static string Make(string folder, params string[] options)
    {
        CommandLineRun made = CommandLineRun.Of(["ldem", "synthesize", .. options, "--seed", "1", "--output-dir", folder, "--batch"]);
        return made.ExitCode == 0 ? made.Output.Trim() : throw new InvalidOperationException(made.Error);
    }

    /// <summary>A map of the south polar region.</summary>
    /// <param name="scale">m/px.</param>
    public static string MakePolar(string folder, int scale) =>
        Make(folder, "--projection", "polar-south", "--map-scale", $"{scale}");
}
