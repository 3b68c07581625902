using System.Text.Json.Nodes;
using Msisf.Adapters.Input;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Cli.Output;
using Msisf.Core.Attitude;
using Msisf.Core.Ephemeris;
using Msisf.Core.Terrain;

namespace Msisf.Cli.Commands;

/// <summary><c>msis places</c>: lists the Moon's named places.</summary>
internal static class PlacesCommand
{
    /// <summary>Places that are printed of those around a place.</summary>
    private const int Nearest = 20;

    public static void Print(CommandCall call)
    {
        string name = string.Join(' ', call.Values.Arguments);
        string? near = PlacesOptions.Near.ReadIfGiven(call.Values);
        if (name.Length > 0 && near is not null)
        {
            throw PlacesOptions.Near.Wrong("and NAME exclude each other. Leave one out.");
        }

        (NamedPlace Place, double? Distance)[] rows = near is not null
            ? [.. PlacesOptions.Near.Named(() => Around(near)).Take(Nearest).Select(pair => (pair.Place, (double?)pair.Distance))]
            : [.. (name.Length > 0 ? PlaceNames.Search(name) : PlaceNames.All).Select(place => (place, (double?)null))];
        TextTable.Print(call.Host.Results, TableOptions.Format.Read(call.Values)
            ? TextTable.Json(rows.Select(row => JsonOf(row.Place, row.Distance)))
            : TextTable.Columns([Heading(near is not null), .. rows.Select(row => Row(row.Place, row.Distance))], isRight: false));
    }

    private static IEnumerable<(NamedPlace Place, double Distance)> Around(string text)
    {
        SurfacePlace place = PointingText.ParseTarget(text, CelestialBody.Moon) is { Kind: BoresightKind.Place, Target: var target }
            ? target
            : throw new BadInputException($"{NumberText.Shown(text)} is not a place; LAT,LON or NAME is needed.");
        return PlaceNames.Near(place.LatitudeDegrees, place.LongitudeDegrees);
    }

    private static string[] Heading(bool hasDistance) =>
        ["name", "kind", "latitude", "longitude", "diameter (km)", .. hasDistance ? ["distance (km)"] : Array.Empty<string>()];

    private static string[] Row(NamedPlace place, double? distance) =>
    [
        place.Name, place.Kind, Invariant($"{place.Latitude:R}"), Invariant($"{place.Longitude:R}"),
        place.Diameter > 0.0 ? Invariant($"{place.Diameter / 1000.0:0.###}") : "-",
        .. distance is { } metres ? [Invariant($"{metres / 1000.0:0.0}")] : Array.Empty<string>(),
    ];

    private static JsonObject JsonOf(NamedPlace place, double? distance) => new()
    {
        ["name"] = place.Name,
        ["kind"] = place.Kind,
        ["latitude"] = place.Latitude,
        ["longitude"] = place.Longitude,
        ["diameter"] = place.Diameter > 0.0 ? place.Diameter : null,
        ["distance"] = distance,
    };
}
