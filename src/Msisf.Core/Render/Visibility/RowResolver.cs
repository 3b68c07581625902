using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Computes the surface points that pixels show: camera + t direction. The direction is bit for bit that of
/// <see cref="Camera.PinholeCamera.RayThrough"/>. The depth buffer gives t with the accuracy of the projected corners. The point at t is
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
    private readonly double[] _right;

    public RowResolver(ImageView view, LensSamples? lens)
    {
        _view = view;
        _lens = lens;
        _right = new double[view.Camera.Width];
        double width = view.Camera.Width;
        for (int column = 0; column < _right.Length; column++)
        {
            double x = column + 1 + view.OffsetX;
            _right[column] = ((2.0 * x) - 1.0 - width) / (2.0 * width);
        }
    }

    private double UpOf(int row)
    {
        double height = _view.Camera.Height;
        return (1.0 + height - (2.0 * (row + 1 + _view.OffsetY))) / (2.0 * height);
    }

    /// <summary>Computes the surface point of one pixel; column and row count from 0.</summary>
    public SurfaceHit Resolve(int column, int row, double inverseDepth, in FacetRecord record)
    {
        Vector3D direction = _view.Camera.RayThrough(column + 1 + _view.OffsetX, row + 1 + _view.OffsetY).Direction;
        Vector3D position = _view.Camera.PositionMoonMe - _view.Anchor;
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
    /// <param name="band">The band of the row.</param>
    /// <param name="row">The row, from 0.</param>
    /// <param name="pixels">Receives the pixels.</param>
    /// <param name="withNormals">Whether the normals get the length 1; without, they are not to be used.</param>
    public void Resolve(Band band, int row, SurfaceRow pixels, bool withNormals)
    {
        pixels.EnsureWidth(band.Width);
        Gather(band, row, pixels);
        PinholeCamera camera = _view.Camera;
        if (_lens is null)
        {
            Locate(pixels, camera.Direction + (UpOf(row) * camera.Up), camera.Right, vertical: null, withNormals);
        }
        else
        {
            Locate(pixels, camera.LensAxis, camera.LensRight, camera.LensDown, withNormals);
        }
    }

    /// <summary>Computes the surface points of parts of pixels.</summary>
    /// <param name="parts">The parts, of the same camera without offset.</param>
    /// <param name="first">The first one that is wanted.</param>
    /// <param name="count">How many.</param>
    /// <param name="points">Receives them, in their order; their columns count from 0.</param>
    /// <param name="withNormals">Whether the normals get the length 1; without, they are not to be used.</param>
    public void Resolve(PixelParts parts, int first, int count, SurfaceRow points, bool withNormals)
    {
        points.EnsureWidth(count);
        for (int i = 0; i < count; i++)
        {
            points.Columns[i] = i;
        }

        parts.InverseDepths.AsSpan(first, count).CopyTo(points.Parameters);
        parts.Across.AsSpan(first, count).CopyTo(points.X);
        parts.Along.AsSpan(first, count).CopyTo(points.Z);
        parts.Facets.AsSpan(first, count).CopyTo(points.Facets);
        points.Count = count;
        GatherPlanes(parts.Records, points);
        Pad(points);
        PinholeCamera camera = _view.Camera;
        if (camera.Model.Lens is null)
        {
            Locate(points, camera.Direction, camera.Right, camera.Up, withNormals);
        }
        else
        {
            Locate(points, camera.LensAxis, camera.LensRight, camera.LensDown, withNormals);
        }
    }

    /// <summary>
    /// Computes the points of a row whose X, and Z if there is a vertical vector, are the factors of the ray's direction.
    /// </summary>
    /// <param name="pixels">The pixels, gathered.</param>
    /// <param name="middle">The direction of a ray with the factors 0.</param>
    /// <param name="right">The vector that X multiplies.</param>
    /// <param name="vertical">The vector that Z multiplies; null if the directions differ only by the vector to the right.</param>
    /// <param name="withNormals">Whether the normals get the length 1.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would else be shaded with unoptimised vectors
    private void Locate(SurfaceRow pixels, Vector3D middle, Vector3D right, Vector3D? vertical, bool withNormals)
    {
        Vector3D anchor = _view.Anchor;
        Vector3D position = _view.Camera.PositionMoonMe - anchor;
        bool hasVertical = vertical is not null;
        Vector3D other = vertical ?? default;
        Vector512<double> distance = Vector512.Create(_view.Distance);
        Vector512<double> max = Vector512.Create(MaxCorrection);
        ref double parameters = ref MemoryMarshal.GetArrayDataReference(pixels.Parameters);
        ref double x = ref MemoryMarshal.GetArrayDataReference(pixels.X);
        ref double y = ref MemoryMarshal.GetArrayDataReference(pixels.Y);
        ref double z = ref MemoryMarshal.GetArrayDataReference(pixels.Z);
        ref double normalX = ref MemoryMarshal.GetArrayDataReference(pixels.NormalX);
        ref double normalY = ref MemoryMarshal.GetArrayDataReference(pixels.NormalY);
        ref double normalZ = ref MemoryMarshal.GetArrayDataReference(pixels.NormalZ);
        for (nuint i = 0; i < (nuint)pixels.Count; i += (nuint)Vector512<double>.Count)
        {
            Vector512<double> parameter = Vector512<double>.One / (Vector512.LoadUnsafe(ref parameters, i) * distance);
            Vector512<double> toRight = Vector512.LoadUnsafe(ref x, i);
            Vector512<double> offset = Vector512.LoadUnsafe(ref y, i);
            Vector512<double> directionX = Vector512.Create(middle.X) + (toRight * Vector512.Create(right.X));
            Vector512<double> directionY = Vector512.Create(middle.Y) + (toRight * Vector512.Create(right.Y));
            Vector512<double> directionZ = Vector512.Create(middle.Z) + (toRight * Vector512.Create(right.Z));
            if (hasVertical)
            {
                Vector512<double> factor = Vector512.LoadUnsafe(ref z, i);
                directionX += factor * Vector512.Create(other.X);
                directionY += factor * Vector512.Create(other.Y);
                directionZ += factor * Vector512.Create(other.Z);
            }

            Vector512<double> nearX = Stable.Along(Vector512.Create(position.X), parameter, directionX);
            Vector512<double> nearY = Stable.Along(Vector512.Create(position.Y), parameter, directionY);
            Vector512<double> nearZ = Stable.Along(Vector512.Create(position.Z), parameter, directionZ);
            Vector512<double> nx = Vector512.LoadUnsafe(ref normalX, i);
            Vector512<double> ny = Vector512.LoadUnsafe(ref normalY, i);
            Vector512<double> nz = Vector512.LoadUnsafe(ref normalZ, i);
            Vector512<double> limit = max * parameter;
            Vector512<double> correction = Held(
                (offset - ((nx * nearX) + (ny * nearY) + (nz * nearZ))) / ((nx * directionX) + (ny * directionY) + (nz * directionZ)),
                -limit, limit);
            (parameter + correction).StoreUnsafe(ref parameters, i);
            (Vector512.Create(anchor.X) + (nearX + (correction * directionX))).StoreUnsafe(ref x, i);
            (Vector512.Create(anchor.Y) + (nearY + (correction * directionY))).StoreUnsafe(ref y, i);
            (Vector512.Create(anchor.Z) + (nearZ + (correction * directionZ))).StoreUnsafe(ref z, i);
            if (!withNormals)
            {
                continue;
            }

            Vector512<double> perLength = Vector512<double>.One / Vector512.Sqrt((nx * nx) + (ny * ny) + (nz * nz));
            (perLength * nx).StoreUnsafe(ref normalX, i);
            (perLength * ny).StoreUnsafe(ref normalY, i);
            (perLength * nz).StoreUnsafe(ref normalZ, i);
        }
    }

    /// <summary>Limits values to a range; NaN becomes the minimum.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Held(Vector512<double> value, Vector512<double> min, Vector512<double> max) =>
        Vector512.MinNative(Vector512.MaxNative(value, min), max);

    /// <summary>
    /// Copies the row's surface pixels into consecutive elements. Until the points are computed, X holds the pixels' factors of the
    /// camera's right vector and Y the offsets of their planes; with a lens Z holds the factors of the vector down.
    /// </summary>
    private void Gather(Band band, int row, SurfaceRow pixels)
    {
        int start = (row - band.FirstRow) * band.Stride;
        ReadOnlySpan<double> inverses = band.InverseDepths.AsSpan(start, band.Width);
        ReadOnlySpan<int> facets = band.Facets.AsSpan(start, band.Width);
        int count = 0;
        for (int column = 0; column < inverses.Length; column++)
        {
            if (inverses[column] == 0.0)
            {
                continue;
            }

            int first = column;
            while (column < inverses.Length && inverses[column] > 0.0)
            {
                pixels.Columns[count + column - first] = column;
                column++;
            }

            int run = column - first;
            inverses.Slice(first, run).CopyTo(pixels.Parameters.AsSpan(count));
            facets.Slice(first, run).CopyTo(pixels.Facets.AsSpan(count));
            if (_lens is null)
            {
                _right.AsSpan(first, run).CopyTo(pixels.X.AsSpan(count));
            }
            else
            {
                int sample = (row * band.Width) + first;
                _lens.Right.AsSpan(sample, run).CopyTo(pixels.X.AsSpan(count));
                _lens.Down.AsSpan(sample, run).CopyTo(pixels.Z.AsSpan(count));
            }

            count += run;
        }

        pixels.Count = count;
        GatherPlanes(band.Records.AsSpan(), pixels);
        Pad(pixels);
    }

    private static void Pad(SurfaceRow pixels)
    {
        for (int behind = pixels.Count; behind < pixels.Count + SurfaceRow.Padding; behind++)
        {
            (pixels.Parameters[behind], pixels.X[behind], pixels.Y[behind], pixels.Z[behind]) = (1.0, 0.0, 0.0, 0.0);
            (pixels.NormalX[behind], pixels.NormalY[behind], pixels.NormalZ[behind]) = (1.0, 0.0, 0.0);
        }
    }

    private static void GatherPlanes(ReadOnlySpan<FacetRecord> records, SurfaceRow pixels)
    {
        ReadOnlySpan<int> facets = pixels.Facets.AsSpan(0, pixels.Count);
        Span<double> offsets = pixels.Y.AsSpan(0, facets.Length);
        Span<double> normalX = pixels.NormalX.AsSpan(0, facets.Length);
        Span<double> normalY = pixels.NormalY.AsSpan(0, facets.Length);
        Span<double> normalZ = pixels.NormalZ.AsSpan(0, facets.Length);
        for (int i = 0; i < facets.Length; i++)
        {
            ref readonly FacetRecord record = ref records[facets[i]];
            offsets[i] = record.Offset;
            normalX[i] = record.Normal.X;
            normalY[i] = record.Normal.Y;
            normalZ[i] = record.Normal.Z;
        }
    }
}
