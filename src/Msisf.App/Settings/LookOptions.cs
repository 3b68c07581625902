using Msisf.App.Settings.Specs;
using Msisf.Core.Render;

namespace Msisf.App.Settings;

/// <summary>The option that names a look: a set of values for options that are not given.</summary>
internal static class LookOptions
{
    private static readonly NamedLook Thesis = new("thesis", RendererKind.PovRay,
    [
        new(SurfaceOptions.LevelOfDetail, "off", SurfaceOptions.LevelOfDetailError), new(OutputOptions.Surface, "sphere"),
        new(LightOptions.Aberration, "none", LightOptions.IgnoreSun),
        .. Flat, new(NativeOptions.Reflectance, "lambert"),
    ]);

    private static readonly NamedLook Truth = new("truth", RendererKind.Native, [new(OutputOptions.Surface, "terrain"), .. Flat]);

    private static readonly NamedLook Photo = new("photo", RendererKind.Native,
    [
        new(NativeOptions.Samples, SamplesReader.Auto), new(NativeOptions.Shading, "smooth"), new(NativeOptions.Sun, "disc"),
        new(NativeOptions.Reflectance, "moon", NativeOptions.Albedo),
        new(NativeOptions.Refine, "1", SurfaceOptions.LevelOfDetailError, SurfaceOptions.Body),
        new(NativeOptions.Exposure, NativeOptions.Automatic),
    ]);

    public static ChoiceSpec<Look> Look { get; } = new(
        "--look", DecidesBytes.ByOthers,
        [new Choice("thesis", Settings.Look.Thesis), new Choice("truth", Settings.Look.Truth), new Choice("photo", Settings.Look.Photo)],
        "Set several options at once; those that are given stay. thesis: what the thesis draws (POV-Ray, the whole model); truth: native, "
            + "flat facets, one sample a pixel, for comparisons; photo: what a camera would take (native, samples auto, smooth ground, "
            + "the Sun's disc, the map of the reflectance, invented detail, exposure auto)")
    {
        DefaultNote = "none",
    };

    /// <summary>The options that a look can set.</summary>
    public static IEnumerable<OptionSpec> Options =>
        new[] { Thesis, Truth, Photo }.SelectMany(look => look.Values).Select(value => value.Option)
            .Append(RendererOptions.Renderer).Distinct();

    /// <summary>The word of the renderer that draws a look, if no other is given; null without a look.</summary>
    /// <param name="look">The look's name.</param>
    public static string? RendererOf(string? look) =>
        new[] { Thesis, Truth, Photo }.FirstOrDefault(named => named.Name == look) is { } found
            ? RendererOptions.Renderer.WordOf(found.Renderer)
            : null;

    private static NamedValue[] Flat =>
    [
        new(NativeOptions.Samples, "1"), new(NativeOptions.Shading, "facet"), new(NativeOptions.Sun, "point"),
    ];

    /// <summary>
    /// The options with the look's values for those that are not given, in place of the look. Options that exclude one of its values, and
    /// the other renderer's, are left out.
    /// </summary>
    /// <exception cref="UsageException">There is no such look, or POV-Ray is asked for one that it can't draw.</exception>
    public static OptionValues Behind(OptionValues values)
    {
        if (Look.ReadIfGiven(values) is not { } look)
        {
            return values;
        }

        if (values.HasLook)
        {
            return values.Replacing([Look], []); // a file's, behind that of the command line
        }

        NamedLook named = look switch
        {
            Settings.Look.Thesis => Thesis,
            Settings.Look.Truth => Truth,
            _ => Photo,
        };
        string source = $"{Look.Name} {named.Name}";
        RendererKind renderer = RendererOptions.Renderer.ReadIfGiven(values) ?? named.Renderer;
        string word = RendererOptions.Renderer.WordOf(renderer);
        if (named.Renderer == RendererKind.Native && renderer != RendererKind.Native)
        {
            throw new UsageException(
                $"{source} is drawn by the native renderer. Leave {RendererOptions.Renderer.Name} {word} out, or give {Look.Name} "
                    + $"{Thesis.Name}.").About(Look, RendererOptions.Renderer);
        }

        IReadOnlyList<OptionSpec> foreign = RendererOptions.WithoutMeaning(renderer);
        string? place = values.PlaceOf(Look);
        return values.Replacing(
            [Look],
            named.Values.Prepend(new NamedValue(RendererOptions.Renderer, word))
                .Where(value => values.Words(value.Option) is null && !foreign.Contains(value.Option)
                    && value.Excluded.All(other => values.Words(other) is null))
                .Select(value => KeyValuePair.Create(value.Option.Name, new OptionValue([value.Text], place) { Look = source })));
    }

    private sealed record NamedLook(string Name, RendererKind Renderer, IReadOnlyList<NamedValue> Values);

    /// <summary>A value of a look.</summary>
    /// <param name="Excluded">Options beside which the value is left out.</param>
    private sealed record NamedValue(OptionSpec Option, string Text, params OptionSpec[] Excluded);
}

/// <summary>A named set of options.</summary>
internal enum Look
{
    Thesis,
    Truth,
    Photo,
}
