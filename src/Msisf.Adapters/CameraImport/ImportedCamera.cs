using Msisf.Adapters.Input;

namespace Msisf.Adapters.CameraImport;

/// <summary>A camera of another program's file, on its way to the keys of a camera file (docs/cameras.md).</summary>
/// <param name="Program">Whose file it is, for messages and the description.</param>
/// <param name="Line">Where the camera begins, from 1.</param>
internal sealed record ImportedCamera(string Program, int Line)
{
    /// <summary>px; null where the file does not say it.</summary>
    public (int Width, int Height)? Size { get; init; }

    /// <summary>px, along rows and columns.</summary>
    public (double X, double Y) Focal { get; init; }

    /// <summary>px: where the optical axis meets the image.</summary>
    public (double X, double Y) Principal { get; init; }

    /// <summary>In which the principal point is counted, as camera files name it.</summary>
    public string Convention { get; init; } = "opencv";

    /// <summary>px: the element of K's first row and second column.</summary>
    public double Skew { get; init; }

    /// <summary>The focal length in the unit of the lens's coefficients; null for a lens whose unit is the focal length.</summary>
    public double? LensUnits { get; init; }

    /// <summary>The keys of the section distortion; none for a pinhole.</summary>
    public IReadOnlyList<(string Key, double[] Numbers, string Word)> Lens { get; init; } = [];

    /// <summary>The keys of the section scan; none for a frame.</summary>
    public IReadOnlyList<(string Key, double[] Numbers, string Word)> Scan { get; init; } = [];

    /// <summary>A key with numbers.</summary>
    public static (string Key, double[] Numbers, string Word) Key(string key, params double[] numbers) => (key, numbers, string.Empty);

    /// <summary>A key with a word.</summary>
    public static (string Key, double[] Numbers, string Word) Key(string key, string word) => (key, [], word);

    /// <summary>A lens of OpenCV.</summary>
    /// <param name="coefficients">k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, or fewer.</param>
    public static IReadOnlyList<(string Key, double[] Numbers, string Word)> OpenCv(params double[] coefficients)
    {
        string[] names = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"];
        return coefficients.All(coefficient => coefficient == 0.0)
            ? []
            : [Key("model", "opencv"), .. names.Zip(coefficients, (name, value) => Key(name, value))];
    }

    /// <summary>A fisheye lens of OpenCV; without coefficients it is equidistant.</summary>
    /// <param name="k">k1 to k4, or fewer.</param>
    public static IReadOnlyList<(string Key, double[] Numbers, string Word)> Fisheye(params double[] k) =>
    [
        Key("model", "fisheye"), .. Enumerable.Range(0, 4).Select(i => Key(Invariant($"k{i + 1}"), i < k.Length ? k[i] : 0.0)),
    ];

    /// <summary>The camera as the entries of a camera file; all are in the line of the camera.</summary>
    public IReadOnlyList<ConfigEntry> Entries()
    {
        List<ConfigEntry> entries = [Entry(Key("description", $"read from a file of {Program}"))];
        if (Size is (int width, int height))
        {
            entries.Add(Entry(Key("width", width)));
            entries.Add(Entry(Key("height", height)));
        }

        if (LensUnits is { } focal)
        {
            entries.Add(Entry(Key("focal-length", focal)));
            entries.Add(Entry(Key("pixel-pitch", focal / Focal.X, focal / Focal.Y)));
        }
        else
        {
            entries.Add(Entry(Key("focal-length-px", Focal.X, Focal.Y)));
        }

        entries.Add(Entry(Key("principal-point", Principal.X, Principal.Y)));
        entries.Add(Entry(Key("pixel-convention", Convention)));
        if (Skew != 0.0)
        {
            entries.Add(Entry(Key("skew", Skew)));
        }

        foreach ((string name, IReadOnlyList<(string, double[], string)> keys) in new[] { ("distortion", Lens), ("scan", Scan) })
        {
            if (keys.Count > 0)
            {
                entries.Add(new ConfigEntry(name, [], IsList: false, Line, Column: 1, [.. keys.Select(Entry)]));
            }
        }

        return entries;
    }

    private ConfigEntry Entry((string Key, double[] Numbers, string Word) of) => new(
        of.Key, of.Numbers.Length == 0 ? [of.Word] : [.. of.Numbers.Select(number => number.ToString("R", CultureInfo.InvariantCulture))],
        of.Numbers.Length > 1, Line, Column: 1);
}
