using System.Text.RegularExpressions;
using Msisf.Adapters.Input;

namespace Msisf.Adapters.CameraImport;

/// <summary>COLMAP's cameras.txt: a camera a line. It counts pixels from the upper left corner of the first one.</summary>
/// <remarks>colmap/colmap, doc/cameras.rst and src/colmap/sensor/models.h.</remarks>
internal static partial class ColmapFile
{
    private const string Program = "COLMAP";

    /// <summary>Each model: how many focal lengths and other numbers it has, and what its lens is (docs/cameras.md).</summary>
    private static readonly Dictionary<string, ColmapModel> Models =
        new(StringComparer.Ordinal)
        {
            ["SIMPLE_PINHOLE"] = new(1, 0, _ => []),
            ["PINHOLE"] = new(2, 0, _ => []),
            ["SIMPLE_RADIAL"] = new(1, 1, k => ImportedCamera.OpenCv(k)),
            ["RADIAL"] = new(1, 2, k => ImportedCamera.OpenCv(k)),
            ["OPENCV"] = new(2, 4, k => ImportedCamera.OpenCv(k)),
            ["FULL_OPENCV"] = new(2, 8, k => ImportedCamera.OpenCv(k)),
            ["SIMPLE_FISHEYE"] = new(1, 0, k => ImportedCamera.Fisheye(k)),
            ["FISHEYE"] = new(2, 0, k => ImportedCamera.Fisheye(k)),
            ["SIMPLE_RADIAL_FISHEYE"] = new(1, 1, k => ImportedCamera.Fisheye(k)),
            ["RADIAL_FISHEYE"] = new(1, 2, k => ImportedCamera.Fisheye(k)),
            ["OPENCV_FISHEYE"] = new(2, 4, k => ImportedCamera.Fisheye(k)),
            ["THIN_PRISM_FISHEYE"] = new(2, 8, k => k is [_, _, 0.0, 0.0, _, _, 0.0, 0.0] // k1, k2, p1, p2, k3, k4, sx1, sy1
                ? ImportedCamera.Fisheye(k[0], k[1], k[4], k[5])
                : null),
            ["SIMPLE_DIVISION"] = new(1, 1, Division),
            ["DIVISION"] = new(2, 1, Division),
        };

    public static bool Is(string text) => CameraFormats.Lines(text).FirstOrDefault().Text is { } first && Head().IsMatch(first);

    public static IReadOnlyList<NamedCamera> Read(string text, string path) =>
    [
        .. CameraFormats.Lines(text).Select(line =>
        {
            string[] words = line.Text.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
            return new NamedCamera(words[0], () => Camera(words, path, line.Line));
        }),
    ];

    private static ImportedCamera Camera(string[] words, string path, int line)
    {
        BadInputException Wrong(string why) => new($"{path}, line {line}: {why}.");
        if (words.Length < 4 || !int.TryParse(words[2], NumberStyles.None, CultureInfo.InvariantCulture, out int width)
            || !int.TryParse(words[3], NumberStyles.None, CultureInfo.InvariantCulture, out int height))
        {
            throw Wrong("CAMERA_ID, MODEL, WIDTH, HEIGHT and the parameters are needed");
        }

        if (!Models.TryGetValue(words[1], out ColmapModel? model))
        {
            throw Wrong(
                $"the camera model {NumberText.Shown(words[1])} has no counterpart in msis. Read are {string.Join(", ", Models.Keys)}");
        }

        double[] numbers = [.. words[4..].Select(
            word => NumberText.TryParse(word, out double number) ? number : throw Wrong(NumberText.ProblemWith(word)))];
        if (numbers.Length != model.Focals + 2 + model.Lens)
        {
            throw Wrong($"{words[1]} has {model.Focals + 2 + model.Lens} parameters, and {numbers.Length} are there");
        }

        return new ImportedCamera(Program, line)
        {
            Size = (width, height),
            Focal = (numbers[0], numbers[model.Focals - 1]),
            Principal = (numbers[model.Focals], numbers[model.Focals + 1]),
            Convention = "colmap",
            LensUnits = words[1].EndsWith("DIVISION", StringComparison.Ordinal) ? 1.0 : null,
            Lens = model.Keys(numbers[(model.Focals + 2)..]) ?? throw Wrong(
                $"{words[1]} with p1, p2, sx1 or sy1 has no counterpart in msis. Let COLMAP estimate OPENCV_FISHEYE"),
        };
    }

    private static IReadOnlyList<(string, double[], string)> Division(double[] k) =>
        [ImportedCamera.Key("model", "radial"), ImportedCamera.Key("form", "division"), ImportedCamera.Key("k", k)];

    [GeneratedRegex(@"^\d+\s+[A-Z][A-Z_0-9]+\s+\d+\s+\d+\s")]
    private static partial Regex Head();

    /// <summary>A model of COLMAP.</summary>
    /// <param name="Focals">How many focal lengths it has.</param>
    /// <param name="Lens">How many numbers follow the principal point.</param>
    /// <param name="Keys">The lens of these numbers, as a camera file has it; null if it has no counterpart.</param>
    private sealed record ColmapModel(int Focals, int Lens, Func<double[], IReadOnlyList<(string, double[], string)>?> Keys);
}

/// <summary>A pinhole file (.tsai) of the Ames Stereo Pipeline; lengths in any unit, often mm. It does not have the image's size.</summary>
/// <remarks>The manual of the Ames Stereo Pipeline, "Pinhole models".</remarks>
internal static partial class TsaiFile
{
    private const string Program = "Ames Stereo Pipeline";

    private const string ToTsai = "Convert it to TSAI with convert_pinhole_model";

    private static readonly (string Key, double[] Axis)[] Axes =
        [("u_direction", [1.0, 0.0, 0.0]), ("v_direction", [0.0, 1.0, 0.0]), ("w_direction", [0.0, 0.0, 1.0])];

    private static readonly string[] Types = ["PINHOLE", "OPTICAL_BAR"];

    public static bool Is(string text) => Head().IsMatch(text);

    public static IReadOnlyList<NamedCamera> Read(string text, string path) =>
        [new NamedCamera("1", () => Camera([.. CameraFormats.Lines(text)], path))];

    private static ImportedCamera Camera((string Text, int Line)[] lines, string path)
    {
        Dictionary<string, (double[] Numbers, int Line)> values = new(StringComparer.Ordinal);
        string lens = "NULL";
        int lensLine = 1;
        foreach ((string text, int line) in lines)
        {
            string[] parts = text.Split('=', 2, StringSplitOptions.TrimEntries);
            if (parts.Length == 2)
            {
                string[] words = parts[1].Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries);
                values[parts[0]] = ([.. words.Select(word => NumberText.TryParse(word, out double number)
                    ? number
                    : throw Wrong(line, NumberText.ProblemWith(word)))], line);
            }
            else if (text.All(letter => char.IsAsciiLetterUpper(letter) || letter is '_' or >= '0' and <= '9')
                && !text.StartsWith("VERSION_", StringComparison.Ordinal) && !Types.Contains(text))
            {
                (lens, lensLine) = (text, line);
            }
        }

        if (lines.FirstOrDefault(line => line.Text == "OPTICAL_BAR") is { Line: > 0 } bar)
        {
            throw Wrong(bar.Line, "an optical bar camera has no counterpart in msis; PINHOLE is read");
        }

        foreach ((string key, double[] axis) in Axes)
        {
            if (values.TryGetValue(key, out (double[] Numbers, int Line) given) && !given.Numbers.SequenceEqual(axis))
            {
                throw Wrong(given.Line, $"{key} is not {string.Join(' ', axis)}. Turn R instead");
            }
        }

        double pitch = Number("pitch");
        double focal = Number("fu");
        return new ImportedCamera(Program, 1)
        {
            Focal = (focal / pitch, Number("fv") / pitch),
            Principal = (Number("cu") / pitch, Number("cv") / pitch),
            LensUnits = lens == "BROWNCONRADY" ? focal : null,
            Lens = lens switch
            {
                "NULL" => [],
                "TSAI" => ImportedCamera.OpenCv(Number("k1"), Number("k2"), Number("p1"), Number("p2"), Optional("k3")),
                "FISHEYE" => ImportedCamera.Fisheye(Number("k1"), Number("k2"), Number("k3"), Number("k4")),
                "BROWNCONRADY" when ((string[])["xp", "yp", "p1", "p2", "phi"]).All(key => Optional(key) == 0.0) =>
                [
                    ImportedCamera.Key("model", "radial"), ImportedCamera.Key("form", "factor"),
                    ImportedCamera.Key("k", Number("k1"), Number("k2"), Number("k3")),
                ],
                "BROWNCONRADY" => throw Wrong(
                    lensLine, $"BROWNCONRADY with xp, yp, p1, p2 or phi has no counterpart in msis. Convert it to TSAI "
                            + "with convert_pinhole_model"),
                _ => throw Wrong(
                    lensLine, $"the lens {NumberText.Shown(lens)} has no counterpart in msis. Convert it to TSAI with "
                            + $"convert_pinhole_model"),
            },
        };

        double Number(string key) => values.TryGetValue(key, out (double[] Numbers, int Line) found) && found.Numbers is [double number]
            ? number
            : throw Wrong(1, $"'{key} = ' with one number is needed");

        double Optional(string key) => values.ContainsKey(key) ? Number(key) : 0.0;

        BadInputException Wrong(int line, string why) => new($"{path}, line {line}: {why}.");
    }

    [GeneratedRegex(@"\A\s*(?:VERSION_\d+\s+)?(?:PINHOLE|OPTICAL_BAR|fu\s*=)\s")]
    private static partial Regex Head();
}
