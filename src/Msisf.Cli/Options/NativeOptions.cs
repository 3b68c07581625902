using System.CommandLine;

namespace Msisf.Cli.Options;

/// <summary>Which program draws, and what only the program's own renderer can do.</summary>
internal sealed class NativeOptions
{
    public Option<string?> Renderer { get; } = OptionFactory.Value(
        "--renderer", [], "povray|native",
        "Who draws: POV-Ray from surface patterns (default), or this program itself straight from the elevation model");

    public Option<string?> Reflectance { get; } = OptionFactory.Value(
        "--reflectance", [], "LAW",
        "Native: lambert (default), lommel-seeliger, lunar-lambert or hapke; parameters after a colon: hapke:w=0.3,b0=1.2");

    public Option<string?> Albedo { get; } = OptionFactory.Value(
        "--albedo", [], "A", "Native: Albedo of the law, 0 to 1 (default 0.64, as in POV-Ray's scene)");

    public Option<string?> Sun { get; } = OptionFactory.Value(
        "--sun", [], "point|disc", "Native: The Sun as a point (default), or as its disc with penumbras");

    public Option<string?> Samples { get; } = OptionFactory.Value(
        "--samples", [], "N", "Native: Samples a pixel on a regular grid: 1 (default), 4, 9, 16, ... 256");

    public Option<string?> Shading { get; } = OptionFactory.Value(
        "--shading", [], "facet|smooth", "Native: Normals of the facets (default), or between those of the samples around");

    public Option<string?> Exposure { get; } = OptionFactory.Value(
        "--exposure", [], "X", "Native: Linear grey of a radiance factor of 1, where 1 is white (default 1)");

    public Option<string?> Transfer { get; } = OptionFactory.Value(
        "--transfer", [], "srgb|linear",
        "Native: Grey levels along sRGB's curve (default, as POV-Ray's), or in proportion to the radiance");

    public Option<string?> BitDepth { get; } = OptionFactory.Value(
        "--bit-depth", [], "8|16", "Native: Bits of the image's grey levels (default 8)");

    public Option<string?> Layers { get; } = OptionFactory.Value(
        "--layers", [], "LIST|all",
        "Native: Ground truth of every pixel, as names separated by commas: depth,position,incidence,mask, ...");

    public Option<string?> LayersFormat { get; } = OptionFactory.Value(
        "--layers-format", [], "fits|npy", "Native: Format of the layers (default fits)");

    /// <summary>All but the one that chooses the renderer.</summary>
    public IEnumerable<Option> OfNativeOnly =>
        [Reflectance, Albedo, Sun, Samples, Shading, Exposure, Transfer, BitDepth, Layers, LayersFormat];

    public IEnumerable<Option> All => [Renderer, .. OfNativeOnly];
}
