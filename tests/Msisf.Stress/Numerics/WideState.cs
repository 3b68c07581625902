using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Terrain;

namespace Msisf.Stress.Numerics;

/// <summary>What a state vector says of its orbit without angles, in double-double; the state is taken as exact.</summary>
internal sealed class WideState
{
    public WideState(StateVector state)
    {
        WideVector position = WideVector.Of(state.Position);
        WideVector velocity = WideVector.Of(state.Velocity);
        DoubleDouble one = WideMath.Of(1.0);
        DoubleDouble mu = WideMath.Of(MoonConstants.GravitationalParameter);
        DoubleDouble distance = position.Length;
        WideVector momentum = WideVector.Cross(position, velocity);
        Normal = momentum.Normalized;
        EccentricityVector = (WideMath.Divide(one, mu) * WideVector.Cross(velocity, momentum))
            + (WideMath.Negate(WideMath.Divide(one, distance)) * position);
        DoubleDouble kineticRatio = WideMath.Divide(distance * WideVector.Dot(velocity, velocity), mu);
        SemiMajorAxis = WideMath.Divide(distance, WideMath.Subtract(WideMath.Of(2.0), kineticRatio));
    }

    /// <summary>m.</summary>
    public DoubleDouble SemiMajorAxis { get; }

    /// <summary>Of the orbit's plane, length 1.</summary>
    public WideVector Normal { get; }

    /// <summary>Towards the periapsis, as long as the eccentricity.</summary>
    public WideVector EccentricityVector { get; }
}
