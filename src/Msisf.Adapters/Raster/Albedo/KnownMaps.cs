using System.Globalization;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Raster.Albedo;

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
    public static bool IsColourMap(string path)
    {
        string name = Path.GetFileName(path);
        return name.Contains("lroc_color_poles", StringComparison.OrdinalIgnoreCase)
            || name.Contains("svs4720", StringComparison.OrdinalIgnoreCase);
    }

    /// <summary>Whether the scale of the colour map is known in a band.</summary>
    public static bool HasColourMap(int bandNanometres) => ScaleOfColourMap.ContainsKey(bandNanometres);

    /// <summary>The properties of the colour map.</summary>
    /// <param name="path">Its file, for the message.</param>
    /// <param name="bandNanometres">The band that is wanted.</param>
    /// <exception cref="BadInputException">The scale in this band is not known.</exception>
    public static MapProperties ColourMap(string path, int bandNanometres) => new()
    {
        Scale = ScaleOfColourMap.TryGetValue(bandNanometres, out double scale) ? scale : throw new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"{Path.GetFileName(path)}: its scale is known at {string.Join(", ", ScaleOfColourMap.Keys)} nm, not at {bandNanometres} nm. "
                + $"Choose one of these with --band, give scale= with --albedo-map-properties, or use --albedo-map none.")),
        Offset = 0.0,
        WestDegrees = -180.0,
        IncidenceDegrees = 60.0,
        EmissionDegrees = 0.0,
        PhaseDegrees = 60.0,
        BandNanometres = bandNanometres,
    };

    /// <summary>What a PDS3 label says, with the geometry of the products WAC_EMP and WAC_HAPKE.</summary>
    public static MapProperties Of(PdsMapLabel label)
    {
        (double Incidence, double Phase)? geometry = label.Product switch
        {
            var product when product.StartsWith("WAC_EMP", StringComparison.OrdinalIgnoreCase) => (30.0, 30.0),
            var product when product.StartsWith("WAC_HAPKE", StringComparison.OrdinalIgnoreCase) => (60.0, 60.0),
            _ => null,
        };
        return new MapProperties
        {
            Scale = label.ScalingFactor,
            Offset = label.Offset,
            IncidenceDegrees = geometry?.Incidence,
            EmissionDegrees = geometry is null ? null : 0.0,
            PhaseDegrees = geometry?.Phase,
            BandNanometres = label.BandNanometres,
        };
    }
}
