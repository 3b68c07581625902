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

    private static readonly Lazy<string> Plain = new(() => Make([]));

    /// <summary>The first declaration of what only some files have, and how their parent names it, in the order of the declarations:
    /// truth for navigation, scanned images, cameras of a rig, the sky.</summary>
    private static readonly (string Start, string InParent)[] Parts =
    [
        ("\n<!ELEMENT CraterInformation", ",CraterInformation?,LandmarkInformation?"), ("\n<!ELEMENT Scan", ",Scan?"),
        ("\n<!ELEMENT Rig", ",Rig?"), ("\n<!ELEMENT StarInformation", ",StarInformation?,SkyBodyInformation?"),
    ];

    /// <summary>The declarations of a file: lines that end with LF, without the last one's end.</summary>
    /// <param name="hasNavigation">Whether it has truth for navigation.</param>
    /// <param name="isScan">Whether its image is scanned.</param>
    /// <param name="isOfRig">Whether a camera of a rig took its image.</param>
    /// <param name="hasSky">Whether it lists stars, or bodies of the sky.</param>
    public static string Text(bool hasNavigation, bool isScan, bool isOfRig, bool hasSky) =>
        hasNavigation || isScan || isOfRig || hasSky ? Make([hasNavigation, isScan, isOfRig, hasSky]) : Plain.Value;

    private static string Make(bool[] has)
    {
        string all = Loaded.Value;
        int[] starts = [.. Parts.Select(part => all.IndexOf(part.Start, StringComparison.Ordinal)), all.Length];
        string text = all[..starts[0]];
        for (int i = 0; i < Parts.Length; i++)
        {
            text = has.ElementAtOrDefault(i)
                ? text + all[starts[i]..starts[i + 1]]
                : text.Replace(Parts[i].InParent, string.Empty, StringComparison.Ordinal);
        }

        return text;
    }

    [GeneratedRegex(@"^[ \t]*<!--.*?-->[ \t]*\n|^[ \t]*\n", RegexOptions.Singleline | RegexOptions.Multiline)]
    private static partial Regex Comments();
}
