using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// The least tangent of a horizon in windows around each column: an edge whose higher end is not above it can't rise above the horizon.
/// Not safe for several threads.
/// </summary>
/// <param name="columns">Columns of a turn.</param>
internal sealed class HorizonWindows(int columns)
{
    /// <summary>Columns to each side of the smallest window.</summary>
    private const int Least = 4;

    /// <summary>Columns to each side of the largest window.</summary>
    private const int Most = 32;

    private readonly float[][] _windows = [new float[columns], new float[columns], new float[columns], new float[columns]];
    private readonly float[] _running = new float[columns + (4 * Most)];

    /// <summary>Takes a horizon; what rises above it later only makes the windows lower than they could be.</summary>
    /// <param name="tangents">Tangents of the elevation at the columns.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void Take(ReadOnlySpan<float> tangents)
    {
        const int Lanes = 16;
        const int Edge = 2 * Most;
        tangents[^Edge..].CopyTo(_running);
        tangents.CopyTo(_running.AsSpan(Edge));
        tangents[..Edge].CopyTo(_running.AsSpan(Edge + columns));
        for (int length = 1, side = Least; side <= Most; length *= 2)
        {
            // Twice as many columns from each one on.
            for (int at = 0; at + length + Lanes <= _running.Length; at += Lanes)
            {
                Vector512.MinNative(ArrayLanes.Load(_running, at), ArrayLanes.Load(_running, at + length))
                    .StoreTo(_running, at);
            }

            if (length == side)
            {
                float[] window = _windows[int.Log2(side / Least)];
                for (int at = 0; at < columns; at += Lanes)
                {
                    int from = at + Edge - side;
                    Vector512.MinNative(ArrayLanes.Load(_running, from), ArrayLanes.Load(_running, from + 1))
                        .StoreTo(window, at);
                }

                side *= 2;
            }
        }
    }

    /// <summary>The least tangents around columns for edges of a width; null if that is too much.</summary>
    /// <param name="width">Columns from one end of an edge to the other.</param>
    public float[]? For(float width)
    {
        const float Rounding = 2.0f; // of the end to a column, and of the columns that the edge is drawn beyond its ends
        int window = 0;
        for (int side = Least; side <= Most; side *= 2, window++)
        {
            if (width + Rounding <= side)
            {
                return _windows[window];
            }
        }

        return null;
    }
}
