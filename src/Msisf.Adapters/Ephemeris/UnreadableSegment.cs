using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;

namespace Msisf.Adapters.Ephemeris;

/// <summary>A segment of a type that the built-in reader does not know. Only its use is an error.</summary>
/// <param name="Body">NAIF's number.</param>
/// <param name="Center">NAIF's number.</param>
/// <param name="Interval">When its data hold.</param>
/// <param name="Reason">What it is, with the file's name.</param>
internal sealed record UnreadableSegment(int Body, int Center, TdbInterval Interval, string Reason) : IEphemerisSegment
{
    /// <inheritdoc/>
    public Vector3D ValueAt(double tdbSeconds) => throw Unreadable();

    /// <inheritdoc/>
    public Vector3D RateAt(double tdbSeconds) => throw Unreadable();

    private SpiceException Unreadable() => new($"{Reason}. Use --ephemeris cspice, or a kernel of another type.");
}
