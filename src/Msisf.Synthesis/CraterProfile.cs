using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Synthesis;

/// <summary>
/// Height over the distance from a crater's centre: a parabolic bowl (a flat floor and parabolic walls above 15 km), ejecta whose
/// thickness falls with the third power of the distance, and a crest that is rounder for older craters.
/// </summary>
/// <remarks>
/// Depth, rim height and floor of fresh craters: R. J. Pike, "Size-dependence in the shape of fresh impact craters on the Moon", in: Impact
/// and Explosion Cratering (1977), 489-509. Ejecta: T. R. McGetchin et al., EPSL 20 (1973), 226.
/// </remarks>
internal readonly struct CraterProfile
{
    private const double SimpleToComplexKm = 15.0;

    // By how much less the crest of a new crater is rounded than that of an old one, in depths.
    private const double RoundRim = 0.55;
    private const double SharpRim = 0.67;
    private const double EjectaAtReach = 1.0 / (Crater.Reach * Crater.Reach * Crater.Reach);
    private const double InnermostEjectaSquare = 0.25; // radii squared; farther in the bowl is lower than any ejecta

    private readonly double _floorDepth;
    private readonly double _wallHeight;
    private readonly double _floorSquare;
    private readonly double _rimHeight;
    private readonly double _rounding;

    /// <summary>The profile of a crater.</summary>
    /// <param name="crater">The crater.</param>
    /// <param name="isSharp">Whether the rim of a fresh crater is sharp; those of synthetic models stay as round as they were.</param>
    public CraterProfile(Crater crater, bool isSharp = false)
    {
        double diameterKm = 2e-3 * crater.Radius;
        bool simple = diameterKm < SimpleToComplexKm;
        double depth = 1000.0 * crater.Freshness
            * (simple ? 0.196 * PortableMath.Pow(diameterKm, 1.010) : 1.044 * PortableMath.Pow(diameterKm, 0.301));
        double floor = simple ? 0.0 : 0.187 * PortableMath.Pow(diameterKm, 0.249);
        _rimHeight = 1000.0 * crater.Freshness
            * (simple ? 0.036 * PortableMath.Pow(diameterKm, 1.014) : 0.236 * PortableMath.Pow(diameterKm, 0.399));
        _floorSquare = floor * floor;
        _floorDepth = depth - _rimHeight;
        _wallHeight = depth / (1.0 - _floorSquare);
        _rounding = depth * (0.7 - ((isSharp ? SharpRim : RoundRim) * crater.Freshness));
    }

    /// <summary>Height over the ground before the impact, m, at four distances.</summary>
    /// <param name="square">Square of the distance in rim radii.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<double> HeightAt(Vector256<double> square)
    {
        Vector256<double> wall = Vector256.Max(square - Vector256.Create(_floorSquare), Vector256<double>.Zero);
        Vector256<double> bowl = (wall * _wallHeight) - Vector256.Create(_floorDepth);
        Vector256<double> outer = Vector256.Max(square, Vector256.Create(InnermostEjectaSquare));
        Vector256<double> thinning = Vector256<double>.One / (outer * Vector256.Sqrt(outer));
        Vector256<double> ejecta = Vector256.Max(thinning - Vector256.Create(EjectaAtReach), Vector256<double>.Zero)
            * (_rimHeight / (1.0 - EjectaAtReach));

        // The lower of bowl and ejecta, with the crest between them rounded.
        Vector256<double> near = Vector256.Max(Vector256.Create(_rounding) - Vector256.Abs(bowl - ejecta), Vector256<double>.Zero);
        return Vector256.Min(bowl, ejecta) - (near * near * (0.25 / _rounding));
    }
}
