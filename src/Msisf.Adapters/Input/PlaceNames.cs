using System.Text;
using Msisf.Core.Attitude;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Input;

/// <summary>
/// The Moon's named places: features of the IAU's list and landing sites, which come with the program (lib/places). They are read when the
/// first one is looked for.
/// </summary>
public static class PlaceNames
{
    /// <summary>How many places a message lists at most.</summary>
    private const int MostListed = 5;

    private const string LandingSite = "landing site";

    /// <summary>Letters with accents, and below each the one without; the runtime's own tables would need the library ICU.</summary>
    private const string Accented = "áàâäãåąçćčďéèêëěęíìîïłńñňóòôöõøřśšťúùûüůýžźż";

    private const string Plain = "aaaaaaacccdeeeeeeiiiilnnnoooooorsstuuuuuyzzz";

    private static readonly Lazy<IReadOnlyList<NamedPlace>> Read = new(() =>
        [.. Rows("features.csv").Select(Feature), .. Rows("landing-sites.csv").Select(Site)]);

    private static readonly Lazy<ILookup<string, NamedPlace>> ByKey = new(() =>
        All.SelectMany(place => Keys(place.Name).Select(key => (key, place))).ToLookup(pair => pair.key, pair => pair.place));

    /// <summary>All places, features by name before landing sites by name.</summary>
    public static IReadOnlyList<NamedPlace> All => Read.Value;

    /// <summary>The place of a name. Case, accents, blanks and punctuation do not matter.</summary>
    /// <exception cref="BadInputException">There is none, or several; the message has what was perhaps meant.</exception>
    public static NamedPlace Find(string name)
    {
        NamedPlace[] found = [.. ByKey.Value[Key(name)].Distinct()];
        return found.Length == 1 ? found[0]
            // Mees, and Mee S
            : Array.Find(found, place => place.Name.Equals(name, StringComparison.OrdinalIgnoreCase)) is { } exact ? exact
            : throw new BadInputException(found.Length == 0 ? Unknown(name) : $"'{name}' is the name of {Listed(found)}. Give one's "
                + "latitude and longitude.");
    }

    /// <summary>The places whose names hold a text, those that are it or begin with it first, then the largest first.</summary>
    /// <exception cref="BadInputException">There is none.</exception>
    public static IReadOnlyList<NamedPlace> Search(string text)
    {
        string key = Key(text);
        NamedPlace[] found = [.. All.Select(place => (Place: place, Rank: Keys(place.Name).Min(name => Rank(name, key))))
            .Where(pair => pair.Rank < int.MaxValue).OrderBy(pair => pair.Rank).ThenByDescending(pair => pair.Place.Diameter)
            .Select(pair => pair.Place)];
        return found.Length > 0 ? found : throw new BadInputException(Unknown(text));
    }

    /// <summary>All places with their distances along the sphere, m; the nearest first.</summary>
    /// <param name="latitude">degrees.</param>
    /// <param name="longitude">degrees, east.</param>
    public static IEnumerable<(NamedPlace Place, double Distance)> Near(double latitude, double longitude)
    {
        Vector3D from = Direction(latitude, longitude);
        return All.Select(place => (
                place, MoonConstants.ReferenceRadius * Vector3D.AngleBetween(from, Direction(place.Latitude, place.Longitude))))
            .OrderBy(pair => pair.Item2);
    }

    private static Vector3D Direction(double latitude, double longitude) =>
        new SelenographicPoint(double.DegreesToRadians(latitude), double.DegreesToRadians(longitude)).ToDirectionBodyFixed();

    private static string Unknown(string name)
    {
        string key = Key(name);
        NamedPlace[] near = key.Length < 3 ? [] : [.. All.Where(place => Keys(place.Name).Any(known => known.Contains(key)))
            .OrderByDescending(place => place.Diameter).Take(MostListed)];
        string meant = near.Length > 0 ? $": did you mean {Listed(near)}?"
            : NearestName.Question(name, [.. All.Select(place => place.Name)], otherwise: ".");
        return $"{NumberText.Shown(name)} is not a named place of the Moon{meant} msis places lists them.";
    }

    private static string Listed(IReadOnlyList<NamedPlace> places) => string.Join(", ", places.Take(MostListed).Select(place => Invariant(
        $"{place.Name} ({place.Kind}, {place.Latitude:R},{place.Longitude:R})")));

    private static int Rank(string name, string key) => name == key ? 0
        : name.StartsWith(key, StringComparison.Ordinal) ? 1
        : name.Contains(key, StringComparison.Ordinal) ? 2
        : int.MaxValue;

    /// <summary>The keys of a name, and of its spelling in brackets: "Engel'gardt (Engelhardt) B" is "Engelhardt B" too.</summary>
    private static IEnumerable<string> Keys(string name)
    {
        int open = name.IndexOf('(');
        int close = name.IndexOf(')');
        return open < 0 || close < open ? [Key(name)] :
        [
            Key(name), Key(name.Remove(open, close - open + 1)),
            Key($"{name[(open + 1)..close]}{name[(close + 1)..]}"),
        ];
    }

    /// <summary>The letters and digits of a name, without accents, in small letters.</summary>
    private static string Key(string name)
    {
        StringBuilder key = new();
        foreach (char letter in name.Where(char.IsLetterOrDigit).Select(char.ToLowerInvariant))
        {
            int place = Accented.IndexOf(letter);
            key.Append(place < 0 ? letter : Plain[place]);
        }

        return key.ToString();
    }

    private static NamedPlace Feature(string[] fields) => new(
        fields[0], fields[1], Number(fields[2]), Number(fields[3]), fields[4].Length > 0 ? 1000.0 * Number(fields[4]) : 0.0);

    private static NamedPlace Site(string[] fields) => new(fields[0], LandingSite, Number(fields[1]), Number(fields[2]), 0.0);

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    /// <summary>The rows of a list below its heading.</summary>
    private static IEnumerable<string[]> Rows(string name)
    {
        using StreamReader reader = new(typeof(PlaceNames).Assembly.GetManifestResourceStream(name)!);
        reader.ReadLine();
        while (reader.ReadLine() is { } line)
        {
            yield return line.Split(',');
        }
    }
}

/// <summary>A named place.</summary>
/// <param name="Name">As the IAU writes it, or the spacecraft that landed there.</param>
/// <param name="Kind">The IAU's descriptor term in small letters, or "landing site".</param>
/// <param name="Latitude">degrees, planetocentric.</param>
/// <param name="Longitude">degrees, east, from 0 to below 360.</param>
/// <param name="Diameter">m; 0 where there is none.</param>
public sealed record NamedPlace(string Name, string Kind, double Latitude, double Longitude, double Diameter);
