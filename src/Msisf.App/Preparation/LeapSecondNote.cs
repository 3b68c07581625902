using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Says how a series of times counts over a leap second.</summary>
internal static class LeapSecondNote
{
    /// <summary>The note; null if the times are given one by one, or no leap second lies between them.</summary>
    /// <param name="states">Those of the series, in order.</param>
    public static string? Of(TrajectorySettings trajectory, IReadOnlyList<SpacecraftState> states)
    {
        (Instant first, Instant last) = (states[0].Time, states[^1].Time);
        if (last - first == last.Utc - first.Utc)
        {
            return null;
        }

        string between = $"there is a leap second between {first.ToIsoUtc()} and {last.ToIsoUtc()}";
        return trajectory is MissionSettings { Every: not null }
            ? $"{MissionOptions.Every.Name} counts SI seconds: {between}, so that the images after it are a second earlier on the clock."
            : TimesOf(trajectory) is TimeInterval
                ? $"{CameraOptions.TimeInterval.Name} counts days of 86,400 s on the clock: {between}, so that the step over it takes a "
                    + "second longer."
                : null;
    }

    private static IEnumerable<CalendarTime>? TimesOf(TrajectorySettings trajectory) => trajectory switch
    {
        OrbitSettings orbit => orbit.Times,
        PlaceSettings place => place.Times,
        MissionSettings mission => mission.Times,
        SampledSettings sampled => sampled.Times,
        _ => null,
    };
}
