namespace Msisf.Core.Detector;

/// <summary>Charged particles that leave electrons along straight lines through the detector. Immutable.</summary>
public sealed record CosmicRays
{
    /// <summary>Hits per cm^2 and second; in free space some 5 (solar minimum).</summary>
    public required double Rate { get; init; }

    /// <summary>Micrometres: thickness of the layer whose electrons are collected.</summary>
    public double Thickness { get; init; } = 10.0;

    /// <summary>Electrons per micrometre of the path in silicon: 80 for a particle of minimum ionisation.</summary>
    public double ElectronsPerMicrometre { get; init; } = 80.0;
}
