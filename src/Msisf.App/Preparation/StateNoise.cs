using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Scene;

namespace Msisf.App.Preparation;

/// <summary>Says for each state of a run which noise its detector has, where the user chooses it.</summary>
internal static class StateNoise
{
    /// <summary>The states with their noise.</summary>
    /// <param name="states">The states; those of a batch file may have a noise of their own.</param>
    /// <param name="trajectory">Where they come from, with the noise of the first one.</param>
    /// <param name="hasDetector">Whether there is a detector; else there is no noise.</param>
    /// <exception cref="UsageException">The noise is said twice.</exception>
    public static IReadOnlyList<SpacecraftState> Of(IReadOnlyList<SpacecraftState> states, TrajectorySettings trajectory, bool hasDetector)
    {
        bool isInFile = states.Any(state => state.Noise is not null);
        if (trajectory.Noise is { } first)
        {
            return !isInFile
                ? [.. states.Select((state, index) => state with { Noise = first with { Step = first.Step + (ulong)index } })]
                : throw new UsageException(
                    $"{NativeOptions.NoiseSeed.Name} and the batch file both say the noise seed. Leave one out.")
                    .About(NativeOptions.NoiseSeed);
        }

        return isInFile && !hasDetector ? [.. states.Select(state => state with { Noise = null })] : states;
    }
}
