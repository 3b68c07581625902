using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Edge functions of a facet with corners behind the camera or in its plane: (a x b) . ray, which needs no projection and no clipping. An
/// edge whose two ends are projected is computed from the projected points, as it is for the neighbouring facet, so that no pixel falls
/// between the two facets.
/// </summary>
/// <remarks>M. Olano, T. Greer, "Triangle scan conversion using 2D homogeneous coordinates", Graphics Hardware 1997.</remarks>
internal struct HomogeneousEdges
{
    private Edge _ab;
    private Edge _bc;
    private Edge _ca;

    public HomogeneousEdges(in Corner a, in Corner b, in Corner c, ImageView view)
    {
        _ab = new Edge(a, b, view);
        _bc = new Edge(b, c, view);
        _ca = new Edge(c, a, view);
    }

    /// <summary>Sets the row for which <see cref="Outside(Vector512{double})"/> is computed.</summary>
    public void MoveTo(double row)
    {
        _ab.MoveTo(row);
        _bc.MoveTo(row);
        _ca.MoveTo(row);
    }

    /// <summary>Zero or negative for the columns of the row that lie in the facet or on its border.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector512<double> Outside(Vector512<double> columns) =>
        Vector512.MaxNative(_ab.At(columns), Vector512.MaxNative(_bc.At(columns), _ca.At(columns)));

    /// <summary>Zero or negative for the points that lie in the facet or on its border.</summary>
    public readonly Vector512<double> Outside(Vector512<double> columns, Vector512<double> rows) =>
        Vector512.MaxNative(_ab.At(columns, rows), Vector512.MaxNative(_bc.At(columns, rows), _ca.At(columns, rows)));

    /// <summary>A facet's corner.</summary>
    /// <param name="FromCamera">Position relative to the camera, m, body-fixed.</param>
    /// <param name="X">Image column, px.</param>
    /// <param name="Y">Image row, px.</param>
    /// <param name="IsProjected">Whether the column and row are valid.</param>
    internal readonly record struct Corner(Vector3D FromCamera, double X, double Y, bool IsProjected);

    private struct Edge
    {
        private readonly bool _isProjected;
        private readonly Corner _a;
        private readonly Corner _b;
        private readonly double _constant;
        private readonly double _perRow;
        private readonly Vector512<double> _perColumn;
        private Vector512<double> _first;
        private Vector512<double> _second;

        public Edge(in Corner a, in Corner b, ImageView view)
        {
            (_a, _b) = (a, b);
            _isProjected = a.IsProjected && b.IsProjected;
            Vector3D u = a.FromCamera;
            Vector3D v = b.FromCamera;

            // Plain products without fused operations: the same edge from b to a has exactly the opposite components.
            Vector3D normal = new((u.Y * v.Z) - (u.Z * v.Y), (u.Z * v.X) - (u.X * v.Z), (u.X * v.Y) - (u.Y * v.X));
            _constant = Vector3D.Dot(normal, view.FirstRay);
            _perRow = Vector3D.Dot(normal, view.RayPerRow);
            _perColumn = Vector512.Create(Vector3D.Dot(normal, view.RayPerColumn));
        }

        public void MoveTo(double row)
        {
            _first = Vector512.Create(_isProjected ? _a.Y - row : _constant + (_perRow * row));
            _second = Vector512.Create(_b.Y - row);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly Vector512<double> At(Vector512<double> columns) => _isProjected
            ? ((Vector512.Create(_a.X) - columns) * _second) - ((Vector512.Create(_b.X) - columns) * _first)
            : _first + (_perColumn * columns);

        public readonly Vector512<double> At(Vector512<double> columns, Vector512<double> rows) => _isProjected
            ? ((Vector512.Create(_a.X) - columns) * (Vector512.Create(_b.Y) - rows))
                - ((Vector512.Create(_b.X) - columns) * (Vector512.Create(_a.Y) - rows))
            : Vector512.Create(_constant) + (_perRow * rows) + (_perColumn * columns);
    }
}
