using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// The horizon of one place, to be compared with discs: the tangent of the elevation at each column, and its limits around each group of
/// columns. Not safe for several threads.
/// </summary>
internal sealed class HorizonTable
{
    private const int Group = HorizonBuffer.Group;

    private readonly float[] _least;
    private readonly float[] _most;

    /// <summary>Makes a table.</summary>
    /// <param name="columns">Columns of a turn.</param>
    public HorizonTable(int columns)
    {
        Columns = columns;
        Tangents = new float[columns + 1];
        (_least, _most) = (new float[columns / Group], new float[columns / Group]);
    }

    /// <summary>Columns of a turn.</summary>
    public int Columns { get; }

    /// <summary>The tangent at each column; after the last one that of the first again.</summary>
    public float[] Tangents { get; }

    /// <summary>Finds the limits after <see cref="Tangents"/> was filled.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public void FindLimits()
    {
        for (int group = 0; group < _least.Length; group++)
        {
            (float least, float most) = (float.PositiveInfinity, float.NegativeInfinity);
            foreach (float tangent in Tangents.AsSpan(group * Group, Group + 1))
            {
                (least, most) = (tangent < least ? tangent : least, tangent > most ? tangent : most);
            }

            (_least[group], _most[group]) = (least, most);
        }
    }

    /// <summary>Limits of the tangents around each group.</summary>
    /// <param name="groups">How many groups to each side count too.</param>
    /// <param name="least">Receives a lower bound for each group.</param>
    /// <param name="most">Receives an upper bound.</param>
    public void Widen(int groups, float[] least, float[] most)
    {
        int mask = _least.Length - 1;
        for (int group = 0; group < _least.Length; group++)
        {
            (float low, float high) = (_least[group], _most[group]);
            for (int away = 1; away <= groups; away++)
            {
                (int left, int right) = ((group - away) & mask, (group + away) & mask);
                low = Math.Min(low, Math.Min(_least[left], _least[right]));
                high = Math.Max(high, Math.Max(_most[left], _most[right]));
            }

            (least[group], most[group]) = (low, high);
        }
    }

    /// <summary>The tangents at sixteen azimuths, straight between columns.</summary>
    /// <param name="columns">From - <see cref="Columns"/> to below twice as many.</param>
    public Vector512<float> At(Vector512<float> columns)
    {
        Vector512<float> floor = Vector512.Floor(columns);
        Vector512<int> index = Vector512.ConvertToInt32(floor) & Vector512.Create(Columns - 1);
        Vector512<float> left = Gather(Tangents, index);
        Vector512<float> right = Gather(Tangents, index + Vector512<int>.One);
        return left + ((columns - floor) * (right - left));
    }

    /// <summary>Elements of a table.</summary>
    /// <param name="from">The table.</param>
    /// <param name="index">Their indices, all within it.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<float> Gather(float[] from, Vector512<int> index)
    {
        ref float start = ref MemoryMarshal.GetArrayDataReference(from);
        Vector256<int> lower = index.GetLower();
        Vector256<int> upper = index.GetUpper();
        return Vector512.Create(
            Vector256.Create(Four(ref start, lower.GetLower()), Four(ref start, lower.GetUpper())),
            Vector256.Create(Four(ref start, upper.GetLower()), Four(ref start, upper.GetUpper())));

        static Vector128<float> Four(ref float start, Vector128<int> at) => Vector128.Create(
            Unsafe.Add(ref start, at[0]), Unsafe.Add(ref start, at[1]), Unsafe.Add(ref start, at[2]), Unsafe.Add(ref start, at[3]));
    }
}
