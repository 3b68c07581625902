namespace Msisf.Core.Render.Indirect;

/// <summary>Some neighbouring points of the ground on which light of other ground falls; one object serves many groups.</summary>
internal sealed class Receivers
{
    /// <summary>Most points of a group.</summary>
    public const int Size = 64;

    /// <summary>Number of points.</summary>
    public int Count { get; private set; }

    /// <summary>m, body-fixed.</summary>
    public Vector3D[] Points { get; } = new Vector3D[Size];

    /// <summary>Normals of the facets, length 1.</summary>
    public Vector3D[] Facets { get; } = new Vector3D[Size];

    /// <summary>Normals that shade the points, length 1.</summary>
    public Vector3D[] Normals { get; } = new Vector3D[Size];

    /// <summary>Directions to the camera, length 1; not used of points whose irradiance is asked for.</summary>
    public Vector3D[] ToCamera { get; } = new Vector3D[Size];

    /// <summary>m: nearer ground is looked at by rays.</summary>
    public double[] Reaches { get; } = new double[Size];

    /// <summary>A number of each point, from which its random numbers follow.</summary>
    public long[] Numbers { get; } = new long[Size];

    /// <summary>The middle of the points.</summary>
    public Vector3D Middle { get; private set; }

    /// <summary>Mean normal.</summary>
    public Vector3D MeanNormal { get; private set; }

    /// <summary>m: largest distance from the middle.</summary>
    public double Radius { get; private set; }

    /// <summary>m: least of <see cref="Reaches"/>.</summary>
    public double LeastReach { get; private set; }

    /// <summary>m: largest of <see cref="Reaches"/>.</summary>
    public double MostReach { get; private set; }

    /// <summary>Forgets all points.</summary>
    public void Clear() => Count = 0;

    /// <summary>Adds a point.</summary>
    public void Add(Vector3D point, Vector3D facet, Vector3D normal, Vector3D toCamera, double reach, long number)
    {
        int i = Count++;
        (Points[i], Facets[i], Normals[i], ToCamera[i], Reaches[i], Numbers[i]) = (point, facet, normal, toCamera, reach, number);
    }

    /// <summary>Finds the middle and the extent.</summary>
    public void Close()
    {
        (Vector3D middle, Vector3D normal) = (default, default);
        for (int i = 0; i < Count; i++)
        {
            middle += Points[i] / Count;
            normal += Normals[i] / Count;
        }

        (double radius, LeastReach, MostReach) = (0.0, double.PositiveInfinity, 0.0);
        for (int i = 0; i < Count; i++)
        {
            radius = Math.Max(radius, (Points[i] - middle).LengthSquared);
            LeastReach = Math.Min(LeastReach, Reaches[i]);
            MostReach = Math.Max(MostReach, Reaches[i]);
        }

        (Middle, MeanNormal, Radius) = (middle, normal, Math.Sqrt(radius));
    }
}
