using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of <c>msis twin</c>.</summary>
internal static class TwinOptions
{
    /// <summary>Bands at most: M3 has 256.</summary>
    private const int MostBands = 10_000;

    public static WholeNumberSpec Band { get; } = new(
        "--image-band", OptionRole.HowItRuns, "K", 1, MostBands, "Band of the real image, from 1")
    {
        IsOfOneCall = true,
        DefaultNote = "the one nearest to --band by the label's wavelengths, otherwise the first",
    };

    public static TextSpec Lines { get; } = new(
        "--image-lines", OptionRole.HowItRuns, "FIRST-LAST", "Only these lines of the real image, from 1; of line-scan cameras")
    {
        IsOfOneCall = true,
        DefaultNote = "all",
    };

    public static CommandSpec Command { get; } = new(
        "twin", "Draw the twin of a real image from its label, and compare the two.")
    {
        Details =
            "Takes an ISIS cube with SPICE tables, or a PDS3 or PDS4 label with kernels (--spk, --ck, --kernels). Writes the image, a page "
                + "(HTML) and numbers (JSON). docs/twin.md says for which cameras, and what the numbers mean.",
        MakeArgument = () => new ArgumentSpec("LABEL", "An ISIS cube or its label, a PDS3 product or its label, or a PDS4 label"),
        Examples =
        [
            ("A cube of LROC's WAC after spiceinit:", "msis twin M1181493219CE.vis.odd.cub --output-dir twin"),
            (
                "A NAC image from PDS by kernels:",
                "msis twin M103595705LE.IMG --spk lro.bsp --ck moc42.bc --ck lrolc.bc --kernels lro.tsc --kernels lro.tf "
                    + "--kernels lroc.ti"),
        ],
        MakeGroups = () =>
        [
            new OptionGroup("Real image", [Band, Lines, ImageOptions.Camera, ScanOptions.Period, MissionOptions.InstrumentAxes]),
            new OptionGroup("Kernels", [
                MissionOptions.Spk, MissionOptions.Ck, LightOptions.Kernels, .. OfSpk, LightOptions.Ephemeris, LightOptions.Aberration]),
            SurfaceOptions.Group, AlbedoOptions.Group,
            new OptionGroup("Renderer", [
                NativeOptions.Reflectance, NativeOptions.HapkeMap, NativeOptions.Albedo, NativeOptions.Samples, NativeOptions.Shading,
                NativeOptions.Sun, NativeOptions.Exposure, NativeOptions.Refine, NativeOptions.RefineCell]),
            SkyOptions.Group with { Note = null },
            new OptionGroup("Output", [OutputOptions.Folder, OutputOptions.Name]),
            new OptionGroup("General", [RunOptions.Batch, RunOptions.Config, RunOptions.Help]),
        ],
    };

    /// <summary>Options that need a trajectory.</summary>
    private static OptionSpec[] OfSpk => [MissionOptions.Spacecraft, MissionOptions.Instrument, MissionOptions.OfGround];

    /// <summary>Whether kernels say where the camera was, and not the tables of a cube.</summary>
    /// <exception cref="UsageException">An option of kernels is given without any.</exception>
    public static bool ReadHasKernels(OptionValues values) =>
        values.Words(MissionOptions.Spk) is not null && values.Words(MissionOptions.Ck) is not null
        || (((OptionSpec[])[MissionOptions.Spk, MissionOptions.Ck, .. OfSpk]).FirstOrDefault(option => values.Words(option) is not null)
            is { } alone
            ? throw alone.Wrong(
                $"needs {MissionOptions.Spk.Name} and {MissionOptions.Ck.Name}: where the camera was and how it pointed. Add them, or "
                    + "leave it out.")
            : false);

    /// <summary>Reads the lines of the product; null for all.</summary>
    public static (int First, int Last)? ReadLines(OptionValues values)
    {
        if (Lines.ReadIfGiven(values) is not { } text)
        {
            return null;
        }

        string[] parts = text.Split('-');
        return parts.Length == 2 && TryParse(parts[0], out int first) && TryParse(parts[1], out int last) && first >= 1 && last >= first
            ? (first, last)
            : throw Lines.Wrong($"is '{text}'; two line numbers such as 1001-1400 are needed.");
    }

    private static bool TryParse(string text, out int number) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);
}
