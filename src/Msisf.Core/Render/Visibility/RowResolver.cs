using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Computes the surface points that pixels show: camera + t direction. The direction is bit for bit that of
/// <see cref="FrameCamera.RayThrough"/>. The depth buffer gives t with the accuracy of the projected corners. The point at t is
/// computed with 106 bits and then moved along the ray into the facet's plane. The method for one pixel is the reference; the method for a
/// row gives the same bits.
/// </summary>
internal sealed class RowResolver
{
    /// <summary>
    /// Maximum correction of t, as a fraction of t. It is more than the error of the depth buffer and limits the correction of a facet seen
    /// edge-on, whose plane does not determine the point.
    /// </summary>
    private const double MaxCorrection = 1e-6;

    private readonly ImageView _view;
    private readonly LensSamples? _lens;
    private readonly RowGather _gather;

    public RowResolver(ImageView view, LensSamples? lens)
    {
        _view = view;
        _lens = lens;
        _gather = new RowGather(view, lens);
    }

    private double UpOf(int row)
    {
        double height = _view.Camera.Height;
        return (1.0 + height - (2.0 * (row + 1))) / (2.0 * height);
    }

    /// <summary>Computes the surface point of one pixel; column and row count from 0.</summary>
    public SurfaceHit Resolve(int column, int row, double inverseDepth, in FacetRecord record)
    {
        Vector3D direction = _view.Camera.RayThrough(column + 1, row + 1).Direction;
        Vector3D position = _view.Camera.PositionBodyFixed - _view.Anchor;
        double parameter = 1.0 / (inverseDepth * _view.Distance);
        Vector3D near = Stable.PointAlong(position, parameter, direction);
        double correction = (record.Offset - Vector3D.Dot(record.Normal, near)) / Vector3D.Dot(record.Normal, direction);
        double limit = MaxCorrection * parameter;
        correction = correction > -limit ? correction : -limit;
        correction = correction < limit ? correction : limit;
        double perLength = 1.0 / Math.Sqrt(record.Normal.LengthSquared); // sides of 0.01 m to 1e6 m: no overflow
        return new SurfaceHit(
            _view.Anchor + (near + (correction * direction)), perLength * record.Normal, record.Facet, parameter + correction);
    }

    /// <summary>Computes the surface points of all pixels of a row that show the surface.</summary>
    /// <param name="row">The row, from 0.</param>
    /// <param name="pixels">Receives the pixels.</param>
    public void Resolve(Band band, int row, SurfaceRow pixels)
    {
        pixels.EnsureWidth(band.Width);
        _gather.Gather(band, row, pixels);
        Locate(band.Records.AsSpan(), row, pixels, withNormals: true);
    }

    /// <summary>Computes the surface points of some pixels of a row, without unit normals.</summary>
    /// <param name="row">The row, from 0.</param>
    /// <param name="columns">The pixels' columns; all show the surface.</param>
    /// <param name="pixels">Receives the pixels.</param>
    public void Resolve(Band band, int row, ReadOnlySpan<int> columns, SurfaceRow pixels)
    {
        pixels.EnsureWidth(band.Width);
        _gather.Gather(band, row, columns, pixels);
        Locate(band.Records.AsSpan(), row, pixels, withNormals: false);
    }

    private void Locate(ReadOnlySpan<FacetRecord> records, int row, SurfaceRow pixels, bool withNormals)
    {
        RowGather.GatherPlanes(records, pixels);
        (Vector3D middle, Vector3D right, Vector3D vertical) = _view.Camera.RayAxes;
        if (_lens is null)
        {
            Locate(pixels, middle + (UpOf(row) * vertical), right, vertical: null, withNormals);
        }
        else
        {
            Locate(pixels, middle, right, vertical, withNormals);
        }
    }

    /// <summary>Computes surface points.</summary>
    /// <param name="records">The facets.</param>
    /// <param name="wanted">The points, of the same camera.</param>
    /// <param name="first">The first one that is wanted.</param>
    /// <param name="points">Receives them, in their order; their columns count from 0.</param>
    public void Resolve(ReadOnlySpan<FacetRecord> records, FacetPoints wanted, int first, int count, SurfaceRow points)
    {
        points.EnsureWidth(count);
        for (int i = 0; i < count; i++)
        {
            points.Columns[i] = i;
        }

        wanted.InverseDepths.AsSpan(first, count).CopyTo(points.Parameters);
        wanted.Across.AsSpan(first, count).CopyTo(points.X);
        wanted.Along.AsSpan(first, count).CopyTo(points.Z);
        wanted.Facets.AsSpan(first, count).CopyTo(points.Facets);
        points.Count = count;
        Locate(records, points, withNormals: true);
    }

    /// <summary>Computes some surface points, without unit normals.</summary>
    /// <param name="records">The facets.</param>
    /// <param name="wanted">The points.</param>
    /// <param name="first">The point in column 0.</param>
    /// <param name="columns">The columns of those that are wanted.</param>
    /// <param name="points">Receives them.</param>
    public void Resolve(
        ReadOnlySpan<FacetRecord> records, FacetPoints wanted, int first, ReadOnlySpan<int> columns, SurfaceRow points)
    {
        points.EnsureWidth(columns.Length);
        for (int i = 0; i < columns.Length; i++)
        {
            int point = first + columns[i];
            points.Columns[i] = columns[i];
            points.Parameters[i] = wanted.InverseDepths[point];
            points.X[i] = wanted.Across[point];
            points.Z[i] = wanted.Along[point];
            points.Facets[i] = wanted.Facets[point];
        }

        points.Count = columns.Length;
        Locate(records, points, withNormals: false);
    }

    private void Locate(ReadOnlySpan<FacetRecord> records, SurfaceRow points, bool withNormals)
    {
        RowGather.GatherPlanes(records, points);
        (Vector3D middle, Vector3D right, Vector3D vertical) = _view.Camera.RayAxes;
        Locate(points, middle, right, vertical, withNormals);
    }

    /// <summary>
    /// Computes the points of a row whose X, and Z if there is a vertical vector, are the factors of the ray's direction.
    /// </summary>
    /// <param name="pixels">The pixels, gathered.</param>
    /// <param name="middle">The direction of a ray with the factors 0.</param>
    /// <param name="right">The vector that X multiplies.</param>
    /// <param name="vertical">The vector that Z multiplies; null if the directions differ only by the vector to the right.</param>
    /// <param name="withNormals">Whether the normals get the length 1.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    private void Locate(SurfaceRow pixels, Vector3D middle, Vector3D right, Vector3D? vertical, bool withNormals)
    {
        Vector3D anchor = _view.Anchor;
        Vector3D position = _view.Camera.PositionBodyFixed - anchor;
        bool hasVertical = vertical is not null;
        Vector3D other = vertical ?? default;
        Vector512<double> distance = Vector512.Create(_view.Distance);
        Vector512<double> max = Vector512.Create(MaxCorrection);
        Span<double> parameters = pixels.Parameters;
        Span<double> x = pixels.X;
        Span<double> y = pixels.Y;
        Span<double> z = pixels.Z;
        Span<double> normalX = pixels.NormalX;
        Span<double> normalY = pixels.NormalY;
        Span<double> normalZ = pixels.NormalZ;
        for (int i = 0; i < pixels.Count; i += Vector512<double>.Count)
        {
            Vector512<double> parameter = Vector512<double>.One / (ArrayLanes.Load(parameters, i) * distance);
            Vector512<double> toRight = ArrayLanes.Load(x, i);
            Vector512<double> offset = ArrayLanes.Load(y, i);
            Vector512<double> directionX = Vector512.Create(middle.X) + (toRight * Vector512.Create(right.X));
            Vector512<double> directionY = Vector512.Create(middle.Y) + (toRight * Vector512.Create(right.Y));
            Vector512<double> directionZ = Vector512.Create(middle.Z) + (toRight * Vector512.Create(right.Z));
            if (hasVertical)
            {
                Vector512<double> factor = ArrayLanes.Load(z, i);
                directionX += factor * Vector512.Create(other.X);
                directionY += factor * Vector512.Create(other.Y);
                directionZ += factor * Vector512.Create(other.Z);
            }

            Vector512<double> nearX = Stable.Along(Vector512.Create(position.X), parameter, directionX);
            Vector512<double> nearY = Stable.Along(Vector512.Create(position.Y), parameter, directionY);
            Vector512<double> nearZ = Stable.Along(Vector512.Create(position.Z), parameter, directionZ);
            Vector512<double> nx = ArrayLanes.Load(normalX, i);
            Vector512<double> ny = ArrayLanes.Load(normalY, i);
            Vector512<double> nz = ArrayLanes.Load(normalZ, i);
            Vector512<double> limit = max * parameter;
            Vector512<double> correction = Held(
                (offset - ((nx * nearX) + (ny * nearY) + (nz * nearZ))) / ((nx * directionX) + (ny * directionY) + (nz * directionZ)),
                -limit, limit);
            (parameter + correction).StoreTo(parameters, i);
            (Vector512.Create(anchor.X) + (nearX + (correction * directionX))).StoreTo(x, i);
            (Vector512.Create(anchor.Y) + (nearY + (correction * directionY))).StoreTo(y, i);
            (Vector512.Create(anchor.Z) + (nearZ + (correction * directionZ))).StoreTo(z, i);
            if (!withNormals)
            {
                continue;
            }

            Vector512<double> perLength = Vector512<double>.One / Vector512.Sqrt((nx * nx) + (ny * ny) + (nz * nz));
            (perLength * nx).StoreTo(normalX, i);
            (perLength * ny).StoreTo(normalY, i);
            (perLength * nz).StoreTo(normalZ, i);
        }
    }

    /// <summary>Limits values to a range; NaN becomes the minimum.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Held(Vector512<double> value, Vector512<double> min, Vector512<double> max) =>
        Vector512.MinNative(Vector512.MaxNative(value, min), max);
}
