using Msisf.App.Settings.Specs;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Scene;

namespace Msisf.App.Preparation;

/// <summary>What a camera needs to know of its states beside time, place and orientation, and what it makes of them.</summary>
internal sealed record StateNeeds
{
    /// <summary>The camera file whose shutter needs to know how the camera moves; null if nothing does.</summary>
    public string? CameraWithShutter { get; init; }

    /// <summary>Whether the states are to say how the camera moves wherever that is known, without a shutter too.</summary>
    public bool FindsMotions { get; init; }

    /// <summary>Whether a detector needs to know its noise.</summary>
    public bool HasDetector { get; init; }

    /// <summary>How images are scanned; null for frames.</summary>
    public Scan? Scan { get; init; }

    /// <summary>Small turns of the camera; null for none.</summary>
    public JitterFile? Jitter { get; init; }

    /// <summary>s: how long before and after the middle of an exposure the state must be known.</summary>
    public double ExposureReach { get; init; }

    /// <summary>How the camera sits on the body whose states are read; null for a camera that has the states itself.</summary>
    public Mounting? Mounting { get; init; }

    /// <summary>Whether the motion about the time of an image is needed.</summary>
    public bool NeedsMotion => Scan is null && (FindsMotions || CameraWithShutter is not null);

    /// <summary>Whether the motion in all the time of an image is needed.</summary>
    public bool NeedsPath => Scan is not null || Jitter is not null;

    /// <summary>What the camera of a run needs.</summary>
    public static StateNeeds Of(RenderSettings settings) => new()
    {
        CameraWithShutter = settings.Shutter is null ? null : settings.Camera!.Name,
        HasDetector = settings.Native.Detector is not null,
        Scan = settings.Scan,
        Jitter = settings.Jitter,
        ExposureReach = settings.ExposureReach,
        Mounting = settings.Rig?.Mounting,
    };

    /// <summary>The states as the camera has them.</summary>
    /// <param name="states">As they were read.</param>
    /// <param name="trajectory">Where they come from.</param>
    /// <exception cref="Core.Errors.MsisfException">A motion is missing, or something is said twice.</exception>
    public IReadOnlyList<SpacecraftState> Of(IReadOnlyList<SpacecraftState> states, TrajectorySettings trajectory)
    {
        IReadOnlyList<SpacecraftState> scanning = NeedsPath
            ? ScanStates.Of(states, trajectory.Motion, this)
            : [.. states.Select(state => state with { Path = PathOf(state, trajectory) })];
        IReadOnlyList<SpacecraftState> moving = Scan is not null ? [.. scanning.Select(state => state with { Motion = null })]
            : Jitter is not null && CameraWithShutter is not null && scanning.All(state => state.Motion is not null) ? scanning
            : !FindsMotions ? StateMotions.Of(scanning, trajectory, CameraWithShutter)
            : trajectory.Motion is { } motion ? [.. scanning.Select(state => state with { Motion = motion })]
            : scanning;
        IReadOnlyList<SpacecraftState> all = StateNoise.Of(moving, trajectory, HasDetector);
        return Mounting is { } mounting && !NeedsPath ? [.. all.Select(body => Mounted(body, mounting))] : all;
    }

    /// <summary>Instants of an exposure lie on the samples' own motion; other cameras of a rig may have asked for more.</summary>
    private ScanPath? PathOf(SpacecraftState state, TrajectorySettings trajectory) => Mounting is null ? state.Path
        : trajectory is SampledSettings ? state.Path?.Of(null, null, 0.0, Mounting)
        : null;

    private static SpacecraftState Mounted(SpacecraftState body, Mounting mounting)
    {
        CameraState camera = mounting.Of(new CameraState(body.PositionBodyFixed, body.MoonFromCamera));
        return body with
        {
            PositionBodyFixed = camera.PositionBodyFixed,
            MoonFromCamera = camera.MoonFromCamera,
            Motion = body.Motion is { } motion ? mounting.Of(motion, body.MoonFromCamera) : null,
        };
    }
}

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
