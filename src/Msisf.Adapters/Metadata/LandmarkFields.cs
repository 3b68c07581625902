using Msisf.Core.Navigation;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Metadata;

/// <summary>The values of a landmark in an image, by their names in CSV; degrees, m and px, round-trip.</summary>
internal static class LandmarkFields
{
    /// <summary>The values; empty where one is not defined.</summary>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static IEnumerable<(string Name, string Value)> Of(LandmarkView view, double referenceRadius)
    {
        SelenographicPoint place = SelenographicPoint.Below(view.PointBodyFixed);
        PixelDerivatives by = view.Derivatives;
        return
        [
            ("latitude", Text(double.RadiansToDegrees(place.Latitude))),
            ("longitude", Text(double.RadiansToDegrees(place.Longitude))),
            ("height", Text(view.PointBodyFixed.Length - referenceRadius)),
            ("x", Text(view.PointBodyFixed.X)),
            ("y", Text(view.PointBodyFixed.Y)),
            ("z", Text(view.PointBodyFixed.Z)),
            ("h", Text(view.X)),
            ("v", Text(view.Y)),
            ("visible", view.HiddenBy is null ? "yes" : "no"),
            ("hiddenBy", view.HiddenBy is { } facet ? Text(facet) : string.Empty),
            ("lit", view.IsLit ? "yes" : "no"),
            ("incidence", view.Incidence is { } incidence ? Text(double.RadiansToDegrees(incidence)) : string.Empty),
            ("range", Text(view.Range)),
            ("pixelScale", Text(view.PixelScale)),
            ("hByShift", Text(by.XByShift)),
            ("hByTurn", Text(by.XByTurn)),
            ("hByPoint", Text(by.XByPoint)),
            ("vByShift", Text(by.YByShift)),
            ("vByTurn", Text(by.YByTurn)),
            ("vByPoint", Text(by.YByPoint)),
        ];
    }

    private static string Text(double value) => CraterFields.TextOf(value);

    private static string Text(Vector3D vector) => $"{Text(vector.X)} {Text(vector.Y)} {Text(vector.Z)}";

    /// <summary>Part, line, sample and half of the cell.</summary>
    private static string Text(FacetId facet) =>
        Invariant($"{facet.Part} {facet.Line} {facet.Sample} {(facet.Half == FacetHalf.SouthWest ? "SW" : "NE")}");
}
