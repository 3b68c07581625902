using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Says for each state of a run how the camera moves, where a shutter needs to know.</summary>
internal static class StateMotions
{
    /// <summary>
    /// s: the difference of the states this long before and after a time is the motion. The change of an orbit's acceleration in it changes
    /// the velocity by less than 1e-7 m/s; rounding of the positions to less than 1e-6 m/s.
    /// </summary>
    private const double HalfStep = 0.005;

    /// <summary>rad: how far the camera may turn in twice that time, so that the way it turns is known.</summary>
    private const double MaxTurn = Math.PI / 2.0;

    private const double SecondsPerDay = 86400.0;

    /// <summary>The states with their motions; without any if no shutter needs them.</summary>
    /// <param name="trajectory">Where they come from.</param>
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
            return known == 0
                ? [.. states.Select(state => state with { Motion = motion })]
                : throw new UsageException(
                    $"{CameraOptions.Motion.Name} and the batch file both say how the camera moves. Leave one out.")
                    .About(CameraOptions.Motion);
        }

        return known == states.Count
            ? states
            : throw new UsageException(
                $"--camera {cameraWithShutter} has a shutter, but nothing says how the camera moves while it is open. Give "
                    + $"{CameraOptions.Motion.Name}, or {string.Join(", ", CameraMotion.NumberNames)} in each line of the batch file, "
                    + "or an orbit; or remove 'shutter' from the camera file.")
                .About(CameraOptions.Motion, ImageOptions.Camera);
    }

    /// <summary>The motion on an orbit at a time.</summary>
    /// <param name="time">UTC.</param>
    /// <param name="orbit">The orbit with its attitude.</param>
    /// <exception cref="BadInputException">The camera turns too fast.</exception>
    public static CameraMotion About(ModifiedJulianDate time, Func<ModifiedJulianDate, SpacecraftState> stateAt, OrbitSettings orbit)
    {
        double rate = orbit.Attitude?.AngularVelocityCamera.Length ?? 0.0;
        if (rate * 2.0 * HalfStep > MaxTurn)
        {
            throw new BadInputException(Invariant(
                $"--attitude-transition turns the camera by {rate:G3} rad/s; with a shutter {MaxTurn / (2.0 * HalfStep):G3} rad/s is the "
                    + $"most. Check it, or remove 'shutter' from the camera file."));
        }

        ModifiedJulianDate start = new(time.Days - (HalfStep / SecondsPerDay));
        ModifiedJulianDate end = new(time.Days + (HalfStep / SecondsPerDay));
        (SpacecraftState before, SpacecraftState after) = (stateAt(start), stateAt(end));
        CameraMotion motion = CameraMotion.Between(
            (before.PositionBodyFixed, before.MoonFromCamera), (after.PositionBodyFixed, after.MoonFromCamera), end.SecondsSince(start));
        return orbit.Attitude is { } attitude && (orbit.AttitudeFrame ?? AttitudeFrame.MoonMe) == AttitudeFrame.MoonMe
            ? motion with { AngularVelocityCamera = attitude.AngularVelocityCamera } // without rounding
            : motion;
    }

    /// <summary>The motion on a mission's path at a time; at the ends of its cover of the inner side.</summary>
    /// <param name="tdbSeconds">TDB seconds past J2000, inside the cover.</param>
    public static CameraMotion About(double tdbSeconds, ICameraPath path)
    {
        double start = path.Cover.Contains(tdbSeconds - HalfStep) ? tdbSeconds - HalfStep : tdbSeconds;
        double end = path.Cover.Contains(tdbSeconds + HalfStep) ? tdbSeconds + HalfStep : tdbSeconds;
        if (start == end)
        {
            throw new BadInputException(
                "the files say how the camera is at a single time only, and not how it moves while the shutter is open. Remove 'shutter' "
                    + "from the camera file.");
        }

        (CameraState before, CameraState after) = (path.At(start), path.At(end));
        return CameraMotion.Between(
            (before.PositionBodyFixed, before.MoonFromCamera), (after.PositionBodyFixed, after.MoonFromCamera), end - start);
    }
}
