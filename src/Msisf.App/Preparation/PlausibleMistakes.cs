using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Camera;
using Msisf.Core.Detector;
using Msisf.Core.Detector.Psf;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>
/// Finds input that is allowed, but most likely meant in another unit. Each warning says what the number means and would mean.
/// </summary>
internal static class PlausibleMistakes
{
    private const double FullTurn = 2.0 * Math.PI;

    /// <summary>degrees: the Narrow Angle Camera of LRO has 2.86, more than a hundred times as much.</summary>
    private const double NarrowFieldOfView = 0.02;

    /// <summary>degrees: radians typed with four digits are so near to a whole number of degrees.</summary>
    private const double WholeDegrees = 0.003;

    /// <summary>rad: a full turn, typed with four digits, is not a mistake.</summary>
    private const double RoundedTurn = 1e-3;

    /// <summary>Limit of 1 - e: a spacecraft slower than a hundredth of a circular orbit's 1,600 m/s has less.</summary>
    private const double StraightFall = 1e-4;

    /// <summary>m/s: no orbit in the solar system is as fast; a velocity in mm/s, or multiplied by 1000 twice, is.</summary>
    private const double FastestSpacecraft = 100_000.0;

    /// <summary>m: a position nearer to the centre than the Moon's radius, but farther than this, looks like a height.</summary>
    private const double LeastHeight = 1000.0;

    /// <summary>m: a height in kilometres is less.</summary>
    private const double LeastHeightInMetres = 1000.0;

    /// <summary>nm: from the near ultraviolet to where the Moon's heat begins to count.</summary>
    private static readonly (double Min, double Max) UsualBand = (300.0, 2600.0);

    /// <summary>m: a height between the Moon's radius and so much more looks like a distance from the Moon's centre.</summary>
    private const double LowOrbit = 200_000.0;

    /// <summary>The warnings that the camera's settings deserve.</summary>
    public static IEnumerable<string> In(TrajectorySettings trajectory, CelestialBody body) => trajectory switch
    {
        OrbitSettings orbit => [.. Elements(orbit.Elements), .. Fall(orbit.Elements), .. Rates(orbit), .. Interval(orbit.Times)],
        PlaceSettings place =>
        [
            .. Speed([place.Motion]), .. Radians(PointingOptions.Position, place.Place), .. Radius(place.Place, body),
            .. place.Pointing.Kind == BoresightKind.Place ? Radians(PointingOptions.LookAt, place.Pointing.Target) : [],
            .. Interval(place.Times),
        ],
        _ => Speed([trajectory.Motion]),
    };

    /// <summary>The warning that the speed of moving cameras deserves.</summary>
    /// <param name="motions">Motion of the camera, or of each state; null where it is not known.</param>
    public static IEnumerable<string> Speed(IEnumerable<CameraMotion?> motions)
    {
        double fastest = motions.Max(motion => motion?.VelocityBodyFixed.Length) ?? 0.0;
        return fastest <= FastestSpacecraft ? [] :
        [
            Invariant(
                $"the camera moves at {fastest / 1000.0:#,0.#} km/s: velocities are in m/s. If {fastest:R} is mm/s, or km/s that were "
                    + $"multiplied twice, write {fastest / 1000.0:R}."),
        ];
    }

    /// <summary>The warning that a field of view deserves.</summary>
    /// <param name="degrees">The field of view as it was given.</param>
    /// <param name="widestImage">m: greatest width on the ground of the images of the run.</param>
    /// <param name="cell">m: width of a cell of the elevation model.</param>
    public static IEnumerable<string> FieldOfView(double degrees, double widestImage, double cell)
    {
        string text = NumberSpec.TextOf(degrees);
        double asRadians = double.RadiansToDegrees(degrees);
        if (degrees < NarrowFieldOfView)
        {
            yield return Invariant(
                $"--fov {text} is {degrees * 3600.0:G3} seconds of arc: the images are {Length(widestImage)} wide on the ground at the "
                    + $"nearest. --fov is in degrees.");
        }
        else if (degrees < Math.PI && (IsRadiansOfWholeDegrees(text, asRadians) || widestImage < cell))
        {
            yield return Invariant(
                $"--fov {text} is in degrees: the images are {Length(widestImage)} wide on the ground at the nearest, a cell of "
                    + $"the elevation model is {Length(cell)}. {text} rad would be --fov {asRadians:G4}.");
        }
    }

    /// <summary>The note that a detector's band deserves.</summary>
    /// <param name="band">The band; null without a detector.</param>
    public static IEnumerable<string> Band(SpectralResponse? band)
    {
        if (band is not null && (band.Shortest < UsualBand.Min || band.Longest > UsualBand.Max))
        {
            yield return Invariant(
                $"The detector's band is {band.Shortest:R} to {band.Longest:R} nm; what lies outside {UsualBand.Min} to "
                    + $"{UsualBand.Max:#,0} nm is less certain: the Sun is a black body there, and the Moon's own heat is left out.");
        }
    }

    /// <summary>What far wings leave out.</summary>
    /// <param name="wings">Wings of the detector; null for none.</param>
    public static IEnumerable<string> Wings(FarWings? wings)
    {
        if (wings is not null)
        {
            yield return Invariant(
                $"'psf-wings' spreads the light of the image up to {wings.Reach:R} px; light of ground beside the image is left out.");
        }
    }

    /// <summary>The width on the ground of an image with its camera looking down on the sphere, m.</summary>
    /// <param name="radius">m: radius of the sphere.</param>
    public static double WidthOnGround(Frame frame, double radius) => 2.0 * Math.Tan(frame.Camera.Bands[0].Camera.FieldOfView / 2.0)
        * Math.Abs(frame.Camera.PositionBodyFixed.Length - radius);

    /// <summary>What a position inside the body most likely means, by the way in which it was given.</summary>
    /// <param name="positionBodyFixed">m, body-fixed.</param>
    /// <param name="trajectory">How the position was given; null if that is not known.</param>
    /// <returns>A sentence with a blank before it.</returns>
    public static string Inside(Vector3D positionBodyFixed, CelestialBody body, TrajectorySettings? trajectory) => trajectory switch
    {
        PlaceSettings { Place: var place } => Height(place, body),
        BatchFileSettings =>
            $"{FromCentre(positionBodyFixed, body)} Heights (lat, lon, height) are in metres over the sphere; terrain+METRES "
            + "counts from the terrain.",
        _ => FromCentre(positionBodyFixed, body),
    };

    private static string Height(SurfacePlace place, CelestialBody body)
    {
        if (place.IsOverTerrain)
        {
            return " Heights over the terrain are in metres, upwards.";
        }

        string kilometres = place.Height is > 0.0 and < LeastHeightInMetres
            ? Invariant($" If {place.Height:R} is kilometres, write {1000.0 * place.Height:R}.")
            : string.Empty;
        string sphere = body.IsMoon
            ? Invariant($"the sphere of {MoonConstants.ReferenceRadius:R} m")
            : "the model's sphere";
        return $" The height is in metres over {sphere}; terrain+METRES counts from the terrain.{kilometres}";
    }

    private static string FromCentre(Vector3D positionBodyFixed, CelestialBody body)
    {
        double kilometres = positionBodyFixed.Length;
        return kilometres > (body.IsMoon ? 1700.0 : body.MeanRadius / 1000.0) && kilometres < 100_000.0
            ? Invariant($" Positions are in metres: {kilometres:G5} from the centre looks like kilometres; multiply by 1000.")
            : $" Positions are in metres from {(body.IsMoon ? "the Moon's" : $"{body.Name}'s")} centre{IfHeight(kilometres, body)}.";
    }

    private static string IfHeight(double metres, CelestialBody body) => body.IsMoon && metres is > LeastHeight and < LowOrbit
        ? Invariant($"; if {metres:G10} m is a height, {MoonConstants.ReferenceRadius + metres:G10} m from the centre is meant")
        : string.Empty;

    private static IEnumerable<string> Elements(KeplerElements elements)
    {
        (string Name, double Angle)[] angles =
        [
            ("omega", elements.ArgumentOfPeriapsis), ("Omega", elements.LongitudeOfAscendingNode), ("i", elements.Inclination),
            ("M0", elements.MeanAnomalyAtEpoch),
        ];
        string[] large = [.. angles.Where(angle => Math.Abs(angle.Angle) > FullTurn + RoundedTurn).Select(angle => Invariant(
            $"{angle.Name} {angle.Angle:R} rad (if it is degrees: {double.DegreesToRadians(angle.Angle):G7} rad)"))];
        return large.Length == 0 ? [] : [$"--kepler-set: more than a full turn: {string.Join(", ", large)}. Angles are in radians."];
    }

    private static IEnumerable<string> Fall(KeplerElements elements)
    {
        if (1.0 - elements.Eccentricity < StraightFall)
        {
            yield return Invariant(
                $"the orbit is a fall straight to the Moon's centre (e = {elements.Eccentricity:G10}): the velocity of --state-vectors is "
                    + $"in m/s. One in km/s is to be multiplied by 1000.");
        }
    }

    /// <summary>The warning that a place deserves whose angles are those of whole degrees, in radians.</summary>
    private static IEnumerable<string> Radians(OptionSpec option, SurfacePlace place)
    {
        double[] angles = [place.LatitudeDegrees, place.LongitudeDegrees];
        double[] degrees = [.. angles.Select(double.RadiansToDegrees)];
        bool isMeant = angles.Any(angle => angle != 0.0) && Math.Abs(degrees[0]) < 90.0 + WholeDegrees
            && Math.Abs(degrees[1]) < 360.0 + WholeDegrees
            && angles.Zip(degrees).All(
                pair => pair.First == 0.0 || IsRadiansOfWholeDegrees(NumberSpec.TextOf(Math.Abs(pair.First)), pair.Second));
        return !isMeant ? [] :
        [
            Invariant(
                $"{option.Name}: latitude and longitude are in degrees. If {angles[0]:R},{angles[1]:R} is radians, write "
                    + $"{degrees[0]:F2},{degrees[1]:F2}."),
        ];
    }

    private static IEnumerable<string> Radius(SurfacePlace place, CelestialBody body)
    {
        if (place.IsOverTerrain)
        {
            yield break;
        }

        double height = place.Height - body.MeanRadius;
        double ofKilometres = (1000.0 * place.Height) - body.MeanRadius;
        if (height is >= 0.0 and <= LowOrbit)
        {
            yield return Invariant(
                $"--position: heights are over the surface, not from the Moon's centre. If {place.Height:R} m is from the centre, write "
                    + $"{height:R}.");
        }
        else if (ofKilometres is >= 0.0 and <= LowOrbit)
        {
            yield return Invariant(
                $"--position: heights are in metres over the surface. If {place.Height:R} is kilometres from the Moon's centre, write "
                    + $"{ofKilometres:R}.");
        }
        else if (place.Height is > 0.0 and < LeastHeightInMetres)
        {
            yield return Invariant(
                $"--position: heights are in metres over the sphere. If {place.Height:R} is kilometres, write {1000.0 * place.Height:R}; "
                    + $"if it counts from the terrain, write terrain+{place.Height:R}.");
        }
    }

    private static IEnumerable<string> Rates(OrbitSettings orbit)
    {
        if (orbit.Attitude?.AngularVelocityCamera is { } rate && rate.Length > FullTurn)
        {
            yield return Invariant(
                $"--attitude-transition: {rate.Length:G4} rad/s is more than a full turn a second; if it is degrees a second, write "
                    + $"{double.DegreesToRadians(rate.Length):G4} rad/s.");
        }
    }

    private static IEnumerable<string> Interval(IEnumerable<CalendarTime> times)
    {
        if (times is not TimeInterval { Count: > 0 } interval)
        {
            yield break;
        }

        (double step, double length) = (interval.Step / Duration.Day, interval.Length / Duration.Day);
        if (Math.Abs(step) > Math.Abs(length) && length != 0.0)
        {
            yield return Invariant(
                $"--time-interval: the step of {step:R} days is longer than the interval of {length:G6} days, "
                    + $"so there is one image. If the step is seconds, write {step / 86400.0:G10}.");
        }
    }

    private static string Length(double metres) => metres < 1000.0
        ? Invariant($"{metres:G3} m")
        : Invariant($"{metres / 1000.0:#,0.#} km");

    /// <summary>Whether a number with some digits is the radians of a whole number of degrees, such as 0.7854.</summary>
    private static bool IsRadiansOfWholeDegrees(string text, double asRadians) =>
        text.Count(char.IsAsciiDigit) > 4 && Math.Abs(asRadians - Math.Round(asRadians)) < WholeDegrees;
}
