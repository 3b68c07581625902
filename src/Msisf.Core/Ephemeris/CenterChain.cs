namespace Msisf.Core.Ephemeris;

/// <summary>
/// Follows the centres of segments from one body to another, as SPICE does: to the first centre that both have in common, so that nothing
/// is lost by sums over the distance to the Sun. Safe for several threads.
/// </summary>
/// <param name="segments">Segments of the SPK kernels.</param>
internal sealed class CenterChain(SegmentTable segments)
{
    /// <summary>
    /// Maximum number of links in a chain of centres, as in SPICE (CHLEN in SPKGEO); more links mean that the chain is a ring.
    /// </summary>
    private const int MaximumLinks = 20;

    /// <summary>State of a body relative to another one, J2000; null if no kernel leads from one to the other at that time.</summary>
    /// <param name="target">NAIF's number.</param>
    /// <param name="observer">NAIF's number.</param>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    /// <returns>km, km/s.</returns>
    /// <exception cref="SpiceException">The chain of centres is a ring, or a segment can't be read.</exception>
    public StateVector? StateKm(int target, int observer, double tdbSeconds)
    {
        List<(int Body, StateVector FromTarget)> chain = [(target, default)];
        while (chain[^1].Body != observer && Next(chain[^1], target, chain.Count, tdbSeconds) is { } link)
        {
            chain.Add(link);
        }

        (int Body, StateVector FromTarget) end = (observer, default);
        for (int count = 1; ; count++)
        {
            int common = chain.FindIndex(link => link.Body == end.Body);
            if (common >= 0)
            {
                return end.FromTarget - chain[common].FromTarget;
            }

            if (Next(end, observer, count, tdbSeconds) is not { } link)
            {
                return null;
            }

            end = link;
        }
    }

    /// <summary>The next centre, with its state relative to the chain's first body, negative; null where the chain ends.</summary>
    private (int Body, StateVector FromTarget)? Next(
        (int Body, StateVector FromTarget) link, int first, int count, double tdbSeconds)
    {
        if (link.Body == SegmentTable.SolarSystemBarycenter || segments.Find(link.Body, tdbSeconds) is not { } segment)
        {
            return null;
        }

        return count <= MaximumLinks
            ? (segment.Center, link.FromTarget - segment.StateAt(tdbSeconds))
            : throw new SpiceException(Invariant(
                $"The kernels' centres lead from body {first} nowhere: {MaximumLinks} links end at none that is known. "
                    + $"Use other kernels."));
    }
}
