namespace Msisf.Core.Render.Photometry;

/// <summary>The angles to which the reflectances of a map were normalised, degrees.</summary>
/// <param name="IncidenceDegrees">0 to below 90.</param>
/// <param name="EmissionDegrees">0 to below 90.</param>
/// <param name="PhaseDegrees">0 to 180.</param>
public readonly record struct ReferenceGeometry(double IncidenceDegrees, double EmissionDegrees, double PhaseDegrees)
{
    /// <summary>Cosine of the incidence angle.</summary>
    public double CosIncidence => Math.Cos(double.DegreesToRadians(IncidenceDegrees));

    /// <summary>Cosine of the emission angle.</summary>
    public double CosEmission => Math.Cos(double.DegreesToRadians(EmissionDegrees));

    /// <summary>sin^2 of half the phase angle.</summary>
    public double PhaseHaversine
    {
        get
        {
            double sine = Math.Sin(0.5 * double.DegreesToRadians(PhaseDegrees));
            return sine * sine;
        }
    }
}
