using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Time;

namespace Msisf.Core.Tests.Ephemeris;

/// <summary>A segment that always gives one value, and a rate that need not fit it.</summary>
internal sealed record FixedSegment(int Body, int Center, TdbInterval Interval, Vector3D Value, Vector3D Rate = default) : IEphemerisSegment
{
    public Vector3D RateAt(TdbTime time) => Rate;

    public Vector3D ValueAt(TdbTime time) => Value;
}
