using Msisf.App.Settings;
using Msisf.Core.Orbit;
using Msisf.Core.Terrain;

namespace Msisf.App.Preparation;

/// <summary>Notes on the frames of an orbit whose defaults a user may not expect.</summary>
internal static class OrbitNotes
{
    /// <summary>s: longer times are told in days.</summary>
    private const double LongestInHours = 2.0 * 86400.0;

    /// <summary>All notes that apply.</summary>
    /// <param name="orbit">The orbit; its times are computed once each.</param>
    public static IEnumerable<string> Of(OrbitSettings orbit)
    {
        double seconds = orbit.Times.Select(time => Math.Abs(time.SecondsSince(orbit.Epoch))).DefaultIfEmpty().Max();
        if (orbit.Frame == OrbitFrame.MoonMe && !orbit.IsFrameGiven && seconds > 0.0)
        {
            yield return $"the orbit is propagated in Moon axes that turn with the Moon (the default, {CameraOptions.OrbitFrame.Name} "
                + $"moon-me, as in the thesis): {Cost(seconds)}. For a real orbit take {CameraOptions.OrbitFrame.Name} moon-me-epoch "
                + "(given in the Moon's axes of the epoch) or j2000.";
        }

        if (orbit.Attitude is not null && orbit.AttitudeFrame is null && orbit.Frame != OrbitFrame.MoonMe)
        {
            yield return "--attitude is taken in Moon axes that turn with the Moon (the default, "
                + $"{CameraOptions.AttitudeFrame.Name} moon-me), the orbit in {CameraOptions.OrbitFrame.WordOf(orbit.Frame)}. "
                + $"{CameraOptions.AttitudeFrame.Name} names other axes.";
        }
    }

    /// <summary>How far the ground track moves away from that of a real orbit.</summary>
    private static string Cost(double seconds)
    {
        double angle = MoonConstants.RotationRate * seconds;
        string time = seconds < LongestInHours
            ? Invariant($"{seconds / 3600.0:G3} h")
            : Invariant($"{seconds / 86400.0:G4} days");
        string distance = angle < Math.PI
            ? Invariant($"{double.RadiansToDegrees(angle):G3} degrees, up to {MoonConstants.ReferenceRadius * angle / 1000.0:G3} km")
            : Invariant($"{angle / (2.0 * Math.PI):G3} turns of the Moon");
        return $"{time} from the epoch its ground track is off by {distance}";
    }
}
