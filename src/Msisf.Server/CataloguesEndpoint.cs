using System.Collections.Concurrent;
using Msisf.Adapters.Catalogues;
using Msisf.Core.Navigation;

namespace Msisf.Server;

/// <summary>GET /v1/catalogues/NAME: the craters of a catalogue of <c>--catalogues</c>, the largest first; a file is read once.</summary>
/// <param name="paths">The files by their names.</param>
internal sealed class CataloguesEndpoint(IReadOnlyDictionary<string, string> paths)
{
    private readonly ConcurrentDictionary<string, Lazy<IReadOnlyList<Crater>>> _read = new(StringComparer.Ordinal);

    public Task AnswerAsync(HttpContext context)
    {
        string name = (string)context.Request.RouteValues["name"]!;
        if (!paths.TryGetValue(name, out string? path))
        {
            throw new RefusedException(
                StatusCodes.Status404NotFound,
                $"'{name}' is no catalogue of this server; GET /v1/models lists them, and --catalogues names them.");
        }

        IReadOnlyList<Crater> craters = _read.GetOrAdd(
            name, _ => new Lazy<IReadOnlyList<Crater>>(() => CraterCatalogueReader.ReadLargest(path))).Value;
        return JsonBody.SendAsync(context.Response, new
        {
            Name = name,
            Craters = craters.Select(crater => new
            {
                crater.Name,
                Latitude = crater.LatitudeDegrees,
                Longitude = crater.LongitudeDegrees,
                crater.Diameter,
            }),
        });
    }
}
