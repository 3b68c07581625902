using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tests.Ephemeris;

/// <summary>A segment that always gives one value.</summary>
internal sealed record FixedSegment(int Body, int Center, TdbInterval Interval, Vector3D Value) : IEphemerisSegment
{
    public Vector3D ValueAt(double tdbSeconds) => Value;
}
