using Msisf.Core.Ephemeris;
using Msisf.Core.Orbit;
using Msisf.Core.Terrain;

namespace Msisf.Stress.Reference;

/// <summary>What a state vector says of its orbit without angles, to some 30 digits; the state is taken as exact.</summary>
internal sealed class PreciseState
{
    public PreciseState(StateVector state)
    {
        PreciseVector position = PreciseVector.From(state.Position);
        PreciseVector velocity = PreciseVector.From(state.Velocity);
        DoubleWord mu = MoonConstants.GravitationalParameter;
        DoubleWord distance = position.Length;
        PreciseVector momentum = PreciseVector.Cross(position, velocity);
        Normal = momentum.Normalized();
        EccentricityVector = (1.0 / mu * PreciseVector.Cross(velocity, momentum)) - position.Normalized();
        SemiMajorAxis = distance / (2.0 - (distance * PreciseVector.Dot(velocity, velocity) / mu));
    }

    /// <summary>m.</summary>
    public DoubleWord SemiMajorAxis { get; }

    /// <summary>Of the orbit's plane, length 1.</summary>
    public PreciseVector Normal { get; }

    /// <summary>Towards the periapsis, as long as the eccentricity.</summary>
    public PreciseVector EccentricityVector { get; }
}
