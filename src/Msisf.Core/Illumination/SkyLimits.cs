using System.Numerics;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>The horizon's limits around the discs of a body.</summary>
internal sealed class SkyLimits(int columns)
{
    private const int Lanes = LightTimes.Lanes;

    private readonly int _groups = columns / HorizonBuffer.Group;
    private readonly float[] _least = new float[(columns / HorizonBuffer.Group) + HorizonTable.Edge];
    private readonly float[] _most = new float[(columns / HorizonBuffer.Group) + HorizonTable.Edge];
    private float _highest;
    private float _lowest;
    private bool _isWide;

    /// <summary>Takes a horizon.</summary>
    /// <param name="table">The horizon, whose limits are found.</param>
    /// <param name="body">The body, whose greatest disc counts.</param>
    public void Find(HorizonTable table, LightTimes body)
    {
        (_lowest, _highest) = (table.Lowest, table.Highest);
        double tangent = Math.Max(0.0, _highest) + (2.0 * body.MaxSlope);
        double width = 1.05 * body.MaxSlope * Math.Sqrt(1.0 + (tangent * tangent));
        int groups = (int)Math.Ceiling(width / (2.0 * Math.PI) * _groups);
        _isWide = groups > HorizonTable.Edge;
        if (!_isWide)
        {
            table.Widen(groups, _least, _most);
        }
    }

    /// <summary>The lanes whose disc is whole, and those for which the limits do not tell, from limits of all: all lanes or none.</summary>
    public (uint Full, uint Open) Compare(in SkyBox box)
    {
        const uint All = 0xFFFF;
        (float low, float high) = (box.Lowest, box.Highest);
        if (high < _lowest || low > _highest)
        {
            return (low > _highest ? All : 0, 0);
        }

        int first = (int)MathF.Floor(box.First / HorizonBuffer.Group);
        int count = (int)MathF.Floor((box.First + box.Width) / HorizonBuffer.Group) - first + 1;
        if (_isWide || count > HorizonTable.Edge)
        {
            return (0, All);
        }

        first &= _groups - 1;
        Vector512<int> lanes = Vector512<int>.Indices;
        Vector512<float> least = Vector512.Create(float.PositiveInfinity);
        Vector512<float> most = Vector512.Create(float.NegativeInfinity);
        for (int done = 0; done < count; done += Lanes)
        {
            Vector512<float> isThere = Vector512.LessThan(lanes, Vector512.Create(count - done)).AsSingle();
            Vector512<float> lower = ArrayLanes.Load(_least, first + done);
            Vector512<float> upper = ArrayLanes.Load(_most, first + done);
            least = Vector512.ConditionalSelect(isThere, Vector512.MinNative(least, lower), least);
            most = Vector512.ConditionalSelect(isThere, Vector512.MaxNative(most, upper), most);
        }

        bool isNone = !Vector512.LessThanOrEqualAny(least, Vector512.Create(high));
        bool isFull = !Vector512.GreaterThanOrEqualAny(most, Vector512.Create(low));
        return isNone ? (0, 0) : isFull ? (All, 0) : (0, All);
    }

    /// <summary>The same lane by lane.</summary>
    public (uint Full, uint Open) Compare(in SeenBody seen)
    {
        Vector512<int> group = Vector512.ShiftRightArithmetic(
            Vector512.ConvertToInt32(Vector512.Floor(seen.Column)), BitOperations.Log2(HorizonBuffer.Group))
            & Vector512.Create(_groups - 1);
        if (_isWide)
        {
            return (0, 0xFFFF);
        }

        Vector512<float> half = Vector512.Create(1.05f) * (seen.Slope + Vector512.Create(ExactLight.Doubt))
            * (Vector512<float>.One + (seen.Tangent * seen.Tangent));
        Vector512<float> lower = seen.Tangent - half;
        Vector512<float> isFull = Vector512.GreaterThan(lower, HorizonTable.Gather(_most, group))
            | Vector512.GreaterThan(lower, Vector512.Create(_highest));
        Vector512<float> isNone = Vector512.LessThan(seen.Tangent + half, HorizonTable.Gather(_least, group));
        uint full = (uint)isFull.ExtractMostSignificantBits();
        return (full, ~(full | (uint)isNone.ExtractMostSignificantBits()) & 0xFFFF);
    }
}
