using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// The edges of eight neighbouring cells as seen from a point: which facets straight lines through the point pass. Two facets have their
/// common edge from the same numbers with opposite signs.
/// </summary>
internal readonly struct StripEdges
{
    private readonly Normals _diagonal;
    private readonly Normals _west;
    private readonly Normals _south;
    private readonly Normals _east;
    private readonly Normals _north;

    /// <summary>Reads the edges.</summary>
    /// <param name="vertices">The block.</param>
    /// <param name="at">Index of the first cell's north-west vertex.</param>
    /// <param name="origin">The point.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public StripEdges(BlockVertices vertices, int at, Vector3D origin)
    {
        Lanes northWest = new(vertices, at, origin);
        Lanes northEast = new(vertices, at + 1, origin);
        Lanes southWest = new(vertices, at + BlockVertices.Stride, origin);
        Lanes southEast = new(vertices, at + BlockVertices.Stride + 1, origin);
        _diagonal = new Normals(northWest, southEast);
        _west = new Normals(northWest, southWest);
        _south = new Normals(southWest, southEast);
        _east = new Normals(southEast, northEast);
        _north = new Normals(northEast, northWest);
    }

    /// <summary>Finds the facets through which a line passes that enters the ground.</summary>
    /// <param name="along">Direction of the line.</param>
    /// <param name="isSouth">The cells of which it passes the southern facet, as bits.</param>
    /// <param name="isNorth">The same of the northern one.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Pass(Vector3D along, out uint isSouth, out uint isNorth)
    {
        Vector512<double> x = Vector512.Create(along.X);
        Vector512<double> y = Vector512.Create(along.Y);
        Vector512<double> z = Vector512.Create(along.Z);
        Vector512<double> diagonal = _diagonal.Side(x, y, z);
        Vector512<double> zero = Vector512<double>.Zero;
        isSouth = (uint)(Vector512.LessThanOrEqual(diagonal, zero)
            & Vector512.GreaterThanOrEqual(_west.Side(x, y, z), zero)
            & Vector512.GreaterThanOrEqual(_south.Side(x, y, z), zero)).ExtractMostSignificantBits();
        isNorth = (uint)(Vector512.GreaterThanOrEqual(diagonal, zero)
            & Vector512.GreaterThanOrEqual(_east.Side(x, y, z), zero)
            & Vector512.GreaterThanOrEqual(_north.Side(x, y, z), zero)).ExtractMostSignificantBits();
    }

    /// <summary>Eight neighbouring vertices relative to the point.</summary>
    private readonly struct Lanes
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Lanes(BlockVertices vertices, int at, Vector3D origin)
        {
            X = ArrayLanes.Load(vertices.X, at) - Vector512.Create(origin.X);
            Y = ArrayLanes.Load(vertices.Y, at) - Vector512.Create(origin.Y);
            Z = ArrayLanes.Load(vertices.Z, at) - Vector512.Create(origin.Z);
        }

        public Vector512<double> X { get; }

        public Vector512<double> Y { get; }

        public Vector512<double> Z { get; }
    }

    /// <summary>Normals of the planes through the point and eight edges.</summary>
    private readonly struct Normals
    {
        private readonly Vector512<double> _x;
        private readonly Vector512<double> _y;
        private readonly Vector512<double> _z;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Normals(in Lanes a, in Lanes b) => (_x, _y, _z) =
            ((b.Y * a.Z) - (b.Z * a.Y), (b.Z * a.X) - (b.X * a.Z), (b.X * a.Y) - (b.Y * a.X));

        /// <summary>Not below 0 if a line that enters the ground passes on the left side of an edge, or meets it.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector512<double> Side(Vector512<double> x, Vector512<double> y, Vector512<double> z) =>
            (x * _x) + (y * _y) + (z * _z);
    }
}
