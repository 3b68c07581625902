using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Indirect;

/// <summary>The points of <see cref="GroundLights"/> that are not dark, as floats: what each may give to a group, roughly.</summary>
internal sealed class BrightLights
{
    /// <summary>Most points of a group of which the mean tells what light it may get.</summary>
    private const int Asked = 4;

    /// <summary>Part of what a light may give at most to a group that counts, because not all points were asked.</summary>
    private const float Floor = 0.03f;

    /// <summary>Added to cosines of groups, so that no point is left out that may count.</summary>
    private const float Slack = 0.1f;

    private readonly int[] _numbers;
    private readonly Vector3D _origin;
    private readonly Vectors _points;
    private readonly Vectors _normals;

    /// <summary>Takes some lights.</summary>
    /// <param name="numbers">Which ones.</param>
    /// <param name="points">Places of all lights, m.</param>
    /// <param name="normals">Normals of all lights.</param>
    public BrightLights(int[] numbers, Vector3D[] points, Vector3D[] normals)
    {
        _numbers = numbers;
        _origin = numbers.Length == 0 ? default : points[numbers[0]];
        int padded = (numbers.Length + Vector512<float>.Count - 1) / Vector512<float>.Count * Vector512<float>.Count;
        (PaddedLength, _points, _normals) = (padded, new Vectors(padded), new Vectors(padded));
        for (int i = 0; i < padded; i++)
        {
            int number = numbers[Math.Min(i, numbers.Length - 1)];
            _points.Set(i, points[number] - _origin);
            _normals.Set(i, normals[number]);
        }
    }

    /// <summary>How many there are.</summary>
    public int Length => _numbers.Length;

    /// <summary>Number of a bright light among all.</summary>
    public int this[int index] => _numbers[index];

    /// <summary>The same, with as many more as fill the last vector.</summary>
    public int PaddedLength { get; }

    /// <summary>Finds what each light may give to a point of a group, roughly, if nothing hides it.</summary>
    /// <param name="group">The group.</param>
    /// <param name="powers">Brightness times area of each light; <see cref="PaddedLength"/> elements, the last ones 0.</param>
    /// <param name="given">Receives it; <see cref="PaddedLength"/> elements.</param>
    /// <returns>The light nearest to the group's middle, and its distance, m.</returns>
    public (int Light, double Distance) Find(Receivers group, float[] powers, float[] given)
    {
        Vector512<float> least = Vector512.Create(float.PositiveInfinity);
        Vector512<int> nearest = Vector512<int>.Zero;
        for (int at = 0; at < Length; at += Vector512<float>.Count)
        {
            Sight middle = See(at, group.Middle, group.MeanNormal);
            Vector512<float> isNearer = Vector512.LessThan(middle.Square, least);
            least = Vector512.ConditionalSelect(isNearer, middle.Square, least);
            nearest = Vector512.ConditionalSelect(isNearer.AsInt32(), Vector512.Create(at) + Vector512<int>.Indices, nearest);
            Vector512<float> all = group.Count > 1 ? Most(middle, group) : Vector512<float>.Zero;
            int step = (group.Count + Asked - 1) / Asked;
            float part = 1.0f / ((group.Count + step - 1) / step);
            for (int receiver = 0; receiver < group.Count; receiver += step)
            {
                Sight sight = See(at, group.Points[receiver], group.Normals[receiver]);
                Vector512<float> isFar = Vector512.GreaterThanOrEqual(
                    sight.Square, Vector512.Create((float)(group.Reaches[receiver] * group.Reaches[receiver])));
                Vector512<float> light = Vector512.Max(sight.Emitted, Vector512<float>.Zero)
                    * Vector512.Max(sight.Received, Vector512<float>.Zero) / (sight.Square * sight.Square);
                all += Vector512.ConditionalSelect(isFar, part * light, Vector512<float>.Zero);
            }

            all *= ArrayLanes.Load(powers, at);
            all.StoreTo(given, at);
        }

        int best = 0;
        for (int lane = 1; lane < Vector512<float>.Count; lane++)
        {
            best = least[lane] < least[best] ? lane : best;
        }

        return (_numbers[Math.Min(nearest[best], Length - 1)], Math.Sqrt(least[best]));
    }

    /// <summary>What lights may give to any point of a group at most, but for its normal.</summary>
    private static Vector512<float> Most(in Sight middle, Receivers group)
    {
        Vector512<float> one = Vector512<float>.One;
        Vector512<float> distance = Vector512.Sqrt(middle.Square);
        Vector512<float> margin = Vector512.Create((float)group.Radius) / distance;
        Vector512<float> emitted = Vector512.Clamp(margin + (middle.Emitted / distance), Vector512<float>.Zero, one);
        Vector512<float> received = Vector512.Create(Slack) + margin + Vector512.Max(middle.Received / distance, Vector512<float>.Zero);
        Vector512<float> nearest = Vector512.Max(
            distance - Vector512.Create((float)group.Radius), Vector512.Create((float)group.LeastReach));
        Vector512<float> isFar = Vector512.GreaterThan(distance, Vector512.Create((float)(group.LeastReach - group.Radius)));
        return Vector512.ConditionalSelect(
            isFar, Floor * emitted * Vector512.Min(received, one) / (nearest * nearest), Vector512<float>.Zero);
    }

    private Sight See(int at, Vector3D point, Vector3D normal)
    {
        Vector3D relative = point - _origin;
        Vector512<float> x = ArrayLanes.Load(_points.X, at) - Vector512.Create((float)relative.X);
        Vector512<float> y = ArrayLanes.Load(_points.Y, at) - Vector512.Create((float)relative.Y);
        Vector512<float> z = ArrayLanes.Load(_points.Z, at) - Vector512.Create((float)relative.Z);
        return new Sight(
            (x * x) + (y * y) + (z * z),
            -((x * ArrayLanes.Load(_normals.X, at)) + (y * ArrayLanes.Load(_normals.Y, at)) + (z * ArrayLanes.Load(_normals.Z, at))),
            ((float)normal.X * x) + ((float)normal.Y * y) + ((float)normal.Z * z));
    }

    /// <summary>How a point and sixteen lights see each other.</summary>
    /// <param name="Square">Square of the distance, m^2.</param>
    /// <param name="Emitted">Cosine at the light times the distance.</param>
    /// <param name="Received">Cosine at the point times the distance.</param>
    private readonly record struct Sight(Vector512<float> Square, Vector512<float> Emitted, Vector512<float> Received);

    /// <summary>Vectors.</summary>
    private sealed class Vectors(int count)
    {
        public float[] X { get; } = new float[count];

        public float[] Y { get; } = new float[count];

        public float[] Z { get; } = new float[count];

        public void Set(int at, Vector3D vector) => (X[at], Y[at], Z[at]) = ((float)vector.X, (float)vector.Y, (float)vector.Z);
    }
}
