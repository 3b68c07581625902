using Msisf.Adapters.Input;
using Msisf.Core.Detector;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the keys of a detector's dark current.</summary>
internal static class DarkCurrentKeys
{
    private const double AbsoluteZero = -273.15; // degrees Celsius
    private const double HottestDetector = 200.0; // degrees Celsius: beyond, no detector works
    private const double MaxNonuniformity = 10.0;

    public static string[] Keys { get; } =
    [
        "dark-current", "dark-temperature", "temperature", "dark-doubling", "dsnu", "hot-pixels", "hot-fraction", "hot-rate",
    ];

    /// <summary>Reads the keys.</summary>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static DarkCurrent Read(SettingsSection section, DetectorGeometry geometry)
    {
        DetectorSection.RequireWith(section, "dsnu", "dark-current");
        DetectorSection.RequireWith(section, "hot-rate", "hot-fraction");
        DetectorSection.RequireWith(section, "hot-fraction", "hot-rate");
        DarkCurrent plain = new();
        double reference = Temperature(section, "dark-temperature") ?? plain.ReferenceTemperature;
        return plain with
        {
            Rate = DetectorSection.NotNegative(section, "dark-current") ?? 0.0,
            ReferenceTemperature = reference,
            Temperature = Temperature(section, "temperature") ?? reference,
            DoublingTemperature = section.Positive("dark-doubling") ?? plain.DoublingTemperature,
            Nonuniformity = DetectorSection.Range(section, "dsnu", 0.0, MaxNonuniformity) ?? 0.0,
            HotFraction = DetectorSection.Range(section, "hot-fraction", 0.0, 1.0) ?? 0.0,
            HotRate = section.Positive("hot-rate") ?? 0.0,
            HotPixels = [.. PixelLists.Read(section, "hot-pixels", 3, geometry).Select(pixel => Hot(section, pixel))],
        };
    }

    private static double? Temperature(SettingsSection section, string key) =>
        DetectorSection.Range(section, key, AbsoluteZero, HottestDetector);

    private static HotPixel Hot(SettingsSection section, double[] pixel) => pixel[2] >= 0.0
        ? new HotPixel((int)pixel[0], (int)pixel[1], pixel[2])
        : throw section.Wrong("hot-pixels", "'hot-pixels' has a rate below 0; each pixel takes column, row and electrons per second");
}

/// <summary>Reads the keys of a detector's shutter.</summary>
internal static class ShutterKeys
{
    private const string Kind = "shutter";
    private const string LineTime = "line-time";
    private const string Step = "motion-step";
    private const string Rolling = "rolling";
    private const double MinStep = 0.01; // px
    private const double MaxStep = 1.0; // px

    public static string[] Keys { get; } = [Kind, LineTime, Step];

    /// <summary>Reads the shutter; null if there is none, so that frames are exposed at an instant.</summary>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static Shutter? Read(SettingsSection section)
    {
        DetectorSection.RequireWith(section, LineTime, Kind);
        DetectorSection.RequireWith(section, Step, Kind);
        if (section.Word(Kind, ["global", Rolling]) is not string kind)
        {
            return null;
        }

        double? lineTime = section.Positive(LineTime);
        if (kind == Rolling && lineTime is null)
        {
            throw section.Wrong(Kind, $"a rolling shutter needs '{LineTime}': the time in s from the exposure of a row to the next");
        }

        return kind == Rolling || lineTime is null
            ? new Shutter
            {
                LineTime = lineTime ?? 0.0,
                MaxStep = DetectorSection.Range(section, Step, MinStep, MaxStep) ?? Shutter.DefaultMaxStep,
            }
            : throw section.Wrong(LineTime, $"'{LineTime}' has no meaning with a global shutter. Leave it out, or make it {Rolling}");
    }
}

/// <summary>Reads lists of pixels from a camera file.</summary>
internal static class PixelLists
{
    private const int MaxNumbers = 300_000;

    /// <summary>Reads a list: column and row of each pixel, from 1, and what else belongs to it.</summary>
    /// <param name="numbersPerPixel">2, or more if a pixel has other numbers.</param>
    /// <param name="geometry">The image's size.</param>
    /// <returns>The numbers of each pixel; empty if the key is not there.</returns>
    public static IReadOnlyList<double[]> Read(SettingsSection section, string key, int numbersPerPixel, DetectorGeometry geometry)
    {
        double[] numbers = section.Numbers(key, numbersPerPixel, MaxNumbers) ?? [];
        if (numbers.Length % numbersPerPixel != 0)
        {
            throw section.Wrong(key, $"'{key}' has {numbers.Length} numbers; {numbersPerPixel} of each pixel are needed");
        }

        double[][] pixels = [.. numbers.Chunk(numbersPerPixel)];
        foreach (double[] pixel in pixels)
        {
            if (!IsIn(pixel[0], geometry.Width) || !IsIn(pixel[1], geometry.Height))
            {
                string pair = Invariant($"({pixel[0]}, {pixel[1]})");
                throw section.Wrong(
                    key, $"'{key}' names pixel {pair}; columns go from 1 to {geometry.Width}, rows from 1 to {geometry.Height}");
            }
        }

        return pixels;
    }

    private static bool IsIn(double number, int max) => number >= 1.0 && number <= max && number == Math.Floor(number);
}
