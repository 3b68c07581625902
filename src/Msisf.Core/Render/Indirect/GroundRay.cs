namespace Msisf.Core.Render.Indirect;

/// <summary>A ray through the ground around a view, in the axes of <see cref="GroundTree"/>, and what it has met.</summary>
internal ref struct GroundRay
{
    /// <summary>Least component of a direction: its inverse stays finite.</summary>
    private const double Least = 1e-12;

    /// <summary>Prepares a ray.</summary>
    /// <param name="origin">m.</param>
    /// <param name="direction">Length 1.</param>
    /// <param name="end">m: facets from here on do not count.</param>
    /// <param name="stopsAtAnyHit">Whether any facet ends the way, and not only the first.</param>
    public GroundRay(Vector3D origin, Vector3D direction, double end, bool stopsAtAnyHit)
    {
        (Origin, Direction, End, StopsAtAnyHit) = (origin, direction, end, stopsAtAnyHit);
        (PerX, PerY, PerZ) = (Inverse(direction.X), Inverse(direction.Y), Inverse(direction.Z));
    }

    /// <summary>m.</summary>
    public Vector3D Origin { get; }

    /// <summary>Length 1.</summary>
    public Vector3D Direction { get; }

    /// <summary>Whether any facet ends the way.</summary>
    public bool StopsAtAnyHit { get; }

    /// <summary>Inverse of a component of the direction.</summary>
    public float PerX { get; }

    /// <inheritdoc cref="PerX"/>
    public float PerY { get; }

    /// <inheritdoc cref="PerX"/>
    public float PerZ { get; }

    /// <summary>m: distance of the facet that was met, otherwise of the ray's end.</summary>
    public double End { get; private set; }

    /// <summary>Whether a facet was met.</summary>
    public bool IsHit { get; private set; }

    /// <summary>Outward normal of the facet that was met; its length is not 1.</summary>
    public Vector3D Normal { get; private set; }

    /// <summary>Whether nothing more is to be found.</summary>
    public readonly bool IsOver => IsHit && StopsAtAnyHit;

    /// <summary>Takes a facet through which the ray enters the ground, if it is the nearest so far.</summary>
    /// <param name="a">A corner, relative to the ray's origin.</param>
    /// <param name="b">The next one, counter-clockwise seen from outside.</param>
    /// <param name="c">The last one.</param>
    public void Take(Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D normal = Vector3D.Cross(b - a, c - a);
        double along = Vector3D.Dot(normal, Direction);
        double distance = Vector3D.Dot(normal, a) / along;
        if (along < 0.0 && distance > 0.0 && distance < End)
        {
            (End, IsHit, Normal) = (distance, true, normal);
        }
    }

    private static float Inverse(double component) =>
        (float)(1.0 / (Math.Abs(component) > Least ? component : double.CopySign(Least, component)));
}
