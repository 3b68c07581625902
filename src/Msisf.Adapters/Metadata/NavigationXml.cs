using System.Text;
using Msisf.Core.Navigation;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Metadata;

/// <summary>The elements of a meta file that hold truth for navigation.</summary>
internal static class NavigationXml
{
    /// <summary>The elements, each line with its end.</summary>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public static string Elements(NavigationTruth navigation, double referenceRadius)
    {
        StringBuilder text = new();
        if (navigation.Craters is { } craters)
        {
            Append(text, craters, referenceRadius);
        }

        if (navigation.Landmarks is { } landmarks)
        {
            Append(text, landmarks, referenceRadius);
        }

        return text.ToString();
    }

    private static void Append(StringBuilder text, LandmarksOfFrame landmarks, double referenceRadius)
    {
        text.Append(CultureInfo.InvariantCulture, $"  <LandmarkInformation outside=\"{landmarks.Outside}\">\n");
        foreach (LandmarkView view in landmarks.Views)
        {
            AppendIdentity(text.Append("    <Landmark"), view.Landmark.Number, view.Landmark.Identity, view.Landmark.Name);
            foreach ((string name, string value) in LandmarkFields.Of(view, referenceRadius))
            {
                AppendAttribute(text, name, value.Length > 0 ? value : null);
            }

            text.Append(" />\n");
        }

        text.Append("  </LandmarkInformation>\n");
    }

    private static void Append(StringBuilder text, CratersOfFrame craters, double referenceRadius)
    {
        text.Append(
            CultureInfo.InvariantCulture,
            $"  <CraterInformation rim=\"{CraterFields.WordOf(craters.Rim)}\" leastDiameter=\"{craters.LeastDiameter:R}\" "
                + $"tooSmall=\"{craters.TooSmall}\">\n");
        foreach (CraterView view in craters.Views)
        {
            AppendIdentity(text.Append("    <Crater"), view.Crater.Number, view.Crater.Identity, view.Crater.Name);
            foreach ((string name, double? value) in CraterFields.Of(view, referenceRadius))
            {
                AppendAttribute(text, name, value is null ? null : CraterFields.TextOf(value));
            }

            AppendAttribute(text, "covariance", CraterFields.CovarianceOf(view) is { } covariance
                ? string.Join(' ', covariance.Select(number => CraterFields.TextOf(number)))
                : null);
            text.Append(" />\n");
        }

        foreach (CraterLeftOut leftOut in craters.LeftOut)
        {
            AppendIdentity(text.Append("    <CraterLeftOut"), leftOut.Crater.Number, leftOut.Crater.Identity, leftOut.Crater.Name);
            AppendAttribute(text, "reason", CraterFields.WordOf(leftOut.Reason));
            text.Append(" />\n");
        }

        text.Append("  </CraterInformation>\n");
    }

    private static void AppendIdentity(StringBuilder text, int number, string identity, string? itsName)
    {
        AppendAttribute(text, "number", number.ToString(CultureInfo.InvariantCulture));
        AppendAttribute(text, "id", identity);
        AppendAttribute(text, "name", itsName);
    }

    private static void AppendAttribute(StringBuilder text, string name, string? value)
    {
        if (value is not null)
        {
            text.Append(' ').Append(name).Append("=\"").Append(XmlText.EscapeAttribute(value)).Append('"');
        }
    }
}

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

    /// <summary>
    /// Covariance of h, v, semiMajor, semiMinor and turn, by rows, in the units of these numbers: px and degrees; null without one.
    /// </summary>
    public static double[]? CovarianceOf(CraterView view)
    {
        if (view.Covariance is not { } covariance)
        {
            return null;
        }

        int size = (int)Math.Sqrt(covariance.Count);
        return [.. covariance.Select((number, place) => number * UnitOf(place / size) * UnitOf(place % size))];

        double UnitOf(int index) => index == size - 1 ? double.RadiansToDegrees(1.0) : 1.0;
    }

    /// <summary>Part, line, sample and half of the cell.</summary>
    public static string TextOf(FacetId facet) =>
        Invariant($"{facet.Part} {facet.Line} {facet.Sample} {(facet.Half == FacetHalf.SouthWest ? "SW" : "NE")}");

    /// <summary>A number as text; empty for none.</summary>
    public static string TextOf(double? value) => value?.ToString("R", CultureInfo.InvariantCulture) ?? string.Empty;
}

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
            ("hiddenBy", view.HiddenBy is { } facet ? CraterFields.TextOf(facet) : string.Empty),
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
}
