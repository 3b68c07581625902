namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Straight ways from the points of a group to one point, in the axes of <see cref="GroundTree"/>, which are followed together; one object
/// serves many.
/// </summary>
internal sealed class GroundFan
{
    /// <summary>Stands for the inverse of lengths that may have either sign: all boxes are met.</summary>
    private const float Any = 1e12f;

    private readonly Vector3D[] _starts = new Vector3D[Receivers.Size];

    /// <summary>Directions of the ways from their starts to <see cref="End"/>; length 1 each.</summary>
    public Vector3D[] Directions { get; } = new Vector3D[Receivers.Size];

    /// <summary>m: how long the ways are.</summary>
    public double[] Lengths { get; } = new double[Receivers.Size];

    /// <summary>1/m: inverses of what leads from <see cref="End"/> to the starts, x, y and z after each other.</summary>
    public float[] Inverses { get; } = new float[3 * Receivers.Size];

    /// <summary>The inverses of all ways lie between these, if they have one sign: two for each axis.</summary>
    public float[] Limits { get; } = new float[6];

    /// <summary>Where the ways meet.</summary>
    public Vector3D End { get; private set; }

    /// <summary>The ways on which no ground was found, as bits.</summary>
    public ulong Open { get; private set; }

    /// <summary>Sets where a way starts, for all ends that follow.</summary>
    public void Start(int way, Vector3D start) => _starts[way] = start;

    /// <summary>Lets ways lead to a point.</summary>
    /// <param name="end">The point.</param>
    /// <param name="ways">Which ways, as bits.</param>
    /// <param name="count">Number of starts.</param>
    public void Lead(Vector3D end, ulong ways, int count)
    {
        (End, Open) = (end, ways);
        Vector3D low = new(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity);
        Vector3D high = -low;
        for (int way = 0; way < count; way++)
        {
            if (((ways >> way) & 1) == 0)
            {
                continue;
            }

            Vector3D back = _starts[way] - end;
            Lengths[way] = Math.Sqrt(back.LengthSquared);
            Directions[way] = -1.0 / Lengths[way] * back;
            Inverses[way] = Inverse(back.X);
            Inverses[Receivers.Size + way] = Inverse(back.Y);
            Inverses[(2 * Receivers.Size) + way] = Inverse(back.Z);
            low = new Vector3D(Math.Min(low.X, back.X), Math.Min(low.Y, back.Y), Math.Min(low.Z, back.Z));
            high = new Vector3D(Math.Max(high.X, back.X), Math.Max(high.Y, back.Y), Math.Max(high.Z, back.Z));
        }

        (Limits[0], Limits[1]) = Between(low.X, high.X);
        (Limits[2], Limits[3]) = Between(low.Y, high.Y);
        (Limits[4], Limits[5]) = Between(low.Z, high.Z);
    }

    /// <summary>Closes a way if it enters the ground through a facet, before its end.</summary>
    /// <param name="way">The way.</param>
    /// <param name="a">A corner, relative to <see cref="End"/>.</param>
    /// <param name="b">The next one, counter-clockwise seen from outside.</param>
    /// <param name="c">The last one.</param>
    /// <param name="gap">m: facets so near to the end do not count.</param>
    public void Take(int way, Vector3D a, Vector3D b, Vector3D c, double gap)
    {
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        double along = Vector3D.Dot(normal, Directions[way]);
        double beforeEnd = -Vector3D.Dot(normal, a) / along;
        if (along < 0.0 && beforeEnd > gap && beforeEnd < Lengths[way])
        {
            Open &= ~(1UL << way);
        }
    }

    private static (float One, float Other) Between(double low, double high) =>
        low > 0.0 || high < 0.0 ? (Inverse(low), Inverse(high)) : (-Any, Any);

    private static float Inverse(double length) => Math.Clamp((float)(1.0 / length), -Any, Any);
}
