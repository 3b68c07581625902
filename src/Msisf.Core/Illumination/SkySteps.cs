using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// Tells the steps at which a body is wholly over the horizon of a place from those at which the horizon is so near that strips of its disc
/// must tell. Not safe for several threads.
/// </summary>
/// <param name="times">Where the body is.</param>
/// <param name="columns">Columns of a turn of horizons.</param>
/// <param name="steepest">Tangent of the greatest elevation of a horizon.</param>
internal sealed class SkySteps(LightTimes times, int columns, double steepest)
{
    private const int Lanes = LightTimes.Lanes;

    private readonly SkyLimits _limits = new(columns);
    private readonly float[] _tangents = new float[times.X.Length];
    private readonly float[] _columns = new float[times.X.Length];
    private readonly int[] _near = new int[times.X.Length + Lanes];

    /// <summary>The body's path.</summary>
    public SkyPath Path { get; } = new(times, columns, steepest);

    /// <summary>For each sixteen steps those at which the body is wholly in view, the first in the lowest bit.</summary>
    public uint[] Whole { get; } = new uint[times.X.Length / Lanes];

    /// <summary>The steps at which the horizon is near the body; the last one is repeated to fill the lanes.</summary>
    public ReadOnlySpan<int> Near => _near.AsSpan(0, NearCount);

    /// <summary>Number of <see cref="Near"/>.</summary>
    public int NearCount { get; private set; }

    /// <summary>Finds the steps of a place.</summary>
    /// <param name="table">Its horizon.</param>
    /// <param name="frame">The place.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Find(HorizonTable table, in LocalFrame frame)
    {
        _limits.Find(table, times);
        SkyShift shift = Path.MoveTo(frame);
        int near = 0;
        for (int step = 0; step < times.Count; step += Lanes)
        {
            uint valid = (1u << Math.Min(Lanes, times.Count - step)) - 1;
            (uint whole, uint open) = _limits.Compare(Path.BoxAt(step, shift));
            if (open != 0)
            {
                SeenBody seen = Path.At(step, shift);
                (whole, open) = _limits.Compare(seen);
                seen.Tangent.StoreTo(_tangents, step);
                seen.Column.StoreTo(_columns, step);
                for (open &= valid; open != 0; open &= open - 1)
                {
                    _near[near++] = step + BitOperations.TrailingZeroCount(open);
                }
            }

            Whole[step / Lanes] = whole & valid;
        }

        NearCount = near;
        _near.AsSpan(near, Lanes).Fill(near > 0 ? _near[near - 1] : 0);
    }

    /// <summary>The body at sixteen of the steps at which the horizon is near; after the last one it comes again.</summary>
    /// <param name="first">Which of them is the first.</param>
    public SeenBody NearAt(int first)
    {
        Vector512<int> steps = StepsAt(first);
        return Path.SeenAt(
            HorizonTable.Gather(_tangents, steps), HorizonTable.Gather(_columns, steps), HorizonTable.Gather(times.Slope, steps));
    }

    /// <summary>Those sixteen steps.</summary>
    public Vector512<int> StepsAt(int first) => ArrayLanes.Load(_near, first);
}
