using Msisf.App.Settings;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.App.Preparation;

/// <summary>Refuses cameras that lie below the terrain.</summary>
internal static class GroundCheck
{
    /// <summary>Maximum number of steps that a message names.</summary>
    private const int NamedSteps = 5;

    /// <summary>Checks the cameras of all frames.</summary>
    /// <param name="model">The terrain; null to take the reference sphere for it.</param>
    /// <param name="span">s: how long the shutter is open about a frame's time; matters for cameras that move.</param>
    /// <param name="cancellation">Cancels the work between two frames.</param>
    /// <param name="body">The body; null for the Moon.</param>
    /// <param name="trajectory">How the positions were given, for the advice.</param>
    /// <exception cref="BadInputException">A camera lies below the terrain; the message names the steps.</exception>
    public static void Refuse(
        IReadOnlyList<Frame> frames, ElevationModel? model, double span, CancellationToken cancellation, CelestialBody? body = null,
        TrajectorySettings? trajectory = null)
    {
        double reference = model?.Grid.ReferenceRadius ?? MoonConstants.ReferenceRadius;
        List<string> buried = [];
        int count = 0;
        string unit = string.Empty;
        foreach (Frame frame in frames)
        {
            cancellation.ThrowIfCancellationRequested();
            Vector3D position = frame.Camera.PositionBodyFixed;
            double depth = frame.Camera.Bands.Max(band => Depth(band.Camera.PositionBodyFixed));
            if (frame.Motion is { IsRest: false } motion)
            {
                // At the ends of the way, and where it is nearest to the Moon's centre.
                Vector3D way = 0.5 * span * motion.VelocityBodyFixed;
                double squared = Vector3D.Dot(way, way);
                double nearest = squared > 0.0 ? Math.Clamp(-Vector3D.Dot(position, way) / squared, -1.0, 1.0) : 0.0;
                depth = new[] { depth, Depth(position - way), Depth(position + way), Depth(position + (nearest * way)) }.Max();
            }

            if (depth > 0.0 && ++count <= NamedSteps)
            {
                unit = buried.Count == 0 ? PlausibleMistakes.Inside(position, body ?? CelestialBody.Moon, trajectory) : unit;
                buried.Add(Invariant($"step {frame.Step} (MJD {frame.Time.Days:R}) by {depth:F1} m"));
            }
        }

        if (count > 0)
        {
            string rest = count > NamedSteps ? $" and {count - NamedSteps} more" : string.Empty;
            throw new BadInputException(
                $"the camera is inside {(body ?? CelestialBody.Moon).NameInText}: {string.Join(", ", buried)}{rest}. "
                    + $"Choose positions above the terrain.{unit}");
        }

        // A way may lead through the centre, above which there is no place of the model.
        double Depth(Vector3D position) => position.Length < 0.5 * reference
            ? reference - position.Length
            : model?.DepthBelowGround(position) ?? reference - position.Length;
    }
}
