using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Input;

/// <summary>Reads places: heights are metres over the sphere, or <c>terrain+100</c> over the terrain.</summary>
public static class PlaceText
{
    /// <summary>What a height may look like, for messages.</summary>
    public const string ValidHeights = "metres over the sphere of 1737400 m, or 'terrain+METRES' over the terrain";

    private const string Terrain = "terrain";

    /// <summary>Reads a height.</summary>
    /// <param name="text">The characters of the height alone.</param>
    /// <returns>m, and whether the height counts from the terrain.</returns>
    /// <exception cref="BadInputException">It is not a height.</exception>
    public static (double Height, bool IsOverTerrain) ParseHeight(string text)
    {
        bool isOverTerrain = text.StartsWith(Terrain, StringComparison.OrdinalIgnoreCase);
        string number = isOverTerrain ? text[Terrain.Length..] : text;
        if (isOverTerrain && number.Length == 0)
        {
            return (0.0, true);
        }

        bool isSigned = number.Length > 0 && number[0] is '+' or '-';
        return (!isOverTerrain || isSigned) && NumberText.TryParse(number, out double height)
            ? (height, isOverTerrain)
            : throw new BadInputException($"{NumberText.Shown(text)} is not a height; write {ValidHeights}.");
    }

    /// <summary>Reads an angle.</summary>
    /// <param name="text">The characters of the number alone.</param>
    /// <param name="what">What it is, for messages, e.g. "the latitude".</param>
    /// <returns>degrees.</returns>
    /// <exception cref="BadInputException">It is not a number.</exception>
    public static double ParseDegrees(string text, string what) => NumberText.TryParse(text, out double degrees)
        ? degrees
        : throw new BadInputException($"{what}: {NumberText.ProblemWith(text)}.");

    /// <summary>Whether a text is a name, and no number: it begins with a letter, or has several words, as "8 Homeward" has.</summary>
    public static bool IsName(string text) =>
        text.Length > 0 && (char.IsLetter(text[0]) || (text.Contains(' ') && text.Any(char.IsLetter)));

    /// <summary>A named place of the Moon.</summary>
    /// <param name="name">As <see cref="PlaceNames.Find"/> takes it.</param>
    /// <param name="body">The body that is drawn.</param>
    /// <param name="height">m, and whether it counts from the terrain.</param>
    /// <exception cref="BadInputException">There is no place of this name, there are several, or the body is not the Moon.</exception>
    public static SurfacePlace Named(string name, CelestialBody body, (double Height, bool IsOverTerrain) height)
    {
        if (!body.IsMoon)
        {
            throw new BadInputException(
                $"{NumberText.Shown(name)} is a name, and the named places are the Moon's, but {body.Name} is drawn. "
                    + "Give latitude and longitude.");
        }

        NamedPlace place = PlaceNames.Find(name);
        return new SurfacePlace(place.Latitude, place.Longitude, height.Height, height.IsOverTerrain);
    }

    /// <summary>Makes a place, and finds latitude and longitude that were swapped.</summary>
    /// <param name="latitude">degrees.</param>
    /// <param name="longitude">degrees, east.</param>
    /// <param name="height">m, and whether it counts from the terrain.</param>
    /// <exception cref="BadInputException">A number is out of its range.</exception>
    public static SurfacePlace Place(double latitude, double longitude, (double Height, bool IsOverTerrain) height)
    {
        try
        {
            return new SurfacePlace(latitude, longitude, height.Height, height.IsOverTerrain);
        }
        catch (BadInputException exception) when (Math.Abs(latitude) is > 90.0 and <= 360.0 && Math.Abs(longitude) <= 90.0)
        {
            throw new BadInputException($"{exception.Message} Are latitude and longitude swapped? The latitude comes first.", exception);
        }
    }
}
