using Msisf.Core.Navigation;

namespace Msisf.Adapters.Metadata;

/// <summary>The numbers of a crater in an image, by their names in CSV; degrees, m and px, round-trip.</summary>
internal static class CraterFields
{
    public static string WordOf(CraterRim rim) => rim == CraterRim.Terrain ? "terrain" : "disc";

    public static string WordOf(CraterLeftOutReason reason) => reason == CraterLeftOutReason.Hyperbola ? "hyperbola" : "no-ellipse";

    /// <summary>The numbers; null where one is not defined.</summary>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static IEnumerable<(string Name, double? Value)> Of(CraterView view, double referenceRadius) =>
    [
        ("latitude", view.Crater.LatitudeDegrees),
        ("longitude", view.Crater.LongitudeDegrees),
        ("diameter", view.Crater.Diameter),
        ("minorDiameter", view.Crater.MinorDiameter),
        ("angle", view.Crater.AngleDegrees),
        ("height", view.Disc.Centre.Length - referenceRadius),
        ("h", view.Ellipse.X),
        ("v", view.Ellipse.Y),
        ("semiMajor", view.Ellipse.SemiMajor),
        ("semiMinor", view.Ellipse.SemiMinor),
        ("turn", double.RadiansToDegrees(view.Ellipse.Angle)),
        ("inside", view.Inside),
        ("hidden", view.Hidden),
        ("lit", view.Lit),
        ("incidence", double.RadiansToDegrees(view.Incidence)),
        ("emission", double.RadiansToDegrees(view.Emission)),
        ("residual", view.Residual),
    ];

    /// <summary>A number as text; empty for none.</summary>
    public static string TextOf(double? value) => value?.ToString("R", CultureInfo.InvariantCulture) ?? string.Empty;
}
