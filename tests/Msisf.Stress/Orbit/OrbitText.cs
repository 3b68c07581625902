using System.Globalization;
using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;

namespace Msisf.Stress.Orbit;

/// <summary>Orbits as the command line takes them, to the last digit.</summary>
internal static class OrbitText
{
    /// <summary>As for --kepler-set.</summary>
    public static string Of(KeplerElements elements) => string.Create(
        CultureInfo.InvariantCulture,
        $"{{{elements.SemiMajorAxis:R},{elements.Eccentricity:R},{elements.ArgumentOfPeriapsis:R},"
            + $"{elements.LongitudeOfAscendingNode:R},{elements.Inclination:R},{elements.MeanAnomalyAtEpoch:R}}}");

    /// <summary>As for --state-vectors.</summary>
    public static string Of(StateVector state) => string.Create(
        CultureInfo.InvariantCulture,
        $"{{{state.Position.X:R},{state.Position.Y:R},{state.Position.Z:R},"
            + $"{state.Velocity.X:R},{state.Velocity.Y:R},{state.Velocity.Z:R}}}");
}
