using System.Text;
using Msisf.Core.Camera;
using Msisf.Core.Sky;
using Msisf.Core.Surface;

namespace Msisf.Adapters.Metadata;

/// <summary>The elements of a meta file that hold what its image shows of the sky.</summary>
internal static class SkyXml
{
    /// <summary>The elements of planets, the Earth and the Sun, each line with its end.</summary>
    public static string Elements(BodiesOfFrame bodies)
    {
        StringBuilder text = new("  <SkyBodyInformation>\n");
        foreach (BodyView view in bodies.Views)
        {
            text.Append("    <SkyBody name=\"").Append(view.Place.Body.Name).Append('"');
            AppendFields(text, BodyFields.Of(view));
        }

        return text.Append("  </SkyBodyInformation>\n").ToString();
    }

    /// <summary>The elements of stars, each line with its end.</summary>
    public static string Elements(StarsOfFrame stars)
    {
        StringBuilder text = new("  <StarInformation>\n");
        foreach (StarView view in stars.Views)
        {
            text.Append("    <Star id=\"").Append(XmlText.EscapeAttribute(view.Star.Identity)).Append('"');
            AppendFields(text, StarFields.Of(view));
        }

        return text.Append("  </StarInformation>\n").ToString();
    }

    private static void AppendFields(StringBuilder text, IEnumerable<(string Name, string Value)> fields)
    {
        foreach ((string name, string value) in fields.Where(pair => pair.Value.Length > 0))
        {
            text.Append(' ').Append(name).Append("=\"").Append(value).Append('"');
        }

        text.Append(" />\n");
    }
}

/// <summary>The values of a planet, the Earth or the Sun in an image, by their names in CSV; degrees, m and px, round-trip.</summary>
internal static class BodyFields
{
    private static readonly BodyPlace NoPlace = new(SkyBody.Sun, Vector3D.UnitX, 1e12, default, 0.0, 0.0);

    /// <summary>The names, in their order.</summary>
    public static IEnumerable<string> Names => Of(new BodyView(NoPlace, 0.0, 0.0, 0.0, 0.0)).Select(pair => pair.Name);

    /// <summary>The values; empty where one is not defined.</summary>
    public static IEnumerable<(string Name, string Value)> Of(BodyView view) =>
    [
        ("h", CraterFields.TextOf(view.X)),
        ("v", CraterFields.TextOf(view.Y)),
        ("radius", CraterFields.TextOf(view.RadiusPixels)),
        ("angularRadius", CraterFields.TextOf(double.RadiansToDegrees(view.Place.AngularRadius))),
        ("distance", CraterFields.TextOf(view.Place.Distance)),
        ("phase", CraterFields.TextOf(double.RadiansToDegrees(view.Place.Phase))),
        ("magnitude", CraterFields.TextOf(view.Place.Magnitude)),
        ("electrons", CraterFields.TextOf(view.Electrons)),
        ("visible", CraterFields.TextOf(view.Visible)),
    ];
}

/// <summary>The values of a star in an image, by their names in CSV; degrees and px, round-trip.</summary>
internal static class StarFields
{
    /// <summary>The names, in their order.</summary>
    public static IEnumerable<string> Names =>
        Of(new StarView(new Star("1", Vector3D.UnitX, default, 0.0, 0.0, 0.0, null), 0.0, 0.0, Vector3D.UnitX, null) { ByTurn = default })
            .Select(value => value.Name);

    /// <summary>The values; empty where one is not defined.</summary>
    public static IEnumerable<(string Name, string Value)> Of(StarView view)
    {
        double rightAscension = double.RadiansToDegrees(Trigonometry.Atan2(view.ApparentJ2000.Y, view.ApparentJ2000.X));
        double declination = double.RadiansToDegrees(
            Trigonometry.Atan2(view.ApparentJ2000.Z, double.Hypot(view.ApparentJ2000.X, view.ApparentJ2000.Y)));
        return
        [
            ("h", Text(view.X)),
            ("v", Text(view.Y)),
            ("magnitude", Text(view.Star.Magnitude)),
            ("colour", Text(view.Star.Colour)),
            ("electrons", Text(view.Electrons)),
            ("visible", view.IsVisible ? "yes" : "no"),
            ("hiddenBy", view.HiddenBy is { } facet ? CraterFields.TextOf(facet) : view.Behind?.Name ?? string.Empty),
            ("rightAscension", Text(rightAscension < 0.0 ? rightAscension + 360.0 : rightAscension)),
            ("declination", Text(declination)),
            ("start", Text(view.Streak?.Start)),
            ("end", Text(view.Streak?.End)),
            ("hByTurn", Text(view.ByTurn.X)),
            ("vByTurn", Text(view.ByTurn.Y)),
        ];
    }

    private static string Text(double? value) => CraterFields.TextOf(value);

    private static string Text(RenderingPoint? point) => point is { } place ? $"{Text(place.X)} {Text(place.Y)}" : string.Empty;

    private static string Text(Vector3D vector) => $"{Text(vector.X)} {Text(vector.Y)} {Text(vector.Z)}";
}
