using Msisf.Adapters.Fetching;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary><c>msis fetch</c> and its options.</summary>
internal static class FetchOptions
{
    public static WholeNumberSpec Resolution { get; } = SurfaceOptions.Resolution with
    {
        Help = $"Resolution, px/deg, one of {string.Join(", ", LdemProducts.Resolutions)}: "
            + "2 MB, 33 MB, 531 MB, 2.1 GB, 8.5 GB, 34 GB or 136 GB",
        DefaultNote = null,
    };

    public static FlagSpec Floats { get; } = new(
        "--float", DecidesBytes.OfNoFrame, "Samples as 32-bit floats, twice the size, in place of 16-bit steps of 0.5 m");

    public static ChoiceSpec<int> Size { get; } = new(
        "--map-size", DecidesBytes.OfNoFrame, [("2k", 2), ("4k", 4), ("8k", 8), ("16k", 16)],
        "Pixels along the equator, in thousands")
    {
        Default = 8,
    };

    public static TextSpec From { get; } = new(
        "--from", DecidesBytes.OfNoFrame, "DIR|URL", "Another place of the files, which is asked first: a folder, or its address");

    public static PathSpec To { get; } = new("--to", OptionRole.HowItRuns, PathKind.Folder, "Where to put the files")
    {
        DefaultNote = "where msis looks for them: input/ldem, input/albedo, input/stars and kernels of the installation, or below "
            + "~/.local/share/msisf",
    };

    public static CommandSpec Ldem { get; } = new("ldem", "Get an elevation model of the whole Moon (LRO LOLA).")
    {
        Details = "Files that are there and whole are left alone. From 256 px/deg on a model has several files.",
        Examples = [("A model of 64 px/deg, 531 MB:", "msis fetch ldem --res 64")],
        MakeGroups = () => [new OptionGroup("The model", [Resolution, Floats, From, To]), OnlyHelp],
    };

    public static CommandSpec Albedo { get; } = new("albedo", "Get a map of the Moon's reflectance (LROC WAC, by NASA's SVS 4720).")
    {
        Details = "The map is a TIFF image, which GDAL reads.",
        Examples = [("The largest one:", "msis fetch albedo --map-size 16k")],
        MakeGroups = () => [new OptionGroup("The map", [Size, From, To]), OnlyHelp],
    };

    public static CommandSpec Stars { get; } = new("stars", "Get the stars of Hipparcos (CDS I/239, 53 MB).")
    {
        Details = "Prints the path that --stars takes. The stars to V 6.0 come with msis, for --stars without a file.",
        Examples = [("Into the folder in which --stars is given:", "msis fetch stars --to .")],
        MakeGroups = () => [new OptionGroup("The catalogue", [From, To]), OnlyHelp],
    };

    public static CommandSpec Kernels { get; } = new("kernels", "Get the SPICE kernels of msis, and those of other bodies.")
    {
        Details = "Kernels that are there and whole are left alone; damaged ones are replaced. pck00011.tpc has the orientations of all "
            + "bodies of --body: give its path to --kernels.",
        Examples = [("Damaged kernels anew:", "msis fetch kernels")],
        MakeGroups = () => [new OptionGroup("The kernels", [From, To]), OnlyHelp],
    };

    public static CommandSpec Command { get; } = new("fetch", "Get elevation models, maps, stars and kernels.")
    {
        Details = "Files are downloaded by curl. A download that was cut off goes on when the command is repeated.",
        MakeGroups = () => [OnlyHelp],
        Commands = [Ldem, Albedo, Stars, Kernels],
    };

    /// <summary>Reads the resolution of a product of NASA.</summary>
    /// <exception cref="UsageException">NASA has no model of it.</exception>
    public static int ReadResolution(OptionValues values) => Resolution.Read(values) is var read && LdemProducts.Resolutions.Contains(read)
        ? read
        : throw Resolution.Wrong($"is '{read}'; NASA has models of {string.Join(", ", LdemProducts.Resolutions)} px/deg.");

    private static OptionGroup OnlyHelp => new("General", [RunOptions.Help]);
}
