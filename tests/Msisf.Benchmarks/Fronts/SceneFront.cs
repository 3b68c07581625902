using Msisf.Benchmarks.Definitions;

namespace Msisf.Benchmarks.Fronts;

/// <summary>Time against error of a scene.</summary>
/// <param name="Scene">The scene.</param>
/// <param name="Results">The ways that were measured, in their order.</param>
/// <param name="Failures">Ways that failed, each with what was said.</param>
internal sealed record SceneFront(
    Scene Scene, IReadOnlyList<SettingResult> Results, IReadOnlyList<(Setting Setting, string Message)> Failures)
{
    /// <summary>A way's result; null if it was not measured.</summary>
    public SettingResult? Of(Setting setting) => Results.FirstOrDefault(result => result.Setting == setting);

    /// <summary>How many times as fast as the thesis's way; null if one of the two was not measured.</summary>
    public double? TimesFasterThanThesis(SettingResult result) => Of(Settings.Thesis) is SettingResult thesis
        ? thesis.Seconds.Median / result.Seconds.Median
        : null;
}
