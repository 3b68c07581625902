using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// The horizon of one place, to be compared with discs: the tangent of the elevation at each column, and its limits around each group of
/// columns. Not safe for several threads.
/// </summary>
internal sealed class HorizonTable
{
    private const int Group = HorizonBuffer.Group;

    /// <summary>Groups that may count on each side of one.</summary>
    public const int Edge = 32;

    private readonly float[] _least;
    private readonly float[] _most;

    /// <summary>Makes a table.</summary>
    /// <param name="columns">Columns of a turn.</param>
    public HorizonTable(int columns)
    {
        Columns = columns;
        Tangents = new float[HorizonProfile.TableLength(columns)];
        int groups = columns / Group;
        (_least, _most) = (new float[groups + (4 * Edge)], new float[groups + (4 * Edge)]);
    }

    /// <summary>Columns of a turn.</summary>
    public int Columns { get; }

    /// <summary>The tangent at each column; after the last one that of the first again, and then what means nothing.</summary>
    public float[] Tangents { get; }

    /// <summary>The greatest tangent.</summary>
    public float Highest { get; private set; }

    /// <summary>The least tangent.</summary>
    public float Lowest { get; private set; }

    /// <summary>Finds the limits after <see cref="Tangents"/> was filled.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void FindLimits()
    {
        int groups = Columns / Group;
        Vector512<float> lowest = Vector512.Create(float.PositiveInfinity);
        Vector512<float> highest = -lowest;
        for (int group = 0; group < groups; group++)
        {
            int from = group * Group;
            Vector512<float> first = ArrayLanes.Load(Tangents, from);
            Vector512<float> second = ArrayLanes.Load(Tangents, from + Vector512<float>.Count);
            float next = Tangents[from + Group];
            _least[Edge + group] = Math.Min(next, LaneMasks.Min(Vector512.MinNative(first, second)));
            _most[Edge + group] = Math.Max(next, LaneMasks.Max(Vector512.MaxNative(first, second)));
            lowest = Vector512.MinNative(lowest, Vector512.MinNative(first, second));
            highest = Vector512.MaxNative(highest, Vector512.MaxNative(first, second));
        }

        (Lowest, Highest) = (LaneMasks.Min(lowest), LaneMasks.Max(highest));
        foreach (float[] limits in (float[][])[_least, _most])
        {
            limits.AsSpan(groups, Edge).CopyTo(limits);
            for (int group = Edge + groups; group < limits.Length; group++)
            {
                limits[group] = limits[group - groups];
            }
        }
    }

    /// <summary>Limits of the tangents around each group.</summary>
    /// <param name="groups">How many groups to each side count too, at most <see cref="Edge"/>.</param>
    /// <param name="least">Receives a lower bound for each group, and then those of the first ones again.</param>
    /// <param name="most">Receives an upper bound.</param>
    public void Widen(int groups, float[] least, float[] most)
    {
        for (int group = 0; group < least.Length; group += Vector512<float>.Count)
        {
            int from = group + Edge - groups;
            Vector512<float> low = ArrayLanes.Load(_least, from);
            Vector512<float> high = ArrayLanes.Load(_most, from);
            for (int away = 1; away <= 2 * groups; away++)
            {
                low = Vector512.MinNative(low, ArrayLanes.Load(_least, from + away));
                high = Vector512.MaxNative(high, ArrayLanes.Load(_most, from + away));
            }

            low.StoreTo(least, group);
            high.StoreTo(most, group);
        }
    }

    /// <summary>The tangents at sixteen azimuths, straight between columns.</summary>
    /// <param name="columns">From - <see cref="Columns"/> to below twice as many.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> At(Vector512<float> columns)
    {
        Vector512<float> floor = Vector512.Floor(columns);
        Vector512<int> index = Vector512.ConvertToInt32(floor) & Vector512.Create(Columns - 1);
        float[] tangents = Tangents;
        Vector512<float> first = Eight(tangents, index.GetLower());
        Vector512<float> second = Eight(tangents, index.GetUpper());
        Vector512<float> left = Vector512.Create(first.GetLower(), second.GetLower());
        Vector512<float> right = Vector512.Create(first.GetUpper(), second.GetUpper());
        return left + ((columns - floor) * (right - left));

        // A column and the next one are read at once: eight columns, and then the next ones.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static Vector512<float> Eight(float[] tangents, Vector256<int> at)
        {
            Vector512<double> pairs = Vector512.Create(Four(tangents, at.GetLower()), Four(tangents, at.GetUpper()));
            return Vector512.Shuffle(pairs.AsSingle(), Vector512.Create(0, 2, 4, 6, 8, 10, 12, 14, 1, 3, 5, 7, 9, 11, 13, 15));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static Vector256<double> Four(float[] tangents, Vector128<int> at) => Vector256.Create(
            Vector128.Create(PairAt(tangents, at[0]), PairAt(tangents, at[1])),
            Vector128.Create(PairAt(tangents, at[2]), PairAt(tangents, at[3])));

        static double PairAt(float[] tangents, int at)
        {
            Debug.Assert(at + 1 < tangents.Length, "A column has no next one.");
            return Unsafe.As<float, double>(ref ArrayLanes.At(tangents, at));
        }
    }

    /// <summary>Elements of a table.</summary>
    /// <param name="from">The table.</param>
    /// <param name="index">Their indices, all within it.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<float> Gather(float[] from, Vector512<int> index)
    {
        Vector256<int> lower = index.GetLower();
        Vector256<int> upper = index.GetUpper();
        return Vector512.Create(
            Vector256.Create(Four(from, lower.GetLower()), Four(from, lower.GetUpper())),
            Vector256.Create(Four(from, upper.GetLower()), Four(from, upper.GetUpper())));

        static Vector128<float> Four(float[] from, Vector128<int> at) => Vector128.Create(
            ArrayLanes.At(from, at[0]), ArrayLanes.At(from, at[1]), ArrayLanes.At(from, at[2]), ArrayLanes.At(from, at[3]));
    }
}
