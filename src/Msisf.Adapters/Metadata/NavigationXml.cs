using System.Text;
using Msisf.Core.Navigation;

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

            AppendAttribute(text, "covariance", view.Covariance is { } covariance
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
