using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>What a DAF file says about one of its segments.</summary>
/// <param name="Interval">When the segment's data hold; of a CK ticks of the spacecraft's clock.</param>
/// <param name="Integers">
/// SPK: target, centre, frame, type, first and last address. PCK: body, frame, type, first and last address. CK: instrument, frame, type,
/// whether there are rates, first and last address.
/// </param>
public sealed record DafSummary(TdbInterval Interval, IReadOnlyList<int> Integers)
{
    /// <summary>Address of the segment's first double, from 1.</summary>
    public int FirstAddress => Integers[^2];

    /// <summary>Address of the segment's last double, from 1.</summary>
    public int LastAddress => Integers[^1];
}
