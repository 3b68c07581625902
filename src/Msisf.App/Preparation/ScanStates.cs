using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Says for each state of a run where the camera is at the times of all exposures of its image.</summary>
internal static class ScanStates
{
    /// <summary>s: an MJD holds 0.6 microseconds, so that a scan up to the last sample may end so much behind it.</summary>
    private const double OfRounding = 2e-6;

    /// <summary>s: as long before and after a time the camera is looked at to know its motion, if its shutter is not open for
    /// longer.</summary>
    private const double HalfStep = 0.005;

    /// <summary>The states with their exposures, and turned by the jitter.</summary>
    /// <param name="states">The states; those of orbits and files have a path.</param>
    /// <param name="motion">How the camera moves, where the user says it; null for what the states say.</param>
    /// <param name="needs">The exposures, the jitter, whose times count from the first image's, and the mounting.</param>
    /// <exception cref="MsisfException">A motion is missing, or not known for all of the time.</exception>
    public static IReadOnlyList<SpacecraftState> Of(IReadOnlyList<SpacecraftState> states, CameraMotion? motion, StateNeeds needs)
    {
        (Scan? scan, JitterFile? jitter, double reach) = (needs.Scan, needs.Jitter, needs.ExposureReach);
        return [.. states.Select((state, index) =>
        {
            double start = index == 0 ? 0.0 : state.Time.SecondsSince(states[0].Time);
            double end = scan?.SecondsOf(scan.Count - 1) ?? 0.0;
            RequireJitter(jitter, start - reach, start + end + reach);
            ScanPath path = PathOf(state, motion, scan).Of(scan, jitter?.Jitter, start, needs.Mounting);
            _ = (path.At(-reach), path.At(end + reach)); // otherwise the last line would find what is missing
            bool isMoving = scan is null && (motion ?? state.Motion) is not null;
            return state with
            {
                Path = path,
                PositionBodyFixed = needs.Mounting is null ? state.PositionBodyFixed : path.States[0].PositionBodyFixed,
                MoonFromCamera = path.States[0].MoonFromCamera,
                Motion = isMoving ? path.FastestMotion(-Math.Max(reach, HalfStep), Math.Max(reach, HalfStep)) : state.Motion,
            };
        })];
    }

    /// <summary>The states of an image's exposures, each as that of an image.</summary>
    public static IEnumerable<SpacecraftState> ExposuresOf(SpacecraftState state) => state.Path is { States.Count: > 1 } path
        ? path.States.Select((exposure, index) => new SpacecraftState(
            state.Time.After(exposure.Seconds), exposure.PositionBodyFixed, exposure.MoonFromCamera)
        {
            Motion = path.MotionAt(exposure.Seconds) ?? path.MotionBetween(
                path.States[Math.Max(0, index - 1)].Seconds, path.States[Math.Min(index + 1, path.States.Count - 1)].Seconds),
            SunPositionBodyFixed = state.SunPositionBodyFixed,
        })
        : [state];

    /// <summary>The motion that states are samples of.</summary>
    /// <exception cref="MsisfException">There are too few, their times do not rise, or they have no velocities.</exception>
    public static SampledMotion MotionOf(IReadOnlyList<SpacecraftState> samples, SampledSettings settings)
    {
        string file = settings.Samples.Path;
        if (samples.Count < 2)
        {
            throw new BadInputException($"{file}: {(samples.Count == 0 ? "no state" : "one state only")} in it; a motion needs two or "
                + "more.");
        }

        for (int i = 1; i < samples.Count; i++)
        {
            if (!(samples[i].Time > samples[i - 1].Time))
            {
                throw new BadInputException($"{file}: state {i + 1} ({samples[i].Time.ToIsoUtc()}) is not later than the one before. "
                    + "Samples of a motion are in the order of their times.");
            }
        }

        bool hasVelocities = samples.All(sample => sample.Motion is not null);
        InterpolationMethod positions =
            settings.Positions ?? (hasVelocities ? InterpolationMethod.Hermite : InterpolationMethod.Lagrange);
        if (positions == InterpolationMethod.Hermite && !hasVelocities)
        {
            throw ScanOptions.Positions.Wrong(
                $"hermite needs velocities: {string.Join(", ", CameraMotion.NumberNames)} in each line of {file}. Add them, or choose "
                    + "lagrange.");
        }

        // Writers without rates write zeros.
        bool hasRates = hasVelocities && samples.Any(sample => sample.Motion!.Value.AngularVelocityCamera != default);
        AttitudePath attitudes = settings.Attitudes ?? (hasRates ? AttitudePath.Hermite : AttitudePath.Slerp);
        return attitudes != AttitudePath.Hermite || hasVelocities
            ? new SampledMotion(samples, positions, attitudes)
            : throw ScanOptions.Attitudes.Wrong(
                $"hermite needs angular velocities: {string.Join(", ", CameraMotion.NumberNames)} in each line of {file}. Add them, or "
                    + "choose slerp.");
    }

    /// <summary>The state of an image between samples.</summary>
    /// <param name="file">For messages.</param>
    /// <exception cref="BadInputException">The time is before the first sample or after the last.</exception>
    public static SpacecraftState Between(SampledMotion motion, Instant time, string file)
    {
        double start = time.SecondsSince(motion.Start);
        CameraState state = At(0.0);
        return new SpacecraftState(time, state.PositionBodyFixed, state.MoonFromCamera)
        {
            Path = new ScanPath(At, seconds => motion.MotionAt(Math.Clamp(start + seconds, 0.0, motion.End))),
        };

        CameraState At(double seconds)
        {
            double at = start + seconds;
            return at >= -OfRounding && at <= motion.End + OfRounding
                ? motion.At(Math.Clamp(at, 0.0, motion.End))
                : throw new BadInputException(Invariant(
                    $"{ScanOptions.Trajectory.Name} {file}: its states reach from {motion.Start.ToIsoUtc()} over {motion.End:R} s, and the "
                        + $"state {at:R} s after the first one is needed. Add states, or choose another {CameraOptions.Time.Name} or fewer "
                        + $"lines."));
        }
    }

    /// <summary>The motion at a time.</summary>
    public static CameraMotion MotionAbout(SampledMotion motion, Instant time) =>
        motion.MotionAt(Math.Clamp(time.SecondsSince(motion.Start), 0.0, motion.End));

    private static ScanPath PathOf(SpacecraftState state, CameraMotion? motion, Scan? scan)
    {
        if (state.Path is { } known)
        {
            return known;
        }

        CameraState still = new(state.PositionBodyFixed, state.MoonFromCamera);
        return (motion ?? state.Motion) is { } moving ? new ScanPath(seconds => moving.Moved(still, seconds), _ => moving)
            : scan is null ? new ScanPath(_ => still)
            : throw new UsageException(
                $"nothing says how the camera moves while it scans. Give {ScanOptions.Trajectory.Name}, an orbit, the files of a "
                    + "mission, or "
                    + $"{CameraOptions.Motion.Name}.").About(CameraOptions.Motion, ImageOptions.Camera);
    }

    private static void RequireJitter(JitterFile? file, double start, double end)
    {
        if (file is not null && file.Jitter.Cover is var (first, last) && (start < first || end > last))
        {
            throw new BadInputException(Invariant(
                $"{ScanOptions.Jitter.Name} {file.Path}: it is known from {first:R} s to {last:R} s after the first image's time, and the "
                    + $"images need it from {start:R} s to {end:R} s. Add lines, or make the image shorter."));
        }
    }
}
