using System.Collections.Concurrent;
using Msisf.Adapters.Catalogues;
using Msisf.Adapters.IO;
using Msisf.Core.Navigation;

namespace Msisf.Server;

/// <summary>
/// GET /v1/catalogues/NAME and /v1/names: the craters of a catalogue of <c>--catalogues</c>, and the Moon's named features, the largest
/// first. A file is read once.
/// </summary>
/// <param name="catalogues">The files by their names.</param>
/// <param name="installation">Where the list of names is looked for after the working directory.</param>
internal sealed class CraterEndpoints(IReadOnlyDictionary<string, string> catalogues, Installation installation)
{
    private readonly ConcurrentDictionary<string, Lazy<IReadOnlyList<Crater>>> _read = new(StringComparer.Ordinal);

    public Task AnswerCatalogueAsync(HttpContext context)
    {
        string name = (string)context.Request.RouteValues["name"]!;
        return catalogues.TryGetValue(name, out string? path)
            ? JsonBody.SendAsync(context.Response, new { Name = name, Craters = Read(path).Select(Described) })
            : throw new RefusedException(
                StatusCodes.Status404NotFound,
                $"'{name}' is no catalogue of this server; GET /v1/models lists them, and --catalogues names them.");
    }

    /// <summary>The names of the list that scripts/get-names.sh fetched, else the 300 largest, which come with the program.</summary>
    public Task AnswerNamesAsync(HttpContext context)
    {
        string? fetched = ((string[])[".", installation.Root])
            .Select(folder => Path.Combine(folder, "input", "names", "names.csv")).FirstOrDefault(File.Exists);
        IReadOnlyList<Crater> features = Read(fetched ?? Path.Combine(AppContext.BaseDirectory, "wwwroot/names/largest.csv"));
        return JsonBody.SendAsync(context.Response, new
        {
            Source = fetched is null ? "the 300 largest" : "input/names/names.csv",
            Names = features.Where(feature => feature.Name is not null).Select(Described),
        });
    }

    private IReadOnlyList<Crater> Read(string path) =>
        _read.GetOrAdd(path, _ => new Lazy<IReadOnlyList<Crater>>(() => CraterCatalogueReader.ReadLargest(path))).Value;

    private static object Described(Crater crater) => new
    {
        crater.Name,
        Latitude = crater.LatitudeDegrees,
        Longitude = crater.LongitudeDegrees,
        crater.Diameter,
    };
}
