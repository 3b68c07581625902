using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Input;

/// <summary>Reads the values of the options that place and point a camera without a quaternion.</summary>
public static class PointingText
{
    /// <summary>What a camera may look at, for messages.</summary>
    public const string ValidTargets = "LAT,LON[,HEIGHT], NAME[,HEIGHT], nadir, sun or horizon:AZIMUTH";

    /// <summary>What is said of a place beyond the camera's horizon.</summary>
    public const string Hidden = "lies behind ground that hides it from the camera; the image shows that ground. "
        + "Are latitude (first) and longitude (east) what you mean?";

    private const string Horizon = "horizon:";

    /// <summary>Reads a position, <c>LAT,LON,HEIGHT</c> or <c>NAME,HEIGHT</c>.</summary>
    /// <param name="text">The value.</param>
    /// <param name="body">The body that is drawn; the named places are the Moon's.</param>
    /// <exception cref="BadInputException">It is not a position.</exception>
    public static SurfacePlace ParsePosition(string text, CelestialBody body)
    {
        string[] parts = text.Split(',', StringSplitOptions.TrimEntries);
        return parts.Length == 3 || (parts.Length == 2 && PlaceText.IsName(parts[0]))
            ? Place(parts, body)
            : throw new BadInputException(
                $"{NumberText.Shown(text)} has {parts.Length} {(parts.Length == 1 ? "part" : "parts")}; LAT,LON,HEIGHT or "
                    + $"NAME,HEIGHT is needed: degrees, degrees east, {PlaceText.ValidHeights}.");
    }

    /// <summary>Reads what the camera looks at: a place, or a word.</summary>
    /// <param name="text">The value.</param>
    /// <param name="body">The body that is drawn; the named places are the Moon's.</param>
    /// <exception cref="BadInputException">It is neither a place nor one of the words.</exception>
    public static CameraPointing ParseTarget(string text, CelestialBody body)
    {
        string[] parts = text.Split(',', StringSplitOptions.TrimEntries);
        if (parts.Length > 1)
        {
            return parts.Length <= 3
                ? new CameraPointing { Kind = BoresightKind.Place, Target = Place(parts, body) }
                : throw new BadInputException($"{NumberText.Shown(text)} has {parts.Length} parts; {ValidTargets} is needed.");
        }

        return text.ToUpperInvariant() switch
        {
            "NADIR" => new CameraPointing(),
            "SUN" => new CameraPointing { Kind = BoresightKind.Sun },
            _ when text.StartsWith(Horizon, StringComparison.OrdinalIgnoreCase) => new CameraPointing
            {
                Kind = BoresightKind.Horizon,
                Azimuth = double.DegreesToRadians(PlaceText.ParseDegrees(text[Horizon.Length..], "the azimuth (degrees)")),
            },
            _ when PlaceText.IsName(text) => Named(text, body),
            _ => throw new BadInputException($"{NumberText.Shown(text)} is nothing to look at; {ValidTargets} is needed."),
        };
    }

    /// <summary>Reads an angle from the nadir, <c>ANGLE[,AZIMUTH]</c>.</summary>
    /// <param name="text">The value.</param>
    /// <exception cref="BadInputException">It is not an angle, or the angle is out of its range.</exception>
    public static CameraPointing ParseOffNadir(string text)
    {
        string[] parts = text.Split(',', StringSplitOptions.TrimEntries);
        return parts.Length <= 2
            ? OffNadir(
                PlaceText.ParseDegrees(parts[0], "the angle (degrees)"),
                parts.Length > 1 ? PlaceText.ParseDegrees(parts[1], "the azimuth (degrees)") : 0.0)
            : throw new BadInputException($"{NumberText.Shown(text)} has {parts.Length} parts; ANGLE[,AZIMUTH] is needed, in degrees.");
    }

    /// <summary>Reads what points up in the image: zenith, north or sun.</summary>
    /// <param name="text">The value.</param>
    /// <exception cref="BadInputException">It is none of these.</exception>
    internal static UpDirection ParseUp(string text) => text.ToUpperInvariant() switch
    {
        "ZENITH" => UpDirection.Zenith,
        "NORTH" => UpDirection.North,
        "SUN" => UpDirection.Sun,
        _ => throw new BadInputException($"{NumberText.Shown(text)} is not up; zenith, north or sun is needed."),
    };

    /// <summary>A pointing at an angle from the nadir.</summary>
    /// <param name="angle">degrees, 0 to 180.</param>
    /// <param name="azimuth">degrees, clockwise from north.</param>
    /// <exception cref="BadInputException">The angle is out of its range.</exception>
    internal static CameraPointing OffNadir(double angle, double azimuth) => new()
    {
        Kind = BoresightKind.OffNadir,
        OffNadir = double.DegreesToRadians(Core.Guard.InRange(angle, 0.0, 180.0, "The angle from the nadir (degrees)")),
        Azimuth = double.DegreesToRadians(azimuth),
    };

    /// <summary>A place to look at that is named, and its ground; a misspelt word may also have been meant as one of the others.</summary>
    private static CameraPointing Named(string name, CelestialBody body)
    {
        try
        {
            return new CameraPointing { Kind = BoresightKind.Place, Target = Place([name], body) };
        }
        catch (BadInputException exception)
        {
            throw new BadInputException(
                $"{NumberText.Shown(name)} is nothing to look at; {ValidTargets} is needed. {exception.Message}", exception);
        }
    }

    /// <summary>A place of latitude and longitude, or a name, and, if there is one, height; without one it lies on the terrain.</summary>
    private static SurfacePlace Place(string[] parts, CelestialBody body) => parts.Length < 3 && PlaceText.IsName(parts[0])
        ? PlaceText.Named(parts[0], body, HeightOf(parts[1..]))
        : PlaceText.Place(
            PlaceText.ParseDegrees(parts[0], "the latitude (degrees)"),
            PlaceText.ParseDegrees(parts[1], "the longitude (degrees east)"), HeightOf(parts[2..]));

    private static (double Height, bool IsOverTerrain) HeightOf(string[] parts) =>
        parts.Length > 0 ? PlaceText.ParseHeight(parts[0]) : (0.0, true);
}
