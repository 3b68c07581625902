using Msisf.Adapters.Input;
using Msisf.Core.Render.Photometry;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>
/// What the values of a map mean, as far as it is known: I/F = scale x value + offset in a geometry of light and view. Null is unknown.
/// </summary>
/// <param name="Scale">I/F for a step of the stored value.</param>
/// <param name="Offset">I/F of the stored value 0.</param>
/// <param name="WestDegrees">East longitude of the left edge, degrees.</param>
/// <param name="IncidenceDegrees">Incidence angle of the map's I/F, degrees.</param>
/// <param name="EmissionDegrees">Emission angle of the map's I/F, degrees.</param>
/// <param name="PhaseDegrees">Phase angle of the map's I/F, degrees.</param>
/// <param name="BandNanometres">Band of the map, nm.</param>
public sealed record MapProperties(
    double? Scale = null, double? Offset = null, double? WestDegrees = null, double? IncidenceDegrees = null,
    double? EmissionDegrees = null, double? PhaseDegrees = null, double? BandNanometres = null)
{
    private static readonly string[] Names = ["scale", "offset", "west", "incidence", "emission", "phase", "band"];

    /// <summary>The names that <see cref="Parse"/> knows.</summary>
    public static string ValidValues => string.Join(", ", Names);

    /// <summary>Reads a text such as "scale=3.16e-4,west=-180".</summary>
    /// <exception cref="BadInputException">A name is unknown or given twice, or a value is not a number or out of range.</exception>
    public static MapProperties Parse(string text)
    {
        Dictionary<string, double> values = new(StringComparer.Ordinal);
        foreach (string part in text.Split(','))
        {
            string[] pair = part.Split('=', 2, StringSplitOptions.TrimEntries);
            if (pair.Length != 2 || !Names.Contains(pair[0], StringComparer.Ordinal) || !NumberText.TryParse(pair[1], out double value))
            {
                throw new BadInputException($"'{part}' is not a property of a map; name=number is needed, with one of {ValidValues}.");
            }

            if (!values.TryAdd(pair[0], value))
            {
                throw new BadInputException($"the property {pair[0]} is given twice. Leave one out.");
            }
        }

        double? Within(string name, double least, double greatest) => values.TryGetValue(name, out double value)
            ? value >= least && value <= greatest ? value : throw new BadInputException(Invariant(
                $"{name} is {value:R}; a number from {least:R} to {greatest:R} is needed."))
            : null;
        return new MapProperties(
            Within("scale", 1e-12, 1e6), Within("offset", -1e6, 1e6), Within("west", -360.0, 360.0), Within("incidence", 0.0, 89.0),
            Within("emission", 0.0, 89.0), Within("phase", 0.0, 180.0), Within("band", 100.0, 1e5));
    }

    /// <summary>These properties; what is unknown comes from others.</summary>
    public MapProperties Or(MapProperties others) => new(
        Scale ?? others.Scale, Offset ?? others.Offset, WestDegrees ?? others.WestDegrees, IncidenceDegrees ?? others.IncidenceDegrees,
        EmissionDegrees ?? others.EmissionDegrees, PhaseDegrees ?? others.PhaseDegrees, BandNanometres ?? others.BandNanometres);

    /// <summary>The known properties as <see cref="Parse"/> reads them; empty if there are none.</summary>
    public override string ToString()
    {
        double?[] values = [Scale, Offset, WestDegrees, IncidenceDegrees, EmissionDegrees, PhaseDegrees, BandNanometres];
        return string.Join(',', Names.Zip(values).Where(pair => pair.Second is not null).Select(
            pair => Invariant($"{pair.First}={pair.Second:R}")));
    }

    /// <summary>The geometry, if it is known completely and exists.</summary>
    internal ReferenceGeometry? Reference =>
        IncidenceDegrees is double incidence && EmissionDegrees is double emission && PhaseDegrees is double phase
            ? new ReferenceGeometry(incidence, emission, phase)
            : null;
}

/// <summary>The maps whose properties the program knows (docs/photometry.md).</summary>
internal static class KnownMaps
{
    /// <summary>
    /// NASA SVS 4720: I/F at 60, 0, 60 degrees for a step of the red channel, by band; from Sato's Hapke parameters over 32 degrees.
    /// </summary>
    private static readonly Dictionary<int, double> ScaleOfColourMap = new()
    {
        [415] = 1.76e-4,
        [566] = 2.63e-4,
        [643] = 3.16e-4,
        [689] = 3.45e-4,
    };

    /// <summary>Whether a file's name is that of the colour map of NASA SVS 4720.</summary>
    public static bool IsColourMap(string path) => ((string[])["lroc_color_poles", "svs4720"]).Any(
        name => Path.GetFileName(path).Contains(name, StringComparison.OrdinalIgnoreCase));

    /// <summary>Whether the scale of the colour map is known in a band.</summary>
    public static bool HasColourMap(int bandNanometres) => ScaleOfColourMap.ContainsKey(bandNanometres);

    /// <summary>The properties of the colour map.</summary>
    /// <param name="path">Its file, for the message.</param>
    /// <param name="bandNanometres">The band that is wanted.</param>
    /// <exception cref="BadInputException">The scale in this band is not known.</exception>
    public static MapProperties ColourMap(string path, int bandNanometres) => new(
        Scale: ScaleOfColourMap.TryGetValue(bandNanometres, out double scale) ? scale : throw new BadInputException(
            $"{Path.GetFileName(path)}: its scale is known at {string.Join(", ", ScaleOfColourMap.Keys)} nm, not at {bandNanometres} nm. "
                + $"Choose one of these with --band, give scale= with --albedo-map-properties, or use --albedo-map none."),
        Offset: 0.0, WestDegrees: -180.0, IncidenceDegrees: 60.0, EmissionDegrees: 0.0, PhaseDegrees: 60.0, bandNanometres);

    /// <summary>
    /// What a PDS3 label says of the values, with the geometry of the products WAC_EMP and WAC_HAPKE; otherwise with the label's own.
    /// </summary>
    /// <param name="scale">I/F of a step of the value, as it is read.</param>
    /// <param name="offset">I/F of the value 0.</param>
    public static MapProperties Of(PdsMapHead head, double scale = 1.0, double offset = 0.0)
    {
        (double Incidence, double Emission, double Phase)? geometry = head.Product switch
        {
            var product when product.StartsWith("WAC_EMP", StringComparison.OrdinalIgnoreCase) => (30.0, 0.0, 30.0),
            var product when product.StartsWith("WAC_HAPKE", StringComparison.OrdinalIgnoreCase) => (60.0, 0.0, 60.0),
            _ => head.Angles,
        };
        return new MapProperties(
            scale, offset, WestDegrees: null, geometry?.Incidence, geometry?.Emission, geometry?.Phase, head.BandNanometres);
    }

    /// <inheritdoc cref="Of(PdsMapHead, double, double)"/>
    public static MapProperties Of(PdsMapLabel label) => Of(label.Head, label.ScalingFactor, label.Offset);
}
