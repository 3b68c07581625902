using Msisf.Adapters.Input;
using Msisf.Core.Camera.Lenses;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the section "distortion" of a camera file.</summary>
internal static class DistortionSection
{
    private const string Section = "distortion";
    private const string What = "a distortion";

    private static readonly Dictionary<string, string[]> KeysOfModels = new(StringComparer.Ordinal)
    {
        ["none"] = [],
        ["brown-conrady"] = ["k1", "k2", "k3", "p1", "p2"],
        ["opencv"] = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"],
        ["owen"] = ["e1", "e2", "e3", "e4", "e5", "e6"],
        ["fisheye"] = ["k1", "k2", "k3", "k4"],
        ["radial"] = ["k", "form"],
        ["polynomial"] = ["x", "y", "argument"],
        ["brown"] = ["k0", "k1", "k2", "k3", "p1", "p2", "s1", "s2", "s3", "s4", "x0", "y0"],
    };

    /// <summary>Reads the section.</summary>
    /// <param name="file">The top level of the file.</param>
    /// <param name="focalLength">mm; null if the file does not give it in mm.</param>
    /// <returns>Null if there is no section, or nothing is distorted.</returns>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public static Distortion? Read(SettingsSection file, double? focalLength)
    {
        string[] allKeys = ["model", .. KeysOfModels.Values.SelectMany(keys => keys).Distinct()];
        if (file.Section(Section, What, allKeys) is not { } section)
        {
            return null;
        }

        string model = section.Word("model", [.. KeysOfModels.Keys])
            ?? throw section.Missing("model", $"one of {string.Join(", ", KeysOfModels.Keys)}");
        string[] keys = KeysOfModels[model];
        section = file.Section(Section, $"the distortion model '{model}'", ["model", .. keys])!;
        double Value(string key) => section.Number(key) ?? 0.0;
        if (model is "brown-conrady" or "opencv" or "owen" or "fisheye" or "brown" && !keys.Any(section.Has))
        {
            throw section.Missing(keys[0], $"at least one coefficient of {string.Join(", ", keys)}; the others are 0");
        }

        Distortion? distortion = model switch
        {
            "brown-conrady" => new OpenCvDistortion([Value("k1"), Value("k2"), Value("k3")], [Value("p1"), Value("p2")]),
            "opencv" => new OpenCvDistortion(
                [Value("k1"), Value("k2"), Value("k3"), Value("k4"), Value("k5"), Value("k6")],
                [Value("p1"), Value("p2")],
                [Value("s1"), Value("s2"), Value("s3"), Value("s4")]),
            "owen" => new OwenDistortion(
                [Value("e1"), Value("e2"), Value("e3"), Value("e4"), Value("e5"), Value("e6")], Millimetres(section, focalLength, "owen")),
            "fisheye" => new FisheyeDistortion([Value("k1"), Value("k2"), Value("k3"), Value("k4")]),
            "radial" => Radial(section, focalLength),
            "polynomial" => Polynomial(section, focalLength),
            "brown" => new BrownDistortion(
                [Value("k0"), Value("k1"), Value("k2"), Value("k3")],
                [Value("p1"), Value("p2")],
                [Value("s1"), Value("s2"), Value("s3"), Value("s4")],
                (Value("x0"), Value("y0")),
                Millimetres(section, focalLength, "brown")),
            _ => null,
        };
        return distortion is null or { IsNone: true } ? null : distortion;
    }

    private static RadialDistortion Radial(SettingsSection section, double? focalLength)
    {
        double[] k = section.Numbers("k", 1, 3)
            ?? throw section.Missing("k", "one to three coefficients, in 1/mm2, 1/mm4 and 1/mm6");
        string form = section.Word("form", ["factor", "division"]) ?? "factor";
        return new RadialDistortion(k, form == "division", Millimetres(section, focalLength, "radial"));
    }

    private static PolynomialDistortion Polynomial(SettingsSection section, double? focalLength)
    {
        double[] Coefficients(string key) => section.Numbers(key, 1, 4)
            ?? throw section.Missing(key, "one to four coefficients of the polynomial that is added, in mm");
        string argument = section.Word("argument", ["radius", "x"]) ?? "radius";
        return new PolynomialDistortion(
            Coefficients("x"), Coefficients("y"), argument == "radius", Millimetres(section, focalLength, "polynomial"));
    }

    private static double Millimetres(SettingsSection section, double? focalLength, string model) => focalLength
        ?? throw section.Wrong("model", $"the distortion model '{model}' is in mm and needs 'focal-length' and 'pixel-pitch' in mm");
}
