using System.Collections.Concurrent;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Render.Shading;

/// <summary>The points of a frame whose facet faces the Sun: those that other terrain may hide from it.</summary>
internal sealed class SunwardPoints : IReceiverRows
{
    private readonly VisibleSurface _visible;
    private readonly Vector3D _sun;
    private readonly ConcurrentBag<SurfaceRow> _rows = [];

    /// <summary>Takes a frame.</summary>
    /// <param name="visible">What its pixels show.</param>
    /// <param name="sunMoonMe">m, MOON_ME.</param>
    public SunwardPoints(VisibleSurface visible, Vector3D sunMoonMe)
    {
        _visible = visible;
        _sun = sunMoonMe;
    }

    /// <inheritdoc/>
    public int Rows => _visible.Height;

    /// <inheritdoc/>
    public int Width => _visible.Width;

    /// <inheritdoc/>
    public int Read(int row, Span<double> x, Span<double> y, Span<double> z, Span<int> columns)
    {
        SurfaceRow points = _rows.TryTake(out SurfaceRow? idle) ? idle : new SurfaceRow();
        _visible.Read(row + 1, points);
        int count = 0;
        for (int i = 0; i < points.Count; i++)
        {
            double towards = (points.NormalX[i] * (_sun.X - points.X[i]))
                + (points.NormalY[i] * (_sun.Y - points.Y[i]))
                + (points.NormalZ[i] * (_sun.Z - points.Z[i]));
            if (towards > 0.0)
            {
                x[count] = points.X[i];
                y[count] = points.Y[i];
                z[count] = points.Z[i];
                columns[count++] = points.Columns[i];
            }
        }

        _rows.Add(points);
        return count;
    }
}
