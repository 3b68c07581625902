using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ccsds;

/// <summary>The frames and centres of CCSDS files that can be drawn from.</summary>
internal static class CcsdsFrames
{
    private const int Earth = 399;

    private static readonly string[] InertialNames = ["EME2000", "ICRF", "GCRF", "J2000"];

    private static readonly (string Name, int NaifNumber)[] CenterNames =
        [("MOON", CelestialBody.Moon.NaifNumber), ("LUNA", CelestialBody.Moon.NaifNumber), ("EARTH", Earth)];

    /// <summary>The frames, for messages.</summary>
    public const string Frames = "EME2000, J2000, ICRF, GCRF, MOON_ME and MOON_PA are read";

    /// <summary>The centres, for messages.</summary>
    public const string Centers = "MOON, LUNA and EARTH are read";

    /// <summary>NAIF's number of a centre; null if it is another.</summary>
    public static int? Center(string name) => CenterNames.FirstOrDefault(
        known => known.Name.Equals(name, StringComparison.OrdinalIgnoreCase)) is { Name: not null } found ? found.NaifNumber : null;

    /// <summary>Looks a frame up.</summary>
    /// <param name="name">The value of REF_FRAME.</param>
    /// <param name="moonMeFromMoonPa">Reads the constant rotation from the Moon's principal axes.</param>
    /// <param name="moonMeFromFrame">The constant rotation of a frame that turns with the Moon; null for J2000's axes.</param>
    /// <returns>Whether it is known.</returns>
    public static bool TryFind(string name, Func<RotationMatrix> moonMeFromMoonPa, out RotationMatrix? moonMeFromFrame)
    {
        string plain = name.ToUpperInvariant();
        moonMeFromFrame = plain switch
        {
            "MOON_ME" or "MOON_MEAN_EARTH" => RotationMatrix.Identity,
            "MOON_PA" or "MOON_PRINCIPAL_AXES" => moonMeFromMoonPa(),
            _ => null,
        };
        return moonMeFromFrame is not null || InertialNames.Contains(plain);
    }
}
