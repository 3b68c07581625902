namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Hapke's law (<see cref="HapkeReflectance"/>) with its correction for roughness (<see cref="HapkeRoughness"/>) in intervals. What
/// depends on one number only is enclosed by its slope, which nearly always has one sign.
/// </summary>
/// <param name="parameters">The law's.</param>
/// <param name="scale">By what its radiance factors are multiplied.</param>
internal sealed class HapkeEnclosure(HapkeParameters parameters, double scale)
{
    private readonly double _w = parameters.SingleScatteringAlbedo;
    private readonly double _b = parameters.LobeWidth;
    private readonly double _r0 =
        (1.0 - Math.Sqrt(1.0 - parameters.SingleScatteringAlbedo)) / (1.0 + Math.Sqrt(1.0 - parameters.SingleScatteringAlbedo));
    private readonly double _tangent = Math.Tan(double.DegreesToRadians(parameters.MeanSlopeDegrees));
    private readonly double _chi =
        1.0 / Math.Sqrt(1.0 + (Math.PI * Math.Pow(Math.Tan(double.DegreesToRadians(parameters.MeanSlopeDegrees)), 2.0)));

    /// <inheritdoc cref="IEnclosedLaw.Enclose"/>
    public Sloped Of(in Sloped cosIncidence, in Sloped cosEmission, in Sloped phaseHaversine)
    {
        Interval phase = phaseHaversine.Value;
        Sloped tangent = phaseHaversine.Then(
            PhaseAngle.HalfTangent, 0.5 * Power(phase, -0.5) * Power(new Interval(1.0 - phase.High, 1.0 - phase.Low), -1.5));
        Sloped surge = parameters.SurgeAmplitude * parameters.SurgeWidth / (parameters.SurgeWidth + tangent);
        (Sloped incidence, Sloped emission, Sloped shadowing) = Roughened(in cosIncidence, in cosEmission, in phaseHaversine);
        Sloped multiple = (MultipleScattering(in incidence) * MultipleScattering(in emission)) - 1.0;
        Sloped seeliger = 1.0 / (1.0 + (emission / incidence)); // each of them once
        return scale * 0.25 * _w * seeliger * ((ParticlePhase(in phaseHaversine) * (1.0 + surge)) + multiple) * shadowing;
    }

    private (Sloped Incidence, Sloped Emission, Sloped Shadowing) Roughened(
        in Sloped cosIncidence, in Sloped cosEmission, in Sloped phaseHaversine)
    {
        Sloped incidence = cosIncidence.Clamp(Tolerances.GrazingCosine, 1.0);
        Sloped emission = cosEmission.Clamp(Tolerances.GrazingCosine, 1.0);
        if (_tangent == 0.0)
        {
            return (incidence, emission, 1.0);
        }

        Slant sun = SlantOf(in incidence);
        Slant viewer = SlantOf(in emission);
        Sloped sines = sun.Sine * viewer.Sine;
        Sloped azimuth = sines.Value.Low > 0.0
            ? (0.5 + ((phaseHaversine - 0.5 + (0.5 * (incidence * emission))) / sines)).Clamp(0.0, 1.0)
            : new Sloped(new Interval(0.0, 1.0), Interval.Everything, Interval.Everything, Interval.Everything);
        if (incidence.Value.High < emission.Value.Low)
        {
            return Lowered(in sun, in viewer, in azimuth, isSunLower: true);
        }

        (Sloped Incidence, Sloped Emission, Sloped Shadowing) higher = Lowered(in viewer, in sun, in azimuth, isSunLower: false);
        if (emission.Value.High < incidence.Value.Low)
        {
            return higher;
        }

        (Sloped Incidence, Sloped Emission, Sloped Shadowing) lower = Lowered(in sun, in viewer, in azimuth, isSunLower: true);
        return (
            lower.Incidence.Hull(higher.Incidence), lower.Emission.Hull(higher.Emission), lower.Shadowing.Hull(higher.Shadowing));
    }

    /// <summary>The formulas for the direction that is nearer to the horizon.</summary>
    private (Sloped Incidence, Sloped Emission, Sloped Shadowing) Lowered(
        in Slant lower, in Slant upper, in Sloped azimuthHaversine, bool isSunLower)
    {
        Interval haversine = azimuthHaversine.Value;
        Interval rest = new(1.0 - haversine.High, 1.0 - haversine.Low);
        Sloped azimuth = azimuthHaversine.Then(
            static h => PhaseAngle.FromHaversine(h) / Math.PI, 1.0 / Math.PI * Power(haversine, -0.5) * Power(rest, -0.5));
        Sloped hidden = azimuthHaversine.Then(static h => Math.Exp(-2.0 * PhaseAngle.HalfTangent(h)), SlopeOfHidden(haversine, rest));
        Sloped below = _tangent / ((1.0 - lower.E1) + (1.0 - (azimuth * upper.E1)));
        Sloped lowerEffective = _chi * (lower.Cosine + (lower.Sine * below * (lower.E2 - (azimuthHaversine * upper.E2))));
        Sloped upperEffective = _chi * (upper.Cosine
            + (upper.Sine * below * (((1.0 - (2.0 * azimuthHaversine)) * lower.E2) + (azimuthHaversine * upper.E2))));
        Sloped incidence = Positive(isSunLower ? lowerEffective : upperEffective);
        Sloped emission = Positive(isSunLower ? upperEffective : lowerEffective);
        (Slant sun, Slant viewer) = isSunLower ? (lower, upper) : (upper, lower);
        Sloped shadowing = emission / viewer.Eta * (sun.Cosine / sun.Eta) * _chi
            / (1.0 - (hidden * (1.0 - (_chi * (upper.Cosine / upper.Eta)))));
        return (incidence, emission, shadowing);
    }

    /// <summary>Effective cosines are above 0 where their enclosures may not be.</summary>
    private static Sloped Positive(in Sloped effective) =>
        effective.Value.Low > 0.0 ? effective : effective.Clamp(Tolerances.GrazingCosine, 2.0);

    /// <summary>
    /// The slope of exp(-2 tan(psi/2)) by the haversine of psi. With t = tan(psi/2) it is -(1 + t^2)^1.5 exp(-2 t) / sin(psi/2), and
    /// (1 + t^2)^1.5 is at most (1 + t)^3.
    /// </summary>
    private static Interval SlopeOfHidden(Interval haversine, Interval rest)
    {
        Interval tangent = new(PhaseAngle.HalfTangent(haversine.Low), PhaseAngle.HalfTangent(haversine.High));
        Interval steep = Power(rest, -1.5) * new Interval(Math.Exp(-2.0 * tangent.High), Math.Exp(-2.0 * tangent.Low));
        double greatest = Math.Max(0.5, tangent.Low);
        double limit = Math.Pow(1.0 + greatest, 3.0) * Math.Exp(-2.0 * greatest);
        return -(Power(haversine, -0.5) * new Interval(Math.Min(steep.Low, limit), Math.Min(steep.High, limit)));
    }

    private Slant SlantOf(in Sloped cosine)
    {
        Interval c = cosine.Value;
        Interval square = new((1.0 - c.High) * (1.0 + c.High), (1.0 - c.Low) * (1.0 + c.Low));
        Interval sine = Power(square, 0.5);
        Interval cotangents = new(c.Low / sine.High, c.High / sine.Low);
        double k = 1.0 / _tangent;
        Interval x = k * cotangents;
        Interval slopeOfX = k * Power(square, -1.5);

        // E1 = exp(-2 x / pi): its slope is at most that of y^3 exp(-k1 (y - 1)), y = 1 / sine.
        double k1 = 2.0 / Math.PI * k;
        Interval e1 = new(Math.Exp(-2.0 / Math.PI * x.High), Math.Exp(-2.0 / Math.PI * x.Low));
        double y = Math.Max(1.0 / sine.High, 3.0 / k1);
        Interval slopeOfE1 = -Least(2.0 / Math.PI * slopeOfX * e1, k1 * y * y * y * Math.Exp(-k1 * (y - 1.0)));

        // E2 = exp(-x^2 / pi): the same with y^4 exp(-k2 (y^2 - 1)).
        double k2 = k * k / Math.PI;
        Interval e2 = new(Math.Exp(-x.High * x.High / Math.PI), Math.Exp(-x.Low * x.Low / Math.PI));
        double z = Math.Max(1.0 / square.High, 2.0 / k2);
        Interval slopeOfE2 = -Least(2.0 / Math.PI * (x * slopeOfX * e2), 2.0 * k2 * z * z * Math.Exp(-k2 * (z - 1.0)));

        // cot E2 = u exp(-u^2 / pi) / k with u = k cot, which is greatest at u^2 = pi / 2.
        double turn = Math.Clamp(Math.Sqrt(Math.PI / 2.0), x.Low, x.High);
        Interval cotangentE2 = 1.0 / k * new Interval(Math.Min(Damped(x.Low), Damped(x.High)), Damped(turn));
        Interval over = 1.0 / (1.0 + (1.0 - e1));
        Interval etaSlope = _chi
            * (1.0 - (_tangent * ((cotangentE2 * over) - (sine * ((slopeOfE2 * over) + (e2 * slopeOfE1 * over * over))))));
        return new Slant(
            cosine,
            cosine.Then(SineOf, -cotangents),
            cosine.Then(E1Of, slopeOfE1),
            cosine.Then(E2Of, slopeOfE2),
            cosine.Then(c => _chi * (c + (SineOf(c) * _tangent * E2Of(c) / (2.0 - E1Of(c)))), etaSlope));

        static double SineOf(double c) => Math.Sqrt((1.0 - c) * (1.0 + c));

        double E1Of(double c) => Math.Exp(-2.0 / Math.PI * k * c / SineOf(c));

        double E2Of(double c) => Math.Exp(-k2 * c * c / ((1.0 - c) * (1.0 + c)));

        static double Damped(double u) => double.IsInfinity(u) ? 0.0 : u * Math.Exp(-u * u / Math.PI);
    }

    private Sloped ParticlePhase(in Sloped phaseHaversine)
    {
        double lobe = 0.5 * (1.0 - (_b * _b));
        double nearest = (1.0 - _b) * (1.0 - _b);
        Sloped backward = nearest + (4.0 * _b * phaseHaversine);
        Sloped forward = nearest + (4.0 * _b * (1.0 - phaseHaversine));
        return (lobe * (1.0 + parameters.BackwardWeight) * ToMinusThreeHalves(in backward))
            + (lobe * (1.0 - parameters.BackwardWeight) * ToMinusThreeHalves(in forward));

        static Sloped ToMinusThreeHalves(in Sloped x) => x.Then(Power(x.Value, -1.5), -1.5 * Power(x.Value, -2.5));
    }

    private Sloped MultipleScattering(in Sloped x)
    {
        Interval at = x.Value;
        Interval log = new(Math.Log((1.0 + at.High) / at.High), Math.Log((1.0 + at.Low) / at.Low));
        Interval half = 0.5 - (_r0 * at);
        Interval h = 1.0 / (1.0 - (_w * (at * (_r0 + (half * log)))));
        Interval slope = _w * (_r0 + (half * log) - (_r0 * (at * log)) - (half / (1.0 + at)));
        return x.Then(
            c => 1.0 / (1.0 - (_w * c * (_r0 + ((0.5 - (_r0 * c)) * Math.Log((1.0 + c) / c))))), h * h * slope);
    }

    private static Interval Least(Interval slope, double limit) => new(Math.Min(slope.Low, limit), Math.Min(slope.High, limit));

    /// <summary>A power of numbers from 0 on.</summary>
    private static Interval Power(Interval x, double exponent)
    {
        (double low, double high) = (Math.Pow(Math.Max(0.0, x.Low), exponent), Math.Pow(Math.Max(0.0, x.High), exponent));
        return exponent > 0.0 ? new Interval(low, high) : new Interval(high, low);
    }

    /// <summary>The values of one direction that the formulas use; Eta is its effective cosine at azimuth 0.</summary>
    private readonly record struct Slant(Sloped Cosine, Sloped Sine, Sloped E1, Sloped E2, Sloped Eta);
}
