using System.Text.RegularExpressions;

namespace Msisf.Adapters.Metadata;

/// <summary>The grammar of meta files, as each of them has it in its DOCTYPE: lib/MSISRendering.dtd without its comments.</summary>
internal static partial class MetaFileGrammar
{
    private static readonly Lazy<string> Loaded = new(() =>
    {
        using Stream stream = typeof(MetaFileGrammar).Assembly.GetManifestResourceStream("MSISRendering.dtd")!;
        using StreamReader reader = new(stream);
        return Comments().Replace(reader.ReadToEnd(), string.Empty).Trim();
    });

    private static readonly Lazy<string> Plain = new(() => Make(hasNavigation: false, isScan: false));

    /// <summary>The first declaration of what only some files have, and how their parent names it.</summary>
    private static readonly (string Start, string InParent) Navigation =
        ("\n<!ELEMENT CraterInformation", ",CraterInformation?,LandmarkInformation?");

    private static readonly (string Start, string InParent) Scan = ("\n<!ELEMENT Scan", ",Scan?");

    /// <summary>The declarations of a file: lines that end with LF, without the last one's end.</summary>
    /// <param name="hasNavigation">Whether it has truth for navigation.</param>
    /// <param name="isScan">Whether its image is scanned.</param>
    public static string Text(bool hasNavigation, bool isScan) => hasNavigation || isScan ? Make(hasNavigation, isScan) : Plain.Value;

    private static string Make(bool hasNavigation, bool isScan)
    {
        string all = Loaded.Value;
        int navigation = all.IndexOf(Navigation.Start, StringComparison.Ordinal);
        int scan = all.IndexOf(Scan.Start, StringComparison.Ordinal);
        string text = all[..navigation] + (hasNavigation ? all[navigation..scan] : string.Empty) + (isScan ? all[scan..] : string.Empty);
        text = hasNavigation ? text : text.Replace(Navigation.InParent, string.Empty, StringComparison.Ordinal);
        return isScan ? text : text.Replace(Scan.InParent, string.Empty, StringComparison.Ordinal);
    }

    [GeneratedRegex(@"^[ \t]*<!--.*?-->[ \t]*\n|^[ \t]*\n", RegexOptions.Singleline | RegexOptions.Multiline)]
    private static partial Regex Comments();
}
