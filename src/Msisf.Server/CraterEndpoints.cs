using System.Collections.Concurrent;
using Msisf.Adapters.Catalogues;
using Msisf.Adapters.Input;
using Msisf.Core.Navigation;

namespace Msisf.Server;

/// <summary>
/// GET /v1/catalogues/NAME and /v1/names: the craters of a catalogue of <c>--catalogues</c>, and the Moon's named places, the largest
/// first. A file is read once.
/// </summary>
/// <param name="catalogues">The files by their names.</param>
internal sealed class CraterEndpoints(IReadOnlyDictionary<string, string> catalogues)
{
    private readonly ConcurrentDictionary<string, Lazy<IReadOnlyList<Crater>>> _read = new(StringComparer.Ordinal);

    public Task AnswerCatalogueAsync(HttpContext context)
    {
        string name = (string)context.Request.RouteValues["name"]!;
        return catalogues.TryGetValue(name, out string? path)
            ? JsonBody.SendAsync(context.Response, new CratersAnswer(name, Read(path).Select(Described)))
            : throw new RefusedException(
                StatusCodes.Status404NotFound,
                $"'{name}' is not a catalogue of this server; GET /v1/models lists them, and --catalogues names them.");
    }

    /// <summary>Features and landing sites; these have no size, and are at the end.</summary>
    public static Task AnswerNamesAsync(HttpContext context) => JsonBody.SendAsync(
        context.Response,
        new NamesAnswer("the IAU's names and landing sites", PlaceNames.All.OrderByDescending(place => place.Diameter)));

    private IReadOnlyList<Crater> Read(string path) =>
        _read.GetOrAdd(path, _ => new Lazy<IReadOnlyList<Crater>>(() => CraterCatalogueReader.ReadLargest(path))).Value;

    private static CraterAnswer Described(Crater crater) =>
        new(crater.Name, crater.LatitudeDegrees, crater.LongitudeDegrees, crater.Diameter);
}

/// <summary>The craters of a catalogue.</summary>
internal sealed record CratersAnswer(string Name, IEnumerable<CraterAnswer> Craters);

/// <summary>A crater.</summary>
/// <param name="Latitude">Degrees, as the longitude.</param>
/// <param name="Diameter">m.</param>
internal sealed record CraterAnswer(string? Name, double Latitude, double Longitude, double Diameter);

/// <summary>Named places.</summary>
/// <param name="Source">Where the names are from.</param>
internal sealed record NamesAnswer(string Source, IEnumerable<NamedPlace> Names);
