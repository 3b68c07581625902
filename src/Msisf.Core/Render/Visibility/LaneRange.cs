using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>The limits of many numbers that come eight at a time.</summary>
internal struct LaneRange
{
    private Vector512<double> _min;
    private Vector512<double> _max;

    public static LaneRange Nothing => new()
    {
        _min = Vector512.Create(double.PositiveInfinity),
        _max = Vector512.Create(double.NegativeInfinity),
    };

    public readonly double Min
    {
        get
        {
            double min = _min[0];
            for (int lane = 1; lane < Vector512<double>.Count; lane++)
            {
                min = Math.Min(min, _min[lane]);
            }

            return min;
        }
    }

    public readonly double Max
    {
        get
        {
            double max = _max[0];
            for (int lane = 1; lane < Vector512<double>.Count; lane++)
            {
                max = Math.Max(max, _max[lane]);
            }

            return max;
        }
    }

    public readonly double Middle => 0.5 * (Min + Max);

    public readonly double Width => Max - Min;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Widen(Vector512<double> by)
    {
        _min = Vector512.MinNative(_min, by);
        _max = Vector512.MaxNative(_max, by);
    }
}
