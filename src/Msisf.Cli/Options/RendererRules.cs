using System.CommandLine;
using Msisf.Core.Errors;
using Msisf.Core.Render;

namespace Msisf.Cli.Options;

/// <summary>Which argument has a meaning with which renderer.</summary>
internal static class RendererRules
{
    /// <summary>Refuses what the chosen renderer could only ignore.</summary>
    /// <exception cref="UsageException">An argument of the other renderer, or one without the one it belongs to.</exception>
    public static void Check(RendererKind renderer, NativeOptions native, SourceOptions source, RunOptions run, Func<Option, bool> isGiven)
    {
        if (renderer == RendererKind.PovRay)
        {
            Refuse(WithoutMeaning(renderer, native, source, run), isGiven, "is for --renderer native only. Add that, or leave it out.");
            return;
        }

        Refuse(
            WithoutMeaning(renderer, native, source, run),
            isGiven,
            "has no meaning with --renderer native, which needs neither POV-Ray nor patterns. Leave it out, or choose --renderer povray.");
        if (isGiven(native.LayersFormat) && !isGiven(native.Layers))
        {
            throw new UsageException("--layers-format is given, but no --layers. Name the layers, or leave it out.");
        }
    }

    /// <summary>The options that a renderer could only ignore.</summary>
    public static IEnumerable<Option> WithoutMeaning(RendererKind renderer, NativeOptions native, SourceOptions source, RunOptions run) =>
        renderer == RendererKind.PovRay
            ? native.OfNativeOnly
            : [run.PovPath, run.PovOptions, run.Timeout, run.ListPatterns, source.PatternRepository];

    private static void Refuse(IEnumerable<Option> options, Func<Option, bool> isGiven, string why)
    {
        if (options.FirstOrDefault(isGiven) is Option wrong)
        {
            throw new UsageException($"{wrong.Name} {why}");
        }
    }
}
