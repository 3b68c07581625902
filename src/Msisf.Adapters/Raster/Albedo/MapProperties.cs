using System.Globalization;
using Msisf.Adapters.Input;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// What the values of a map mean, as far as it is known: I/F = scale x value + offset in a geometry of light and view. Null is unknown.
/// </summary>
public sealed record MapProperties
{
    private static readonly string[] Names = ["scale", "offset", "west", "incidence", "emission", "phase", "band"];

    /// <summary>The names that <see cref="Parse"/> knows.</summary>
    public static string ValidValues => string.Join(", ", Names);

    /// <summary>I/F for a step of the stored value.</summary>
    public double? Scale { get; init; }

    /// <summary>I/F of the stored value 0.</summary>
    public double? Offset { get; init; }

    /// <summary>East longitude of the left edge, degrees.</summary>
    public double? WestDegrees { get; init; }

    /// <summary>Incidence angle of the map's I/F, degrees.</summary>
    public double? IncidenceDegrees { get; init; }

    /// <summary>Emission angle of the map's I/F, degrees.</summary>
    public double? EmissionDegrees { get; init; }

    /// <summary>Phase angle of the map's I/F, degrees.</summary>
    public double? PhaseDegrees { get; init; }

    /// <summary>Band of the map, nm.</summary>
    public double? BandNanometres { get; init; }

    /// <summary>Reads a text such as "scale=3.16e-4,west=-180".</summary>
    /// <exception cref="BadInputException">A name is unknown or given twice, or a value is no number or out of range.</exception>
    public static MapProperties Parse(string text)
    {
        Dictionary<string, double> values = new(StringComparer.Ordinal);
        foreach (string part in text.Split(','))
        {
            string[] pair = part.Split('=', 2, StringSplitOptions.TrimEntries);
            if (pair.Length != 2 || !Names.Contains(pair[0], StringComparer.Ordinal) || !NumberText.TryParse(pair[1], out double value))
            {
                throw new BadInputException($"'{part}' is no property of a map; name=number is needed, with one of {ValidValues}.");
            }

            if (!values.TryAdd(pair[0], value))
            {
                throw new BadInputException($"the property {pair[0]} is given twice. Leave one out.");
            }
        }

        double? Within(string name, double least, double greatest) => values.TryGetValue(name, out double value)
            ? value >= least && value <= greatest ? value : throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture, $"{name} is {value:R}; a number from {least:R} to {greatest:R} is needed."))
            : null;
        return new MapProperties
        {
            Scale = Within("scale", 1e-12, 1e6),
            Offset = Within("offset", -1e6, 1e6),
            WestDegrees = Within("west", -360.0, 360.0),
            IncidenceDegrees = Within("incidence", 0.0, 89.0),
            EmissionDegrees = Within("emission", 0.0, 89.0),
            PhaseDegrees = Within("phase", 0.0, 180.0),
            BandNanometres = Within("band", 100.0, 1e5),
        };
    }

    /// <summary>These properties; what is unknown comes from others.</summary>
    public MapProperties Or(MapProperties others) => new()
    {
        Scale = Scale ?? others.Scale,
        Offset = Offset ?? others.Offset,
        WestDegrees = WestDegrees ?? others.WestDegrees,
        IncidenceDegrees = IncidenceDegrees ?? others.IncidenceDegrees,
        EmissionDegrees = EmissionDegrees ?? others.EmissionDegrees,
        PhaseDegrees = PhaseDegrees ?? others.PhaseDegrees,
        BandNanometres = BandNanometres ?? others.BandNanometres,
    };

    /// <summary>The known properties as <see cref="Parse"/> reads them; empty if there are none.</summary>
    public override string ToString()
    {
        double?[] values = [Scale, Offset, WestDegrees, IncidenceDegrees, EmissionDegrees, PhaseDegrees, BandNanometres];
        return string.Join(',', Names.Zip(values).Where(pair => pair.Second is not null).Select(
            pair => string.Create(CultureInfo.InvariantCulture, $"{pair.First}={pair.Second:R}")));
    }

    /// <summary>The geometry, if it is known completely and exists.</summary>
    internal ReferenceGeometry? Reference =>
        IncidenceDegrees is double incidence && EmissionDegrees is double emission && PhaseDegrees is double phase
            ? new ReferenceGeometry(incidence, emission, phase)
            : null;
}
