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

    /// <summary>Lines that end with LF, without the last one's end.</summary>
    public static string Text => Loaded.Value;

    [GeneratedRegex(@"^[ \t]*<!--.*?-->[ \t]*\n|^[ \t]*\n", RegexOptions.Singleline | RegexOptions.Multiline)]
    private static partial Regex Comments();
}
