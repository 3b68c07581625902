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
