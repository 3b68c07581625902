using Msisf.Adapters.RealImages;

namespace Msisf.App.Twins;

/// <summary>A camera whose labels are known: which preset it has, how it is mounted, and when it took what.</summary>
/// <param name="Name">For people.</param>
/// <param name="Is">Whether a label is of it.</param>
/// <param name="Preset">The preset, from the label and the wavelength of the band (nm).</param>
/// <param name="Axes">How the image lies in the frame of the instrument.</param>
/// <param name="Instrument">NAIF's number of the instrument.</param>
/// <param name="Times">When it took the first line, framelet or image, and the seconds from one to the next.</param>
/// <remarks>The camera models of USGS's ISIS: LroNarrowAngleCamera, LroWideAngleCamera, Chandrayaan1M3Camera, UvvisCamera,
/// KaguyaTcCamera.</remarks>
internal sealed record KnownCamera(
    string Name, Func<ImageLabel, bool> Is, Func<ImageLabel, double?, string> Preset, Func<ImageLabel, string> Axes,
    Func<ImageLabel, int> Instrument, Func<ImageLabel, TwinClock, TwinTimes> Times)
{
    private static readonly int[] WacBands = [415, 566, 604, 643, 689];

    /// <summary>NAIF's number of the spacecraft.</summary>
    public required int Spacecraft { get; init; }

    /// <summary>Samples that make one of the product on board.</summary>
    public Func<ImageLabel, int> Summing { get; init; } = static _ => 1;

    /// <summary>The detector's sample with which the product begins, from 0.</summary>
    public Func<ImageLabel, int> FirstSample { get; init; } = static _ => 0;

    /// <summary>What of its products can't be drawn; null for nothing.</summary>
    public Func<ImageLabel, string?> Problem { get; init; } = static _ => null;

    /// <summary>Whether the lens is the one that a cube's own keywords state.</summary>
    public bool HasOwnLens { get; init; } = true;

    public static IReadOnlyList<KnownCamera> All { get; } =
    [
        new(
            "LROC NAC", label => IsNac(label),
            (label, _) => IsLeft(label) ? "lroc-nac-l" : "lroc-nac-r",
            label => IsLeft(label) ? "+y,-x" : "-y,+x",
            label => IsLeft(label) ? -85600 : -85610, NacTimes)
        {
            Spacecraft = -85,
            Summing = label => (int)(label.Number("SPATIALSUMMING") ?? label.Number("CROSSTRACKSUMMING") ?? 1.0),
            FirstSample = label => (int)(label.Number("SAMPLEFIRSTPIXEL") ?? 0.0),
        },
        new(
            "LROC WAC (cubes, visible bands in colour mode)", label => label.Text("INSTRUMENTID") == "WAC-VIS",
            (label, nanometres) => Array.IndexOf(WacBands, (int)(nanometres ?? 0.0)) is >= 0 and var band
                ? Invariant($"lroc-wac-{WacBands[band]}")
                : throw new BadInputException(
                    $"{label.Path}: a band of {nanometres} nm; the WAC's visible ones are {string.Join(", ", WacBands)}."),
            _ => "+y,-x", _ => -85621, WacTimes)
        {
            HasOwnLens = false, // each of its bands has a lens of its own
            Spacecraft = -85,
            Problem = label => label.Text("INSTRUMENTMODEID") is not ("COLOR" or "VIS") and var mode
                ? $"its mode is {mode}; COLOR and VIS are known"
                : label.Number("COLOROFFSET") is not (null or 0.0) ? "its bands are shifted against each other (ColorOffset)" : null,
        },
        new(
            "Chandrayaan-1 M3", label => label.Text("INSTRUMENTID") == "M3", (_, _) => "chandrayaan-m3", _ => "-y,+x", _ => -86520,
            (label, clock) => Lines(
                label, clock.OfCount("SPACECRAFTCLOCKSTARTCOUNT") ?? clock.OfUtc("STARTTIME"), "LINEEXPOSUREDURATION"))
        {
            Spacecraft = -86,
            Problem = label => label.Tables is null
                ? $"a {label.Kind} label does not say when its lines were taken: START_TIME is not that of line 1, and lines may be in "
                    + "reverse order of time. Make a cube of it with ISIS's chan1m32isis and spiceinit, and give that"
                : null,
            Summing = label => (int)(label.Number("SPATIALSUMMING") ?? 1.0),
        },
        new(
            "Clementine UVVIS",
            label => label.Text("INSTRUMENTID") == "UVVIS", (_, _) => "clementine-uvvis", _ => "+x,+y",
            label => (int)(label.Number("NAIFFRAMECODE") ?? -40021),
            (label, clock) => new TwinTimes(clock.OfUtc("STARTTIME") + (0.5 * (label.Seconds("EXPOSUREDURATION") ?? 0.0)), 0.0))
        {
            Spacecraft = -40,
        },
        new(
            "Kaguya TC1", label => label.Text("INSTRUMENTID") == "TC1", (_, _) => "kaguya-tc1", _ => "-y,+x", _ => -131351,
            (label, clock) => Lines(
                label,
                clock.OfCube("SPACECRAFTCLOCKSTARTCOUNT")
                    ?? clock.OfUtc(label.Find("CORRECTEDSTARTTIME") is null ? "STARTTIME" : "CORRECTEDSTARTTIME"),
                label.Find("CORRECTEDSAMPLINGINTERVAL") is null ? "LINESAMPLINGINTERVAL" : "CORRECTEDSAMPLINGINTERVAL"))
        {
            Spacecraft = -131,
            FirstSample = label => label.Text("SWATHMODEID") switch
            {
                "NOMINAL" => 296,
                "HALF" => 1171,
                _ => 0,
            },
        },
        new(
            "ISIS's IdealCamera (cubes of --camera-model isis)", label => label.Text("INSTRUMENTID") == "IdealCamera",
            (label, _) => label.Path, _ => "+x,+y", label => (int)(label.Number("NAIFFRAMECODE") ?? 0.0), IdealTimes)
        {
            Spacecraft = -999,
            HasOwnLens = false, // the cube is the camera file
            Problem = label => label.Tables is null ? "only its cubes have a camera" : null,
        },
    ];

    public static KnownCamera? Of(ImageLabel label) => All.FirstOrDefault(camera => camera.Is(label));

    private static bool IsNac(ImageLabel label) => label.Text("INSTRUMENTID") is "NACL" or "NACR"
        || (label.Text("INSTRUMENTID") == "LROC" && label.Text("FRAMEID") is "LEFT" or "RIGHT")
        || label.Text("INSTRUMENTNAME").Contains("Narrow Angle Camera", StringComparison.OrdinalIgnoreCase);

    private static bool IsLeft(ImageLabel label) => label.Text("INSTRUMENTID") == "NACL" || label.Text("FRAMEID") == "LEFT"
        || label.Text("INSTRUMENTNAME").Contains("Left", StringComparison.OrdinalIgnoreCase);

    private static TwinTimes NacTimes(ImageLabel label, TwinClock clock)
    {
        string code = IsLeft(label) ? "INS-85600" : "INS-85610";
        double Naif(string item, double usual) => label.NaifNumbers($"{code}_{item}") is [double number] ? number : usual;
        double line = (Exposure(label, "LINEEXPOSUREDURATION") * (1.0 + Naif("MULTIPLI_LINE_ERROR", 0.0045)))
            + Naif("ADDITIVE_LINE_ERROR", 0.0);
        double start = clock.OfCount("SPACECRAFTCLOCKPREROLLCOUNT") is { } preroll
            ? preroll + (Naif("ADDITIONAL_PREROLL", 1024.0) * line) + Naif("CONSTANT_TIME_OFFSET", 0.0)
            : clock.OfUtc("STARTTIME");
        return new TwinTimes(start + (0.5 * line), line);
    }

    /// <summary>EphemerisTime is that of a frame, or the beginning of the first line.</summary>
    private static TwinTimes IdealTimes(ImageLabel label, TwinClock clock)
    {
        double time = label.Number("EPHEMERISTIME") ?? throw new BadInputException($"{label.Path}: the cube has no EphemerisTime.");
        double period = label.Text("INSTRUMENTTYPE").Equals("Linescan", StringComparison.OrdinalIgnoreCase)
            ? Exposure(label, "EXPOSUREDURATION")
            : 0.0;
        return new TwinTimes(time + (0.5 * period), period);
    }

    private static TwinTimes WacTimes(ImageLabel label, TwinClock clock) => new(
        (clock.OfCount("SPACECRAFTCLOCKSTARTCOUNT") ?? clock.OfUtc("STARTTIME")) + (0.5 * Exposure(label, "EXPOSUREDURATION")),
        Exposure(label, "INTERFRAMEDELAY"));

    private static TwinTimes Lines(ImageLabel label, double start, string period) =>
        new(start + (0.5 * Exposure(label, period)), Exposure(label, period));

    private static double Exposure(ImageLabel label, string name) => label.Seconds(name) is > 0.0 and double seconds
        ? seconds
        : throw new BadInputException($"{label.Path}: the label has no {name} above 0, by which the times of its lines are known. Give "
            + "--scan-period.");
}

/// <summary>When a product was taken.</summary>
/// <param name="Start">TDB seconds past J2000: middle of the exposure of the first line, framelet or image.</param>
/// <param name="Period">s from one to the next; 0 for a frame.</param>
internal sealed record TwinTimes(double Start, double Period);
