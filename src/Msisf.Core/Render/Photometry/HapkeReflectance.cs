using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Photometry;

/// <summary>Hapke's law (Theory of Reflectance and Emittance Spectroscopy, 2nd ed., 2012, eq. 12.55 with K = 1 and B_C0 = 0).</summary>
public sealed class HapkeReflectance : IReflectance, IEnclosedLaw
{
    private readonly double _scale;
    private readonly double _w;
    private readonly double _r0;
    private readonly double _b;
    private readonly double _backward;
    private readonly double _forward;
    private readonly double _surgeAmplitude;
    private readonly double _surgeWidth;
    private readonly HapkeRoughness _roughness;
    private readonly HapkeLanes _lanes;
    private readonly HapkeEnclosure _enclosure;

    /// <summary>Makes the law with the brightness that follows from its parameters.</summary>
    public HapkeReflectance(HapkeParameters parameters)
        : this(parameters, scale: 1.0)
    {
    }

    private HapkeReflectance(HapkeParameters parameters, double scale)
    {
        double gamma = Math.Sqrt(1.0 - parameters.SingleScatteringAlbedo);
        double lobe = 0.5 * (1.0 - (parameters.LobeWidth * parameters.LobeWidth));
        _scale = scale;
        _w = parameters.SingleScatteringAlbedo;
        _r0 = (1.0 - gamma) / (1.0 + gamma);
        _b = parameters.LobeWidth;
        _backward = lobe * (1.0 + parameters.BackwardWeight);
        _forward = lobe * (1.0 - parameters.BackwardWeight);
        _surgeAmplitude = parameters.SurgeAmplitude;
        _surgeWidth = parameters.SurgeWidth;
        _roughness = new HapkeRoughness(double.DegreesToRadians(parameters.MeanSlopeDegrees));
        _enclosure = new HapkeEnclosure(parameters, scale);
        _lanes = new HapkeLanes(
            Vector512.Create(scale),
            Vector512.Create(_w),
            Vector512.Create(_b),
            Vector512.Create(parameters.BackwardWeight),
            Vector512.Create(_surgeAmplitude),
            Vector512.Create(_surgeWidth),
            Vector512.Create(Math.Tan(double.DegreesToRadians(parameters.MeanSlopeDegrees))));
    }

    /// <summary>
    /// Makes the law with the shape that follows from its parameters, but with all radiance factors scaled to a given normal albedo.
    /// </summary>
    /// <param name="parameters">The parameters, with w above 0.</param>
    /// <param name="albedo">Normal albedo: I/F with the Sun and the viewer at the zenith, 0 to 1.</param>
    public static HapkeReflectance WithNormalAlbedo(HapkeParameters parameters, double albedo)
    {
        Guard.Positive(parameters.SingleScatteringAlbedo, "hapke parameter w");
        double unscaled = new HapkeReflectance(parameters).RadianceFactor(1.0, 1.0, 0.0);
        return new HapkeReflectance(parameters, Guard.InRange(albedo, 0.0, 1.0, "albedo") / unscaled);
    }

    /// <summary>The law as a user names it; a parameter that is not given has the Moon's value.</summary>
    public static ReflectanceLaw Law { get; } = new("hapke", Make)
    {
        Parameters = ["w", "b", "c", "b0", "h", "theta"],
        BrightnessParameter = "w",
    };

    /// <inheritdoc/>
    public bool DependsOnViewer => true;

    private static HapkeReflectance Make(ReflectanceValues values)
    {
        HapkeParameters moon = new();
        HapkeParameters wanted = new(
            values.Parameter("w") ?? moon.SingleScatteringAlbedo,
            values.Parameter("b") ?? moon.LobeWidth,
            values.Parameter("c") ?? moon.BackwardWeight,
            values.Parameter("b0") ?? moon.SurgeAmplitude,
            values.Parameter("h") ?? moon.SurgeWidth,
            values.Parameter("theta") ?? moon.MeanSlopeDegrees);
        return values.Parameter("w") is null ? WithNormalAlbedo(wanted, values.Albedo) : new HapkeReflectance(wanted);
    }

    /// <inheritdoc/>
    public double RadianceFactor(double cosIncidence, double cosEmission, double phaseHaversine)
    {
        RoughSurface surface = _roughness.At(cosIncidence, cosEmission, phaseHaversine);
        double surge = _surgeAmplitude * _surgeWidth / (_surgeWidth + PhaseAngle.HalfTangent(phaseHaversine));
        double single = ParticlePhase(phaseHaversine) * (1.0 + surge);
        double multiple = (MultipleScattering(surface.CosIncidence) * MultipleScattering(surface.CosEmission)) - 1.0;
        double seeliger = surface.CosIncidence / (surface.CosIncidence + surface.CosEmission);
        return _scale * 0.25 * _w * seeliger * (single + multiple) * surface.Shadowing;
    }

    Sloped IEnclosedLaw.Enclose(in Sloped cosIncidence, in Sloped cosEmission, in Sloped phaseHaversine) =>
        _enclosure.Of(in cosIncidence, in cosEmission, in phaseHaversine);

    /// <inheritdoc/>
    /// <remarks>Within 1e-12 of <see cref="RadianceFactor"/>.</remarks>
    public void RadianceFactors(
        ReadOnlySpan<double> cosIncidence, ReadOnlySpan<double> cosEmission, ReadOnlySpan<double> phaseHaversine, Span<double> factors)
    {
        Span<Vector512<double>> buffer = stackalloc Vector512<double>[HapkeLanes.BufferLength];
        int whole = cosIncidence.Length - (cosIncidence.Length % Vector512<double>.Count);
        HapkeLanes.RadianceFactors(
            _lanes, Lanes(cosIncidence[..whole]), Lanes(cosEmission[..whole]), Lanes(phaseHaversine[..whole]),
            MemoryMarshal.Cast<double, Vector512<double>>(factors[..whole]), buffer);
        if (whole == cosIncidence.Length)
        {
            return;
        }

        Span<Vector512<double>> rest = [Filled(cosIncidence[whole..]), Filled(cosEmission[whole..]), Filled(phaseHaversine[whole..])];
        Span<Vector512<double>> last = stackalloc Vector512<double>[1];
        HapkeLanes.RadianceFactors(_lanes, rest[..1], rest[1..2], rest[2..], last, buffer);
        MemoryMarshal.Cast<Vector512<double>, double>(last)[..(cosIncidence.Length - whole)].CopyTo(factors[whole..]);
    }

    private static ReadOnlySpan<Vector512<double>> Lanes(ReadOnlySpan<double> values) =>
        MemoryMarshal.Cast<double, Vector512<double>>(values);

    /// <summary>Less than eight values, and the last one again in the other lanes.</summary>
    private static Vector512<double> Filled(ReadOnlySpan<double> values)
    {
        Vector512<double> filled = Vector512.Create(values[^1]);
        values.CopyTo(MemoryMarshal.Cast<Vector512<double>, double>(new Span<Vector512<double>>(ref filled)));
        return filled;
    }

    /// <summary>Phase function of two Henyey-Greenstein lobes; 1 -+ 2 b cos g + b^2 is computed in a form without cancellation.</summary>
    private double ParticlePhase(double phaseHaversine)
    {
        double nearest = (1.0 - _b) * (1.0 - _b);
        double backward = nearest + (4.0 * _b * phaseHaversine);
        double forward = nearest + (4.0 * _b * (1.0 - phaseHaversine));
        return (_backward / (backward * Math.Sqrt(backward))) + (_forward / (forward * Math.Sqrt(forward)));
    }

    /// <summary>
    /// The function H(x) of multiple scattering (Hapke, Icarus 157 (2002), p. 523), within 1 % of Chandrasekhar's function.
    /// </summary>
    private double MultipleScattering(double x) =>
        1.0 / (1.0 - (_w * x * (_r0 + ((0.5 - (_r0 * x)) * Math.Log((1.0 + x) / x)))));
}
