using FsCheck;
using FsCheck.Fluent;

namespace Msisf.Core.Tests.Render.Photometry;

/// <summary>Random directions of Sun and viewer, many of them near the zenith, the horizon, opposition and the plane of both.</summary>
internal static class Geometries
{
    public static readonly Config Seeded = Config.QuickThrowOnFailure.WithMaxTest(3000).WithReplay(20120222UL, 1UL);

    private static readonly Gen<double> Cosines = Gen.OneOf(
        Gen.Choose(1, 1_000_000).Select(i => i * 1e-6),
        Gen.Choose(0, 300).Select(i => Math.Pow(10.0, -i)),
        Gen.Choose(0, 16).Select(i => 1.0 - Math.Pow(10.0, -i - 0.5)));

    private static readonly Gen<double> AzimuthHaversines = Gen.OneOf(
        Gen.Choose(0, 1_000_000).Select(i => i * 1e-6),
        Gen.Choose(0, 30).Select(i => Math.Pow(10.0, -i)),
        Gen.Choose(0, 16).Select(i => 1.0 - Math.Pow(10.0, -i)));

    /// <summary>Cosine of incidence, of emission, haversine of phase.</summary>
    public static Arbitrary<(double CosIncidence, double CosEmission, double PhaseHaversine)> Any { get; } =
        (from i in Cosines
         from e in Cosines
         from azimuth in AzimuthHaversines
         select (i, e, PhaseHaversine(i, e, azimuth))).ToArbitrary();

    /// <summary>The law of haversines, rounded into [0, 1] as a renderer's own is.</summary>
    private static double PhaseHaversine(double cosIncidence, double cosEmission, double azimuthHaversine)
    {
        double product = Math.Sqrt((1.0 - (cosIncidence * cosIncidence)) * (1.0 - (cosEmission * cosEmission)));
        return Math.Clamp((0.5 * (1.0 - (cosIncidence * cosEmission) - product)) + (product * azimuthHaversine), 0.0, 1.0);
    }
}
