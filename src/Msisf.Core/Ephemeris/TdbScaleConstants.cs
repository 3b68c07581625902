namespace Msisf.Core.Ephemeris;

/// <summary>
/// The constants of TDB - TAI = TtMinusTai + Amplitude sin E, E = M + Eccentricity sin M (leap seconds kernel, DELTET/...).
/// </summary>
/// <param name="TtMinusTai">s: DELTA_T_A.</param>
/// <param name="Amplitude">s: K.</param>
/// <param name="Eccentricity">1: EB, of the Earth's orbit.</param>
/// <param name="MeanAnomalyAtJ2000">rad: first value of M.</param>
/// <param name="MeanMotion">rad/s: second value of M.</param>
public readonly record struct TdbScaleConstants(
    double TtMinusTai,
    double Amplitude,
    double Eccentricity,
    double MeanAnomalyAtJ2000,
    double MeanMotion);
