using System.Text.RegularExpressions;
using Msisf.Adapters.Input;
using Msisf.Adapters.Raster.Pds;
using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraImport;

/// <summary>The camera of USGSCSM's state, or of the image support data (ISD) from which it makes one; not its pose.</summary>
/// <remarks>DOI-USGS/usgscsm 2.1: UsgsAstroFrameSensorModel, UsgsAstroLsSensorModel, UsgsAstroPushFrameSensorModel, Distortion.</remarks>
internal static class CsmCamera
{
    private const string ModelOfFrames = "USGS_ASTRO_FRAME_SENSOR_MODEL";

    private static readonly Dictionary<string, ScanKind?> Kinds = new(StringComparer.Ordinal)
    {
        [ModelOfFrames] = null,
        ["USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL"] = ScanKind.LineScan,
        ["USGS_ASTRO_PUSH_FRAME_SENSOR_MODEL"] = ScanKind.PushFrame,
    };

    /// <summary>The names of lenses in an ISD, at the place of their number in a state.</summary>
    private static readonly string[] Lenses =
        ["radial", "transverse", "kaguyalism", "dawnfc", "lrolrocnac", "cahvor", "lunarorbiter", "radtan"];

    private static readonly Names InState = new(
        "USGSCSM", "mdetectorsamplesumming", "mdetectorlinesumming", "mstartingdetectorsample", "mstartingdetectorline", "mnsamples",
        "mnlines", "mframeletheight", "minterframedelay", "mframeletsorderreversed", "minttimes", 0);

    private static readonly Names InIsd = new(
        "ALE", "detectorsamplesumming", "detectorlinesumming", "startingdetectorsample", "startingdetectorline", "imagesamples",
        "imagelines", "frameletheight", "interframedelay", "frameletorderreversed", "linescanrate", 2);

    public static bool IsState(string text) => text.StartsWith("USGS_ASTRO_", StringComparison.Ordinal)
        || (text.TrimStart() is ['{', ..] && text.Contains("\"m_modelName\"", StringComparison.Ordinal));

    public static bool IsIsd(string text) => text.TrimStart() is ['{', ..] && text.Contains("\"name_model\"", StringComparison.Ordinal);

    public static IReadOnlyList<NamedCamera> ReadState(string text, string path)
    {
        int start = text.IndexOf('{', StringComparison.Ordinal);
        FileTree root = FileTree.OfJson(start < 0 ? string.Empty : text[start..], path);
        return [new NamedCamera("1", () => OfState(new Members(root, path)))];
    }

    public static IReadOnlyList<NamedCamera> ReadIsd(string text, string path) =>
        [new NamedCamera("1", () => OfIsd(new Members(FileTree.OfJson(text, path), path)))];

    private static ImportedCamera OfState(Members state)
    {
        ScanKind? scan = KindOf(state, state.Word("mmodelname"));
        double[] center = scan is null
            ? state.Numbers("mccdcenter", 2)
            : [state.Number("mdetectorlineorigin"), state.Number("mdetectorsampleorigin")];
        return Plane(
            state, InState, scan, state.Number("mfocallength"), (state.Numbers("mitranss", 3), state.Numbers("mitransl", 3)),
            (center[1], center[0]), ((int)state.Number("mdistortiontype"), state.Numbers("mopticaldistcoeffs", null))).Camera();
    }

    private static ImportedCamera OfIsd(Members isd)
    {
        ScanKind? scan = KindOf(isd, isd.Word("namemodel"));
        Members center = isd.Below("detectorcenter");
        return Plane(
            isd, InIsd, scan, isd.Below("focallengthmodel").Number("focallength"),
            (isd.Numbers("focal2pixelsamples", 3), isd.Numbers("focal2pixellines", 3)), (center.Number("sample"), center.Number("line")),
            LensOf(isd)).Camera();
    }

    private static (int Type, double[] Coefficients) LensOf(Members isd)
    {
        Members holder = isd.Below("opticaldistortion");
        FileTree lens = holder.Root.Items is [var first, ..] ? first : throw holder.Wrong("'optical_distortion' names no lens");
        Members of = new(lens, holder.Path);
        int type = Array.IndexOf(Lenses, lens.Name);
        return (type, type switch
        {
            1 => [.. of.Numbers("x", 10), .. of.Numbers("y", 10)],
            2 => [of.Number("boresightx"), .. of.Numbers("x", 4), of.Number("boresighty"), .. of.Numbers("y", 4)],
            >= 0 => of.Numbers("coefficients", null),
            _ => throw holder.Wrong($"the lens '{lens.Name}' has no counterpart in msis. Give the camera as a camera file"),
        });
    }

    private static ScanKind? KindOf(Members members, string model) => Kinds.TryGetValue(model, out ScanKind? kind)
        ? kind
        : throw members.Wrong($"the sensor model '{model}' is not read; {string.Join(", ", Kinds.Keys)} are");

    private static FocalPlane Plane(
        Members file, Names names, ScanKind? scan, double focal, (double[] S, double[] L) factors, (double Sample, double Line) center,
        (int Type, double[] Coefficients) lens)
    {
        const double middleOfLine = 0.5; // px: a line-scan's origin is that of the middle of its row
        (double samples, double lines) = (file.Number(names.SampleSumming), file.Number(names.LineSumming));
        double height = scan switch
        {
            null => file.Number(names.Height),
            ScanKind.PushFrame => file.Number(names.FrameletHeight),
            _ => 1.0,
        };
        return new FocalPlane(
            names.Program, file.Path, focal, [.. factors.S.Select(factor => factor / samples)],
            [.. factors.L.Select(factor => factor / lines)],
            ((center.Sample - file.Number(names.StartSample)) / samples,
                ((center.Line - file.Number(names.StartLine)) / lines) + (scan == ScanKind.LineScan ? middleOfLine : 0.0)))
        {
            Size = ((int)file.Number(names.Width), (int)height),
            Scan = scan,
            Period = scan switch
            {
                ScanKind.LineScan => file.Numbers(names.LineTimes, null)[names.LineTime],
                ScanKind.PushFrame => (file.Flag(names.IsReversed) ? -1.0 : 1.0) * file.Number(names.FrameletTime),
                _ => 0.0,
            },
            LensType = lens.Type,
            Coefficients = lens.Coefficients,
        };
    }

    /// <summary>What a state and image support data call the same; compared without capitals and underscores.</summary>
    /// <param name="LineTime">The place of the first line's time among the line times.</param>
    private sealed record Names(
        string Program, string SampleSumming, string LineSumming, string StartSample, string StartLine, string Width, string Height,
        string FrameletHeight, string FrameletTime, string IsReversed, string LineTimes, int LineTime);

    /// <summary>The members of a JSON object.</summary>
    private sealed record Members(FileTree Root, string Path)
    {
        public Members Below(string name) => new(Required(name), Path);

        public string Word(string name) => Required(name).Value ?? string.Empty;

        public bool Flag(string name) => Root.Find(name)?.Value is "True" or "true" or "1";

        public double Number(string name) => Numbers(name, 1)[0];

        public double[] Numbers(string name, int? count) => Required(name).Numbers() is { } numbers
            && (count is null ? numbers.Length > 0 : numbers.Length == count)
            ? numbers
            : throw Wrong($"'{Required(name).Name}' needs {(count is { } n ? $"{n} " : string.Empty)}finite numbers");

        public BadInputException Wrong(string why) => new($"{Path}: {why}.");

        private FileTree Required(string name) => Root.Find(name)
            ?? throw Wrong($"this file of USGSCSM has no '{name}' (compared without capitals and '_'). Write it again");
    }
}

/// <summary>The IdealCamera of an ISIS cube, as <c>--camera-model isis</c> writes it; not its pose.</summary>
internal static partial class CubeCamera
{
    public static bool Is(string text) => Head().IsMatch(text);

    public static IReadOnlyList<NamedCamera> Read(string text, string path) =>
        [new NamedCamera("1", () => Camera(PdsLabelParser.ParseCube(text, path), path))];

    private static ImportedCamera Camera(PdsObject label, string path)
    {
        PdsObject instrument = label.FindObject("Instrument")
            ?? throw new BadInputException($"{path}: the cube has no group Instrument, and so no camera.");
        string name = instrument.Find("InstrumentId")?.Text ?? "none";
        PdsObject naif = name == "IdealCamera" && label.FindObject("NaifKeywords") is { } keywords
            ? keywords
            : throw new BadInputException(
                $"{path}: the camera of this cube is '{name}'; as a camera file only cubes of ISIS's "
                        + $"IdealCamera are read. 'msis twin {path}' "
                    + "draws what this one saw.");
        bool isScan = instrument.Find("InstrumentType")?.Text.Equals("Linescan", StringComparison.OrdinalIgnoreCase) == true;
        int width = instrument.RequiredInteger("SampleDetectors", 1, int.MaxValue);
        int height = isScan ? 1 : instrument.RequiredInteger("LineDetectors", 1, int.MaxValue);
        double pitch = naif.OptionalNumber("IDEAL_PIXEL_PITCH") ?? 1.0;
        double[] Factors(string keyword, double x, double y) => naif.Find(keyword)?.Items is { Count: 3 } items
            ? [.. items.Select(item => NumberText.TryParse(item.Text, out double number)
                ? number
                : throw naif.WrongValue(keyword, item, "three numbers are needed"))]
            : [0.0, x / pitch, y / pitch];
        return new FocalPlane(
            "ISIS", path, naif.RequiredNumber("IDEAL_FOCAL_LENGTH"), Factors("IDEAL_TRANSS", 1.0, 0.0), Factors("IDEAL_TRANSL", 0.0, 1.0),
            (0.5 * width, 0.5 * height))
        {
            Size = (width, height),
            Scan = isScan ? ScanKind.LineScan : null,
            Period = isScan ? 1e-3 * instrument.RequiredNumber("ExposureDuration") : 0.0,
        }.Camera();
    }

    [GeneratedRegex(@"\A\s*Object\s*=\s*IsisCube\s")]
    private static partial Regex Head();
}
