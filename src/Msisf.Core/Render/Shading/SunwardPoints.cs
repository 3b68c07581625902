using System.Collections.Concurrent;
using System.Runtime.Intrinsics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Shading;

/// <summary>
/// The points of a frame whose facet faces the Sun, so that only other terrain can hide them from it. Reading a row also stores each
/// pixel's cosine of the incidence angle, so that a reflectance law that needs only this does not read the surface again.
/// </summary>
internal sealed class SunwardPoints : IReceiverRows
{
    /// <summary>Value stored as the cosine of pixels without surface: negative, so that they count as unlit.</summary>
    private const double NoSurface = -1.0;

    /// <summary>Mask of eight points that all face the Sun.</summary>
    private const uint AllFacing = 0xff;

    private readonly ISurfaceRows _visible;
    private readonly Vector3D _sun;
    private readonly double[] _cosIncidence;
    private readonly double _minCosine;
    private readonly ConcurrentBag<Scratch> _idle = [];

    /// <summary>Makes the receivers of a frame.</summary>
    /// <param name="visible">The surface points that the pixels show.</param>
    /// <param name="sunBodyFixed">The position of the Sun or of the lamp, m, body-fixed.</param>
    /// <param name="cosIncidence">One value for each pixel, row by row, set when a row is read; -1 where there is no surface.</param>
    /// <param name="minCosine">Only points with a greater cosine are read: 0, or slightly less for the Sun's disc.</param>
    public SunwardPoints(ISurfaceRows visible, Vector3D sunBodyFixed, double[] cosIncidence, double minCosine = 0.0)
    {
        _visible = visible;
        _sun = sunBodyFixed;
        _cosIncidence = cosIncidence;
        _minCosine = minCosine;
    }

    public int Rows => _visible.Height;

    public int Width => _visible.Width;

    /// <summary>
    /// Called with each row that is read, its points and their cosines, from several threads: a law that needs more than the cosine then
    /// has what it needs at hand. Null if nobody wants it.
    /// </summary>
    public Action<int, SurfaceRow, double[]>? RowRead { get; init; }

    /// <summary>Sets the cosines of a row without returning its points.</summary>
    public void ReadCosines(int row)
    {
        Scratch scratch = Take();
        Scatter(row, scratch);
        _idle.Add(scratch);
    }

    public int Read(int row, Span<double> x, Span<double> y, Span<double> z, Span<int> columns)
    {
        Scratch scratch = Take();
        Scatter(row, scratch);
        int count = CopyFacing(scratch.Row, scratch.Cosines, x, y, z, columns);
        _idle.Add(scratch);
        return count;
    }

    public void ReadAgain(int row, ReadOnlySpan<int> columns, Span<double> x, Span<double> y, Span<double> z)
    {
        Scratch scratch = Take();
        _visible.ReadPoints(row + 1, columns, scratch.Row);
        scratch.Row.X.AsSpan(0, columns.Length).CopyTo(x);
        scratch.Row.Y.AsSpan(0, columns.Length).CopyTo(y);
        scratch.Row.Z.AsSpan(0, columns.Length).CopyTo(z);
        _idle.Add(scratch);
    }

    /// <summary>Copies the points that face the Sun, and returns their number.</summary>
    private int CopyFacing(
        SurfaceRow points, ReadOnlySpan<double> cosines, Span<double> x, Span<double> y, Span<double> z, Span<int> columns)
    {
        int count = 0;
        for (int i = 0; i < points.Count; i += SurfaceRow.Padding)
        {
            uint facing = (uint)Vector512.GreaterThan(Vector512.Create(cosines[i..]), Vector512.Create(_minCosine))
                .ExtractMostSignificantBits();
            int left = points.Count - i;
            if (facing == AllFacing && left >= SurfaceRow.Padding)
            {
                ArrayLanes.Load(points.X, i).StoreTo(x, count);
                ArrayLanes.Load(points.Y, i).StoreTo(y, count);
                ArrayLanes.Load(points.Z, i).StoreTo(z, count);
                ArrayLanes.Load256(points.Columns, i).StoreTo(columns, count);
                count += SurfaceRow.Padding;
                continue;
            }

            // No branch for each point: where light and shade alternate it would often be mispredicted.
            for (int lane = 0; facing != 0 && lane < Math.Min(left, SurfaceRow.Padding); lane++)
            {
                (x[count], y[count], z[count]) = (points.X[i + lane], points.Y[i + lane], points.Z[i + lane]);
                columns[count] = points.Columns[i + lane];
                count += (int)(facing >> lane) & 1;
            }
        }

        return count;
    }

    private Scratch Take() => _idle.TryTake(out Scratch? idle) ? idle : new Scratch();

    private void Scatter(int row, Scratch scratch)
    {
        SurfaceRow points = scratch.Row;
        _visible.Read(row + 1, points);
        scratch.EnsureRoom(points.Count);
        FindCosines(points, scratch.Cosines);
        Span<double> all = _cosIncidence.AsSpan(row * _visible.Width, _visible.Width);
        if (points.Count == all.Length)
        {
            scratch.Cosines.AsSpan(0, all.Length).CopyTo(all);
        }
        else
        {
            all.Fill(NoSurface);
            for (int i = 0; i < points.Count; i++)
            {
                all[points.Columns[i]] = scratch.Cosines[i];
            }
        }

        RowRead?.Invoke(row, points, scratch.Cosines);
    }

    private void FindCosines(SurfaceRow points, Span<double> cosines)
    {
        ReadOnlySpan<double> x = points.X;
        ReadOnlySpan<double> y = points.Y;
        ReadOnlySpan<double> z = points.Z;
        ReadOnlySpan<double> normalX = points.NormalX;
        ReadOnlySpan<double> normalY = points.NormalY;
        ReadOnlySpan<double> normalZ = points.NormalZ;
        for (int i = 0; i < points.Count; i += Vector512<double>.Count)
        {
            Vector512<double> toSunX = Vector512.Create(_sun.X) - ArrayLanes.Load(x, i);
            Vector512<double> toSunY = Vector512.Create(_sun.Y) - ArrayLanes.Load(y, i);
            Vector512<double> toSunZ = Vector512.Create(_sun.Z) - ArrayLanes.Load(z, i);
            Vector512<double> along = (ArrayLanes.Load(normalX, i) * toSunX)
                + (ArrayLanes.Load(normalY, i) * toSunY)
                + (ArrayLanes.Load(normalZ, i) * toSunZ);
            Vector512<double> length = Vector512.Sqrt((toSunX * toSunX) + (toSunY * toSunY) + (toSunZ * toSunZ));
            Vector512.MinNative(along / length, Vector512<double>.One).StoreTo(cosines, i);
        }
    }

    /// <summary>The buffers of one thread.</summary>
    private sealed class Scratch
    {
        public SurfaceRow Row { get; } = new();

        public double[] Cosines { get; private set; } = [];

        public void EnsureRoom(int count)
        {
            if (Cosines.Length < count + SurfaceRow.Padding)
            {
                Cosines = new double[count + SurfaceRow.Padding];
            }
        }
    }
}
