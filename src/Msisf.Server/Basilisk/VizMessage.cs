namespace Msisf.Server.Basilisk;

/// <summary>What Basilisk's vizInterface says of a moment: the fields of its VizMessage that an image depends on.</summary>
internal sealed record VizMessage
{
    /// <summary>s since the epoch.</summary>
    public double SimulationSeconds { get; init; }

    /// <summary>UTC, which only the first message of a simulation has; null in the others.</summary>
    public VizEpoch? Epoch { get; init; }

    /// <summary>The celestial bodies.</summary>
    public required IReadOnlyList<VizBody> Bodies { get; init; }

    public required IReadOnlyList<VizSpacecraft> Spacecraft { get; init; }

    public required IReadOnlyList<VizCamera> Cameras { get; init; }
}

/// <summary>A date and time of the calendar, UTC.</summary>
internal sealed record VizEpoch(int Year, int Month, int Day, int Hours, int Minutes, double Seconds);

/// <summary>A celestial body.</summary>
/// <param name="Position">m, in the simulation's inertial axes N.</param>
/// <param name="BodyFromInertial">The nine numbers of the matrix that turns components of N into the body's, row by row.</param>
internal sealed record VizBody(string Name, Vector3D Position, IReadOnlyList<double> BodyFromInertial);

/// <summary>A spacecraft.</summary>
/// <param name="Position">m, N.</param>
/// <param name="Attitude">Modified Rodrigues parameters of the craft's axes B relative to N.</param>
internal sealed record VizSpacecraft(string Name, Vector3D Position, Vector3D Attitude);

/// <summary>A camera.</summary>
/// <param name="Parent">Name of its spacecraft; empty for the only one.</param>
/// <param name="FieldOfViewDegrees">Vertical, from edge to edge.</param>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="Position">m, in the craft's axes B.</param>
/// <param name="Direction">Modified Rodrigues parameters of Unity's camera axes relative to B.</param>
/// <param name="RenderMode">0 for an image, 1 for a map of depths.</param>
internal sealed record VizCamera(
    long Id, string Parent, double FieldOfViewDegrees, long Width, long Height, Vector3D Position, Vector3D Direction, int RenderMode);
