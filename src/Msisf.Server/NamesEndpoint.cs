using Msisf.Adapters.Catalogues;
using Msisf.Adapters.IO;
using Msisf.Core.Navigation;

namespace Msisf.Server;

/// <summary>
/// GET /v1/names: the named features of the Moon, the largest first. They are those of the list that scripts/get-names.sh fetched, else
/// the 300 largest, which come with the program.
/// </summary>
/// <param name="installation">Where the list is looked for after the working directory.</param>
internal sealed class NamesEndpoint(Installation installation)
{
    private readonly Lazy<(string Source, IReadOnlyList<Crater> Features)> _read = new(() => Read(installation));

    public Task AnswerAsync(HttpContext context) => JsonBody.SendAsync(context.Response, new
    {
        _read.Value.Source,
        Names = _read.Value.Features.Where(feature => feature.Name is not null).Select(feature => new
        {
            feature.Name,
            Latitude = feature.LatitudeDegrees,
            Longitude = feature.LongitudeDegrees,
            feature.Diameter,
        }),
    });

    private static (string Source, IReadOnlyList<Crater> Features) Read(Installation installation)
    {
        string? fetched = ((string[])[".", installation.Root])
            .Select(folder => Path.Combine(folder, "input", "names", "names.csv")).FirstOrDefault(File.Exists);
        return fetched is null
            ? ("the 300 largest", CraterCatalogueReader.ReadLargest(Path.Combine(AppContext.BaseDirectory, "wwwroot/names/largest.csv")))
            : ("input/names/names.csv", CraterCatalogueReader.ReadLargest(fetched));
    }
}
