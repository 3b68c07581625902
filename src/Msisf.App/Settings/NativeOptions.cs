using Msisf.Adapters.Layers;
using Msisf.App.Settings.Specs;
using Msisf.Core.Layers;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;

namespace Msisf.App.Settings;

/// <summary>The options of the program's own renderer.</summary>
internal static class NativeOptions
{
    /// <summary>Exposure for laws that have the Moon's own brightness: I/F of bright soil, 0.2, is white.</summary>
    public const double ExposureOfMoon = 5.0;

    /// <summary>Exposure for other laws: I/F = 1 is white.</summary>
    public const double ExposureOfOtherLaws = 1.0;

    public static TextSpec Samples { get; } = new(
        "--samples", DecidesBytes.As(frame => frame.Native is { } native ? SamplesReader.TextOf(native.Render) : null), "N|auto[:ERROR]",
        "Samples a pixel: a square number on a regular grid (1, 4, 9, 16, ... 256). With auto there are more only where brightness "
            + $"differs, for an rms error of ERROR levels of 255 ({NumberSpec.TextOf(AdaptiveSampling.DefaultError)} unless given)")
    {
        Default = "1",
        Words = [SamplesReader.Auto],
    };

    public static ChoiceSpec<NormalModel> Shading { get; } = new(
        "--shading", DecidesBytes.As(frame => frame.Native?.Render.Normals),
        [new Choice("facet", NormalModel.Facet), new Choice("smooth", NormalModel.Smooth)],
        "Normals of the facets, or interpolated between those of the samples")
    {
        Default = NormalModel.Facet,
    };

    public static ChoiceSpec<SunModel> Sun { get; } = new(
        "--sun", DecidesBytes.As(frame => frame.Native?.Render.Sun),
        [new Choice("point", SunModel.Point), new Choice("disc", SunModel.Disc)],
        "The Sun as a point, or as its disc with penumbras")
    {
        Default = SunModel.Point,
    };

    public static TextSpec Reflectance { get; } = new(
        "--reflectance", DecidesBytes.As(frame => frame.Native?.ReflectanceText), "LAW",
        $"Law of reflectance: {string.Join(", ", ReflectanceFactory.Laws)}; parameters after a colon: hapke:w=0.3,b0=1.2")
    {
        Default = ReflectanceFactory.DefaultLaw,
        Words = ReflectanceFactory.Laws,
    };

    public static PathSpec HapkeMap { get; } = new(
        "--hapke-map", DecidesBytes.As(frame => Path.GetFileName(frame.Native?.HapkeMap)),
        PathKind.File, "Parameters of the law moon by place: LROC's WAC_HAPKEPARAMMAP_643NM.IMG")
    {
        DefaultNote = "the same everywhere",
    };

    public static NumberSpec Albedo { get; } = new(
        "--albedo", DecidesBytes.As(frame => frame.Native?.Albedo), "A", "Albedo of a law that is not the Moon's own")
    {
        Limits = new NumberRange(0.0, 1.0),
        DefaultNote = NumberSpec.TextOf(ReflectanceFactory.DefaultAlbedo),
    };

    /// <summary>Word that asks for the exposure, or the exposure time, to be found.</summary>
    public const string Automatic = "auto";

    public static TextSpec Exposure { get; } = new(
        "--exposure", DecidesBytes.As(frame => frame.Native?.Grey.Exposure), $"X|{Automatic}",
        "Linear grey of a radiance factor of 1, where 1 is white; auto: so bright that 99.5 % of the lit pixels stay below white, and half "
            + "of them at level 159 or below, found from small images of 32 frames spread over the whole run")
    {
        Words = [Automatic],
        DefaultNote = Invariant($"{ExposureOfMoon} for moon, nac and hapke with w, otherwise {ExposureOfOtherLaws}"),
    };

    public static ChoiceSpec<GreyTransfer> Transfer { get; } = new(
        "--transfer", DecidesBytes.As(frame => frame.Native?.Grey.Transfer),
        [new Choice("srgb", GreyTransfer.Srgb), new Choice("linear", GreyTransfer.Linear)],
        "Grey levels along sRGB's curve, as POV-Ray's, or in proportion to the radiance")
    {
        Default = GreyTransfer.Srgb,
    };

    public static ChoiceSpec<int> BitDepth { get; } = new(
        "--bit-depth", DecidesBytes.As(frame => frame.Native?.BitDepth),
        [new Choice("8", 8), new Choice("16", 16)], "Bits of the image's grey levels")
    {
        Default = 8,
    };

    public static TextSpec ExposureTime { get; } = new(
        "--exposure-time", DecidesBytes.As(frame => frame.Native?.ExposureTime), $"SECONDS|{Automatic}",
        "Exposure time of a camera file with a detector; auto: so long that 99.5 % of the lit pixels stay below full well and highest DN, "
            + "found from 32 images spread over the whole run")
    {
        Words = [Automatic],
        DefaultNote = "the camera file's",
    };

    public static TextSpec NoiseSeed { get; } = new(
        "--noise-seed", DecidesBytes.ByStates, "N[:STEP]",
        "Noise of a camera file's detector from this number and the image's step, whatever its state; STEP is that of the first image")
    {
        DefaultNote = "from the detector's seed and the state",
    };

    public static NumberSpec ExposureFactor { get; } = new(
        "--exposure-factor", DecidesBytes.ByStatesOfRun, "X",
        "Multiplies --exposure, or the exposure time of a camera file with a detector; a batch file can have a column exposure_factor")
    {
        Limits = new NumberRange(SpacecraftState.LeastExposure, SpacecraftState.GreatestExposure),
        DefaultNote = "1",
    };

    /// <summary>Word for no invented detail, whatever a look has.</summary>
    public const string NoDetail = "none";

    public static TextSpec Refine { get; } = new(
        "--refine", DecidesBytes.As(frame => frame.Native?.Refine?.Seed), $"SEED|{NoDetail}",
        "Invents craters, roughness and boulders below the elevation model's resolution, from this number; real heights stay")
    {
        DefaultNote = NoDetail,
        Words = [NoDetail],
    };

    public static NumberSpec RefineCell { get; } = new(
        "--refine-cell", DecidesBytes.As(frame => frame.Native?.Refine?.Cell),
        "METRES", "Narrowest cells of invented detail; the next smaller power of two is taken")
    {
        Default = RefineSettings.DefaultCell,
        Limits = new NumberRange(RefineSettings.NarrowestCell, RefineSettings.WidestCell),
    };

    public static TextSpec Layers { get; } = new(
        "--layers", DecidesBytes.As(frame => frame.WithLayers?.Layers!.Layers.Select(layer => layer.Name)),
        "LIST|all", "Ground truth of every pixel, as names separated by commas: depth,position,incidence,mask, ...")
    {
        Separator = ",",
        Words = [LayerSet.AllText, .. LayerCatalogue.All.Select(layer => layer.Name)],
    };

    public static ChoiceSpec<LayerFormat> LayersFormat { get; } = new(
        "--layers-format", DecidesBytes.As(frame => frame.WithLayers?.LayersFormat),
        [.. LayerFormat.All.Select(format => new Choice(format.Word, format))],
        "Format of the layers: one file, or one a layer for NumPy, or for programs that read TIFF")
    {
        Default = LayerFormat.Fits,
    };

    public static ChoiceSpec<LayerPrecision> LayersPrecision { get; } = new(
        "--layers-precision", DecidesBytes.UnlessDefault(frame => frame.WithLayers?.LayersPrecision),
        [new Choice("double", LayerPrecision.Real64), new Choice("single", LayerPrecision.Real32)],
        "Precision of the layers' real numbers; with single, latitude, longitude and position stay double")
    {
        Default = LayerPrecision.Real64,
    };

    public static ChoiceSpec<LayerCompression> LayersCompression { get; } = new(
        "--layers-compression", DecidesBytes.UnlessDefault(frame => frame.WithLayers?.LayersCompression),
        [new Choice("none", LayerCompression.None), new Choice("gzip", LayerCompression.Gzip)],
        "Lossless compression of the layers in FITS")
    {
        Default = LayerCompression.None,
    };

    public static IReadOnlyList<OptionSpec> OfLayers => [LayersFormat, LayersPrecision, LayersCompression];

    public static OptionGroup Group { get; } = new(
        "Native renderer",
        [
            Samples, Shading, Sun, IndirectOptions.Bounces, IndirectOptions.Error,
            Reflectance, HapkeMap, Albedo, Exposure, Transfer, BitDepth, ExposureTime, ExposureFactor, NoiseSeed,
            Refine, RefineCell, Layers, LayersFormat, LayersPrecision, LayersCompression,
        ])
    {
        Note = "Only with --renderer native.",
    };
}
