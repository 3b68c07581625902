using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tests.Ephemeris;

/// <summary>A segment that always gives one value, and a rate that need not fit it.</summary>
internal sealed record FixedSegment(int Body, int Center, TdbInterval Interval, Vector3D Value, Vector3D Rate = default) : IEphemerisSegment
{
    public Vector3D RateAt(double tdbSeconds) => Rate;

    public Vector3D ValueAt(double tdbSeconds) => Value;
}
