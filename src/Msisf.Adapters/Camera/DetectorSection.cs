using Msisf.Adapters.Input;
using Msisf.Core.Detector;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the section "detector" of a camera file (docs/detector.md).</summary>
internal static class DetectorSection
{
    private const string Name = "detector";
    private const string What = "a detector";
    private const double MetresPerMillimetre = 1e-3;
    private const double MaxNonuniformity = 0.2; // of the response: five standard deviations stay above 0
    private const int MaxConverterBits = 16;
    private const double LeastFNumber = 0.5; // of a lens in air: its cone of light is half of all directions

    private static readonly string[] Keys =
    [
        "aperture", "f-number", "transmission", "quantum-efficiency", "wavelengths", "band", "exposure-time", "vignetting", "prnu",
        "dead-pixels", "dead-fraction", "cosmic-rays", "cosmic-ray-depth", "smear-row-time", "smear-direction", "smear-before-exposure",
        "full-well", "blooming", "gain", "read-noise", "bias", "column-offset", "adc-bits", "seed", "fits",
        .. ShutterKeys.Keys, .. DarkCurrentKeys.Keys, .. PointSpreadKeys.Keys, .. FarWingKeys.Keys,
    ];

    /// <summary>Reads the section.</summary>
    /// <param name="file">The top level of the file.</param>
    /// <param name="geometry">What the top level says about the camera.</param>
    /// <returns>Null if there is no section.</returns>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static CameraFileDetector? Read(SettingsSection file, DetectorGeometry geometry)
    {
        if (file.Section(Name, What, Keys) is not { } section)
        {
            return null;
        }

        double exposureTime = Required(section, "exposure-time", "the exposure time in s");
        (double? fNumber, double diameter) = Aperture(section, geometry);
        PointSpreadKeys psf = new(section, geometry, fNumber);
        DetectorSettings settings = new()
        {
            ApertureArea = Math.PI / 4.0 * diameter * diameter,
            Response = BandKeys.Read(section),
            ExposureTime = exposureTime,
            Shutter = ShutterKeys.Read(section),
            IsFlatFielded = section.Word("vignetting", ["natural", "none"]) == "none",
            PointSpread = psf.Read(),
            FarWings = FarWingKeys.Read(section),
            ResponseNonuniformity = Range(section, "prnu", 0.0, MaxNonuniformity) ?? 0.0,
            Dark = DarkCurrentKeys.Read(section, geometry),
            DeadFraction = Range(section, "dead-fraction", 0.0, 1.0) ?? 0.0,
            DeadPixels =
            [
                .. PixelLists.Read(section, "dead-pixels", 2, geometry).Select(pixel => new DeadPixel((int)pixel[0], (int)pixel[1])),
            ],
            Smear = Smear(section),
            CosmicRays = Rays(section, geometry),
            PixelPitch = geometry.PixelPitch is (double x, double y) ? Math.Sqrt(x * y) : 0.0,
            FullWell = section.Positive("full-well") ?? double.PositiveInfinity,
            IsBlooming = Blooming(section),
            ReadNoise = NotNegative(section, "read-noise") ?? 0.0,
            Gain = Required(section, "gain", "electrons per DN"),
            Bias = NotNegative(section, "bias") ?? 0.0,
            ColumnOffset = NotNegative(section, "column-offset") ?? 0.0,
            ConverterBits = section.Whole("adc-bits", 1, MaxConverterBits)
                ?? throw section.Missing("adc-bits", "bits of the analogue-to-digital converter, 1 to 16"),
            Seed = Seed(section),
        };
        return new CameraFileDetector(settings, YesOrNo(section, "fits") ?? true, psf.KernelSha256);
    }

    /// <summary>A number that is not negative; null if the key is not there.</summary>
    internal static double? NotNegative(SettingsSection section, string key) => section.Number(key) is double number && number < 0.0
        ? throw section.Wrong(key, $"'{key}' is {section.Text(key)}; a number from 0 on is needed")
        : section.Number(key);

    /// <summary>A number in a range; null if the key is not there.</summary>
    internal static double? Range(SettingsSection section, string key, double min, double max) =>
        section.Number(key) is double number && !(number >= min && number <= max)
            ? throw section.Wrong(
                key, Invariant($"'{key}' is {section.Text(key)}; a number from {min} to {max} is needed"))
            : section.Number(key);

    /// <summary>Refuses a key that has no meaning without another one.</summary>
    internal static void RequireWith(SettingsSection section, string key, string needed)
    {
        if (section.Has(key) && !section.Has(needed))
        {
            throw section.Wrong(key, $"'{key}' has no meaning without '{needed}'. Give both, or none");
        }
    }

    private static double Required(SettingsSection section, string key, string meaning) =>
        section.Positive(key) ?? throw section.Missing(key, meaning);

    private static bool? YesOrNo(SettingsSection section, string key) =>
        section.Word(key, ["yes", "no", "true", "false"]) is string word ? word is "yes" or "true" : null;

    private static (double? FNumber, double Diameter) Aperture(SettingsSection section, DetectorGeometry geometry)
    {
        if (section.Has("aperture") && section.Has("f-number"))
        {
            throw section.Wrong("f-number", "'aperture' and 'f-number' exclude each other. Leave one out");
        }

        if (section.Positive("f-number") is double fNumber)
        {
            double focalLength = geometry.FocalLength
                ?? throw section.Wrong("f-number", "'f-number' needs 'focal-length' in mm. Give that, or 'aperture'");
            return (Checked(section, "f-number", fNumber), focalLength / fNumber);
        }

        double diameter = MetresPerMillimetre * Required(section, "aperture", "the aperture's diameter in mm; 'f-number' does as well");
        return (geometry.FocalLength is double focal ? Checked(section, "aperture", focal / diameter) : null, diameter);
    }

    private static double Checked(SettingsSection section, string key, double fNumber) => fNumber >= LeastFNumber
        ? fNumber
        : throw section.Wrong(key, Invariant(
            $"the f-number is {fNumber:G4}, and no lens has one below {LeastFNumber}: it is the focal length over the aperture's diameter")
                + ", both in mm");

    private static Smear? Smear(SettingsSection section)
    {
        RequireWith(section, "smear-direction", "smear-row-time");
        RequireWith(section, "smear-before-exposure", "smear-row-time");
        return section.Positive("smear-row-time") is not double rowTime
            ? null
            : new Smear
            {
                RowTime = rowTime,
                TowardsBottom = section.Word("smear-direction", ["down", "up"]) != "up",
                BeforeExposure = YesOrNo(section, "smear-before-exposure") ?? true,
            };
    }

    private static CosmicRays? Rays(SettingsSection section, DetectorGeometry geometry)
    {
        RequireWith(section, "cosmic-ray-depth", "cosmic-rays");
        if (section.Positive("cosmic-rays") is not double rate)
        {
            return null;
        }

        CosmicRays rays = new() { Rate = rate };
        return geometry.PixelPitch is null
            ? throw section.Wrong("cosmic-rays", "'cosmic-rays' needs 'focal-length' and 'pixel-pitch' in mm")
            : section.Positive("cosmic-ray-depth") is double depth ? rays with { Thickness = depth } : rays;
    }

    private static bool Blooming(SettingsSection section)
    {
        RequireWith(section, "blooming", "full-well");
        return YesOrNo(section, "blooming") ?? false;
    }

    private static ulong? Seed(SettingsSection section)
    {
        const ulong DefaultSeed = 1;
        string? text = section.Text("seed");
        return text switch
        {
            null => DefaultSeed,
            "none" => null,
            _ when ulong.TryParse(
                text, System.Globalization.NumberStyles.None, System.Globalization.CultureInfo.InvariantCulture, out ulong seed) => seed,
            _ => throw section.Wrong("seed", $"'seed' is {Input.NumberText.Shown(text)}; a whole number from 0 on, or none, is needed"),
        };
    }
}

/// <summary>What the section of the detector needs to know of the rest of a camera file.</summary>
/// <param name="Path">Path of the file; a kernel's path is relative to its folder.</param>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="FocalLength">m; null if the file does not give it in mm.</param>
/// <param name="PixelPitch">m; null if the file does not give it.</param>
/// <param name="MayNameFiles">Whether the file may name another one, the PSF's kernel.</param>
internal sealed record DetectorGeometry(
    string Path, int Width, int Height, double? FocalLength, (double X, double Y)? PixelPitch, bool MayNameFiles = true);
