using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Time;

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

    /// <summary>Whether a sky is drawn that must fit the ground.</summary>
    public bool HasSky { get; init; }

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
        HasSky = settings.Native.Sky is { IsDrawn: true },
        Scan = settings.Scan,
        Jitter = settings.Jitter,
        ExposureReach = settings.ExposureReach,
        Mounting = settings.Rig?.Mounting,
    };

    /// <summary>The states as the camera has them.</summary>
    /// <param name="states">As they were read.</param>
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
    /// <param name="states">The states; those of a batch file may have a noise of their own.</param>
    /// <param name="trajectory">Where they come from, with the noise of the first one.</param>
    /// <param name="hasDetector">Whether there is a detector; otherwise there is no noise.</param>
    /// <exception cref="UsageException">The noise is said twice.</exception>
    public static IReadOnlyList<SpacecraftState> Of(IReadOnlyList<SpacecraftState> states, TrajectorySettings trajectory, bool hasDetector)
    {
        bool isInFile = states.Any(state => state.Noise is not null);
        if (trajectory.Noise is { } first)
        {
            StateReader.RefuseTwo(isInFile, NativeOptions.NoiseSeed, "the noise seed");
            return [.. states.Select((state, index) => state with { Noise = first with { Step = first.Step + (ulong)index } })];
        }

        return isInFile && !hasDetector ? [.. states.Select(state => state with { Noise = null })] : states;
    }
}

/// <summary>Says for each state of a run how the camera moves, where a shutter needs to know.</summary>
internal static class StateMotions
{
    /// <summary>
    /// s: where files say no velocity, the difference of the states this long before and after a time is the motion. Rounding of the
    /// positions changes the velocity by up to 2e-4 m/s.
    /// </summary>
    private const double HalfStep = 0.005;

    /// <summary>The states with their motions; without any if no shutter needs them.</summary>
    /// <param name="cameraWithShutter">The camera file with the shutter; null for none.</param>
    /// <exception cref="UsageException">A motion is missing, or said twice.</exception>
    public static IReadOnlyList<SpacecraftState> Of(
        IReadOnlyList<SpacecraftState> states, TrajectorySettings trajectory, string? cameraWithShutter)
    {
        if (cameraWithShutter is null)
        {
            return states.Any(state => state.Motion is not null)
                ? [.. states.Select(state => state with { Motion = null })]
                : states;
        }

        int known = states.Count(state => state.Motion is not null);
        if (trajectory.Motion is { } motion)
        {
            StateReader.RefuseTwo(known > 0, CameraOptions.Motion, "how the camera moves");
            return [.. states.Select(state => state with { Motion = motion })];
        }

        return known == states.Count
            ? states
            : throw new UsageException(
                $"--camera {cameraWithShutter} has a shutter, but nothing says how the camera moves while it is open. Give "
                    + $"{CameraOptions.Motion.Name}, or {string.Join(", ", CameraMotion.NumberNames)} in each line of the batch file, "
                    + "or an orbit; or remove 'shutter' from the camera file.")
                .About(CameraOptions.Motion, ImageOptions.Camera);
    }

    /// <summary>
    /// The motion on a mission's path at a time: as its files state it, otherwise from states about the time; at the ends of the cover from
    /// those of the inner side. Null where the files say the state at this time only, and no shutter needs more.
    /// </summary>
    /// <param name="time">Inside the cover.</param>
    /// <param name="cameraWithShutter">The camera file with the shutter; null for none.</param>
    /// <exception cref="BadInputException">A shutter needs a motion that is not known.</exception>
    public static CameraMotion? About(Instant time, SpacecraftPath path, string? cameraWithShutter)
    {
        if (path.StatedMotionAt(time) is { } stated)
        {
            return stated;
        }

        (Instant start, Instant end) = (time.After(-HalfStep), time.After(HalfStep));
        start = path.Cover.Contains(start.Tdb) ? start : time;
        end = path.Cover.Contains(end.Tdb) ? end : time;
        if (start == end)
        {
            return cameraWithShutter is null ? null : throw new BadInputException(
                $"--camera {cameraWithShutter}: the files say how the camera is at a single time only, and not how it moves while the "
                    + "shutter is open. Remove 'shutter' from the camera file.");
        }

        (CameraState before, CameraState after) = (path.At(start), path.At(end));
        return CameraMotion.Between(
            (before.PositionBodyFixed, before.MoonFromCamera), (after.PositionBodyFixed, after.MoonFromCamera), end.SecondsSince(start));
    }
}
