using Msisf.Adapters.Input;
using System.Security.Cryptography;
using Msisf.Core.Detector.Psf;

namespace Msisf.Adapters.Camera;

/// <summary>Reads the keys of a detector's point spread function.</summary>
internal sealed class PointSpreadKeys
{
    private const double DefaultRadius = 7.0; // px
    private const double GaussianSigmas = 4.0; // a Gaussian's default radius, where it is more than 7 px: 3e-4 of the light lie beyond
    private const double MinScale = 0.03; // px: a narrower function can't be integrated in the steps that a pixel is cut into
    private const double MetresPerNanometre = 1e-9;
    private const int MaxWeights = ((2 * PointSpreadKernel.MaxRadius) + 1) * ((2 * PointSpreadKernel.MaxRadius) + 1);

    private readonly SettingsSection _section;
    private readonly DetectorGeometry _geometry;
    private readonly double? _fNumber;

    /// <summary>Prepares the keys.</summary>
    /// <param name="section">The section of the detector.</param>
    /// <param name="geometry">The rest of the file.</param>
    /// <param name="fNumber">Focal length over aperture; null if the focal length is not known in mm.</param>
    public PointSpreadKeys(SettingsSection section, DetectorGeometry geometry, double? fNumber) =>
        (_section, _geometry, _fNumber) = (section, geometry, fNumber);

    public static string[] Keys { get; } =
    [
        "psf", "psf-sigma", "psf-scale", "psf-wavelength", "psf-kernel", "psf-radius", "wing-radius", "wing-exponent", "wing-fraction",
    ];

    /// <summary>Checksum of the file of the kernel; null if there is none.</summary>
    public string? KernelSha256 { get; private set; }

    /// <summary>Reads the keys.</summary>
    /// <returns>Null if the image of a point stays within its pixel.</returns>
    /// <exception cref="BadInputException">What is wrong, by file, line and column.</exception>
    public PointSpreadKernel? Read()
    {
        string model = _section.Word("psf", ["none", "gaussian", "airy", "kernel", "wings"]) ?? "none";
        RefuseOthers(model);
        double radius = DetectorSection.Range(_section, "psf-radius", 0.5, PointSpreadKernel.MaxRadius) ?? RadiusOf(model);
        PointSpreadKernel? core = model switch
        {
            "gaussian" => PointSpreadKernel.Of(new GaussianSpread(Scale("psf-sigma", "the standard deviation in px")), radius),
            "airy" => PointSpreadKernel.Of(new AirySpread(AiryScale()), radius),
            "kernel" => Kernel(),
            "wings" => Wings(radius),
            _ => null,
        };
        return core is null || model == "wings" || !_section.Has("wing-fraction")
            ? core
            : PointSpreadKernel.Mix(core, Wings(radius), DetectorSection.Range(_section, "wing-fraction", 0.0, 1.0)!.Value);
    }

    /// <summary>px: where a formula ends if the file does not say it.</summary>
    private double RadiusOf(string model)
    {
        if (model != "gaussian" || _section.Positive("psf-sigma") is not double sigma)
        {
            return DefaultRadius;
        }

        double radius = Math.Max(DefaultRadius, Math.Ceiling(GaussianSigmas * sigma));
        return radius <= PointSpreadKernel.MaxRadius ? radius : throw _section.Wrong("psf-sigma", Invariant(
            $"'psf-sigma' is {sigma} px; {GaussianSigmas} of them, {radius} px, pass {PointSpreadKernel.MaxRadius}. "
                + $"Give 'psf-radius' to cut it off"));
    }

    /// <summary>Refuses keys that have no meaning for a model.</summary>
    private void RefuseOthers(string model)
    {
        string[] used =
        [
            .. model switch
            {
                "gaussian" => (string[])["psf-sigma", "psf-radius", "wing-fraction"],
                "airy" => ["psf-scale", "psf-wavelength", "psf-radius", "wing-fraction"],
                "kernel" => ["psf-kernel", "psf-radius", "wing-fraction"],
                "wings" => ["wing-radius", "wing-exponent", "psf-radius"],
                _ => [],
            },
            .. _section.Has("wing-fraction") && model is "gaussian" or "airy" or "kernel"
                ? (string[])["wing-radius", "wing-exponent"]
                : [],
        ];
        if (Keys.FirstOrDefault(key => key != "psf" && _section.Has(key) && !used.Contains(key)) is string other)
        {
            throw _section.Wrong(other, other.StartsWith("wing", StringComparison.Ordinal) && model is not ("none" or "wings")
                ? $"'{other}' has no meaning without 'wing-fraction'. Give both, or none"
                : $"'{other}' has no meaning with the PSF '{model}'. Leave it out");
        }
    }

    private double Scale(string key, string meaning)
    {
        double scale = _section.Positive(key) ?? throw _section.Missing(key, meaning);
        return scale >= MinScale
            ? scale
            : throw _section.Wrong(key, Invariant(
                $"'{key}' is {_section.Text(key)} px; at least {MinScale} px are needed. For a sharper image leave 'psf' out"));
    }

    private double AiryScale()
    {
        if (_section.Has("psf-scale"))
        {
            return !_section.Has("psf-wavelength")
                ? Scale("psf-scale", string.Empty)
                : throw _section.Wrong("psf-scale", "'psf-wavelength' and 'psf-scale' exclude each other. Leave one out");
        }

        double wavelength = _section.Positive("psf-wavelength")
            ?? throw _section.Missing("psf-wavelength", "the wavelength in nm; 'psf-scale' in px does as well");
        BandKeys.RequireNanometres(_section, "psf-wavelength", "'psf-wavelength' is", wavelength);
        double scale = _fNumber is double fNumber && _geometry.PixelPitch is (double x, double y)
            ? MetresPerNanometre * wavelength * fNumber / Math.Sqrt(x * y)
            : throw _section.Wrong("psf-wavelength", "'psf-wavelength' needs 'focal-length' and 'pixel-pitch' in mm. Give 'psf-scale'");
        return scale >= MinScale
            ? scale
            : throw _section.Wrong("psf-wavelength", Invariant(
                $"the Airy disc is {scale} px wide; at least {MinScale} px are needed. For a sharper image leave 'psf' out"));
    }

    private PointSpreadKernel Wings(double radius)
    {
        double exponent = _section.Number("wing-exponent") ?? throw _section.Missing("wing-exponent", "b of (1 + (r/r0)^2)^(-b/2)");
        return exponent > 2.0
            ? PointSpreadKernel.Of(new WingSpread(Scale("wing-radius", "r0 of (1 + (r/r0)^2)^(-b/2) in px"), exponent), radius)
            : throw _section.Wrong("wing-exponent", $"'wing-exponent' is {_section.Text("wing-exponent")}; a number above 2 is needed");
    }

    private PointSpreadKernel Kernel()
    {
        if (!_section.Has("psf-kernel"))
        {
            throw _section.Missing("psf-kernel", "the kernel's weights, or the name of a FITS or NumPy file");
        }

        try
        {
            return new PointSpreadKernel(Weights());
        }
        catch (BadInputException exception) when (!exception.Message.StartsWith(_geometry.Path, StringComparison.Ordinal))
        {
            throw _section.Wrong("psf-kernel", exception.Message.TrimEnd('.'));
        }
    }

    private double[] Weights()
    {
        if (_section.IsList("psf-kernel"))
        {
            return _section.Numbers("psf-kernel", 1, MaxWeights)!;
        }

        if (!_geometry.MayNameFiles)
        {
            throw _section.Wrong("psf-kernel", "'psf-kernel' names a file, which is not possible here; the list of its weights is needed");
        }

        string path = Path.Combine(Path.GetDirectoryName(_geometry.Path) ?? string.Empty, _section.Text("psf-kernel")!);
        byte[] content = FileErrors.ToBadInput($"{path}: the PSF kernel can't be read", () => File.ReadAllBytes(path));
        KernelSha256 = Convert.ToHexStringLower(SHA256.HashData(content));
        return KernelImage.Parse(content, path);
    }
}
