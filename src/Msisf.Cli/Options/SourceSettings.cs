using System.CommandLine;

namespace Msisf.Cli.Options;

/// <summary>What several commands read of the source options.</summary>
internal static class SourceSettings
{
    /// <summary>The thesis's folder of patterns, below the working directory.</summary>
    public const string DefaultRepository = "pattern-repository";

    /// <summary>px/deg: the finest product that NASA offers (LDEM_1024).</summary>
    public const int FinestResolution = 1024;

    /// <summary>Resolution of the elevation model, px/deg.</summary>
    public static int Resolution(ParseResult line, SourceOptions source) =>
        line.GetValue(source.Resolution) is string text
            ? OptionText.WholeNumber(source.Resolution, text, 1, FinestResolution)
            : 4;
}
