using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>A segment of an SPK whose data give positions and velocities together.</summary>
/// <param name="file">The kernel; must outlive the segment.</param>
internal abstract class SpkSegment(DafFile file, DafSummary summary) : IEphemerisSegment
{
    public int Body => summary.Integers[0];

    public int Center => summary.Integers[1];

    public TdbInterval Interval => summary.Interval;

    /// <summary>The segment's numbers.</summary>
    protected DafWords Words { get; } = new(file, summary);

    public Vector3D ValueAt(double tdbSeconds) => StateAt(tdbSeconds).Position;

    public Vector3D RateAt(double tdbSeconds) => StateAt(tdbSeconds).Velocity;

    public abstract StateVector StateAt(double tdbSeconds);
}
