using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>
/// Ground truth of the pixels of one row that show the surface, from left to right, with one array for each quantity; one object is used
/// for many rows.
/// </summary>
internal sealed class TruthRow
{
    /// <summary>The surface points, with the normals that shade them; columns count from 0.</summary>
    public SurfaceRow Points { get; } = new();

    /// <summary>The facet of each pixel.</summary>
    public FacetId[] Facets { get; private set; } = [];

    public PixelIllumination[] Lights { get; private set; } = [];

    /// <summary>Forgets all pixels and makes room for a row.</summary>
    /// <param name="width">px.</param>
    public void Clear(int width)
    {
        Points.EnsureWidth(width);
        Points.Count = 0;
        if (Facets.Length < width)
        {
            Facets = new FacetId[width];
            Lights = new PixelIllumination[width];
        }
    }

    /// <summary>Adds a pixel.</summary>
    public void Add(int column, in SurfaceHit hit, PixelIllumination light)
    {
        SurfaceRow points = Points;
        int i = points.Count++;
        points.Columns[i] = column;
        points.Parameters[i] = hit.RayParameter;
        (points.X[i], points.Y[i], points.Z[i]) = (hit.PointBodyFixed.X, hit.PointBodyFixed.Y, hit.PointBodyFixed.Z);
        (points.NormalX[i], points.NormalY[i], points.NormalZ[i]) = (hit.NormalBodyFixed.X, hit.NormalBodyFixed.Y, hit.NormalBodyFixed.Z);
        Facets[i] = hit.Facet;
        Lights[i] = light;
    }

    /// <summary>A pixel's surface point, m, body-fixed.</summary>
    /// <param name="index">Which of the pixels, from 0.</param>
    public Vector3D PointAt(int index) => new(Points.X[index], Points.Y[index], Points.Z[index]);

    /// <summary>A pixel's surface point.</summary>
    /// <param name="index">Which of the pixels, from 0.</param>
    public SurfaceHit HitAt(int index) => new(
        PointAt(index),
        new Vector3D(Points.NormalX[index], Points.NormalY[index], Points.NormalZ[index]),
        Facets[index],
        Points.Parameters[index]);

    /// <summary>Leaves only some columns, and counts from the first of them.</summary>
    /// <param name="firstColumn">The first column that stays.</param>
    /// <param name="width">How many stay.</param>
    public void Cut(int firstColumn, int width)
    {
        SurfaceRow points = Points;
        ReadOnlySpan<int> columns = points.Columns.AsSpan(0, points.Count);
        int first = columns.IndexOfAnyExceptInRange(int.MinValue, firstColumn - 1);
        first = first < 0 ? points.Count : first;
        int count = columns[first..].IndexOfAnyExceptInRange(int.MinValue, firstColumn + width - 1);
        count = count < 0 ? points.Count - first : count;
        foreach (double[] values in (double[][])
            [points.Parameters, points.X, points.Y, points.Z, points.NormalX, points.NormalY, points.NormalZ])
        {
            Array.Copy(values, first, values, 0, count);
        }

        Array.Copy(Facets, first, Facets, 0, count);
        Array.Copy(Lights, first, Lights, 0, count);
        for (int i = 0; i < count; i++)
        {
            points.Columns[i] = points.Columns[first + i] - firstColumn;
        }

        points.Count = count;
    }
}
