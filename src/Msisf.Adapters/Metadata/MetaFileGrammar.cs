using System.Text.RegularExpressions;

namespace Msisf.Adapters.Metadata;

/// <summary>The grammar of meta files, as each of them has it in its DOCTYPE: lib/MSISRendering.dtd without its comments.</summary>
internal static partial class MetaFileGrammar
{
    private static readonly Lazy<string> Plain = new(() => Loaded!.Value[..Loaded.Value.IndexOf(NavigationStart, StringComparison.Ordinal)]
        .Replace(NavigationOfRoot, string.Empty, StringComparison.Ordinal));

    private static readonly Lazy<string> Loaded = new(() =>
    {
        using Stream stream = typeof(MetaFileGrammar).Assembly.GetManifestResourceStream("MSISRendering.dtd")!;
        using StreamReader reader = new(stream);
        return Comments().Replace(reader.ReadToEnd(), string.Empty).Trim();
    });

    /// <summary>The first declaration of what only files with truth for navigation have; those behind it are for them too.</summary>
    private const string NavigationStart = "\n<!ELEMENT CraterInformation";

    /// <summary>Those elements where they stand in the root.</summary>
    private const string NavigationOfRoot = ",CraterInformation?,LandmarkInformation?";

    /// <summary>The declarations of a file without truth for navigation: lines that end with LF, without the last one's end.</summary>
    public static string Text => Plain.Value;

    /// <summary>All declarations.</summary>
    public static string TextWithNavigation => Loaded.Value;

    [GeneratedRegex(@"^[ \t]*<!--.*?-->[ \t]*\n|^[ \t]*\n", RegexOptions.Singleline | RegexOptions.Multiline)]
    private static partial Regex Comments();
}
