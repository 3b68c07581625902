using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// The facets of a block of the surface, in the axes of <see cref="GroundTree"/>. Two facets compute the side on which a ray passes their
/// common edge from the same numbers with opposite signs, so that no ray slips through between them. Immutable.
/// </summary>
internal sealed class GroundBlock : GroundPart
{
    private const int Edge = 8;
    private const int PatchesPerEdge = CellBlock.Size / Edge;

    private readonly BlockVertices _vertices = new();
    private readonly SixteenBoxes _patches = new();
    private readonly SixteenBoxes[] _strips = new SixteenBoxes[SixteenBoxes.Count];

    /// <summary>Reads a block.</summary>
    /// <param name="tree">The tree.</param>
    /// <param name="block">The block, or a piece of it.</param>
    public GroundBlock(GroundTree tree, CellBlock block)
    {
        _vertices.Load(tree.Surface, block, tree.Origin);
        for (int line = 0; line < _vertices.Lines; line++)
        {
            for (int sample = 0; sample < _vertices.Samples; sample++)
            {
                int at = (line * BlockVertices.Stride) + sample;
                (_vertices.X[at], _vertices.Y[at], _vertices.Z[at]) = tree.Turned(_vertices[line, sample]);
            }
        }

        for (int patch = 0; patch < SixteenBoxes.Count; patch++)
        {
            (int top, int left) = (patch / PatchesPerEdge * Edge, patch % PatchesPerEdge * Edge);
            int lines = Math.Min(Edge, _vertices.Lines - 1 - top);
            int samples = Math.Min(Edge, _vertices.Samples - 1 - left);
            if (lines > 0 && samples > 0)
            {
                _patches.Set(patch, Low(top, lines, left, samples), High(top, lines, left, samples));
                _strips[patch] = new SixteenBoxes();
                for (int line = 0; line < lines; line++)
                {
                    _strips[patch].Set(line, Low(top + line, 1, left, samples), High(top + line, 1, left, samples));
                }
            }
        }
    }

    /// <inheritdoc/>
    public override void Meet(ref GroundRay ray)
    {
        for (uint patches = _patches.Meet(ray); patches != 0 && !ray.IsOver; patches &= patches - 1)
        {
            int patch = BitOperations.TrailingZeroCount(patches);
            for (uint lines = _strips[patch].Meet(ray); lines != 0 && !ray.IsOver; lines &= lines - 1)
            {
                int line = (patch / PatchesPerEdge * Edge) + BitOperations.TrailingZeroCount(lines);
                MeetStrip(line, patch % PatchesPerEdge * Edge, ref ray);
            }
        }
    }

    /// <summary>Tests the facets of eight cells of a line.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void MeetStrip(int line, int sample, ref GroundRay ray)
    {
        int at = (line * BlockVertices.Stride) + sample;
        Lanes northWest = new(_vertices, at, ray.Origin);
        Lanes northEast = new(_vertices, at + 1, ray.Origin);
        Lanes southWest = new(_vertices, at + BlockVertices.Stride, ray.Origin);
        Lanes southEast = new(_vertices, at + BlockVertices.Stride + 1, ray.Origin);
        Vector3D along = ray.Direction;
        Vector512<double> diagonal = Lanes.Side(along, northWest, southEast);
        Vector512<double> zero = Vector512<double>.Zero;
        uint isSouth = (uint)(Vector512.LessThanOrEqual(diagonal, zero)
            & Vector512.GreaterThanOrEqual(Lanes.Side(along, northWest, southWest), zero)
            & Vector512.GreaterThanOrEqual(Lanes.Side(along, southWest, southEast), zero)).ExtractMostSignificantBits();
        uint isNorth = (uint)(Vector512.GreaterThanOrEqual(diagonal, zero)
            & Vector512.GreaterThanOrEqual(Lanes.Side(along, southEast, northEast), zero)
            & Vector512.GreaterThanOrEqual(Lanes.Side(along, northEast, northWest), zero)).ExtractMostSignificantBits();
        uint cells = (_vertices.CellsOfLine(line) >> sample) & (uint)((1UL << Math.Min(Edge, _vertices.Samples - 1 - sample)) - 1);
        for (uint met = (isSouth | isNorth) & cells; met != 0; met &= met - 1)
        {
            int cell = sample + BitOperations.TrailingZeroCount(met);
            Vector3D nw = _vertices[line, cell] - ray.Origin;
            Vector3D se = _vertices[line + 1, cell + 1] - ray.Origin;
            uint bit = met & (uint)-(int)met;
            if ((isSouth & bit) != 0)
            {
                ray.Take(nw, _vertices[line + 1, cell] - ray.Origin, se);
            }

            if ((isNorth & bit) != 0)
            {
                ray.Take(nw, se, _vertices[line, cell + 1] - ray.Origin);
            }
        }
    }

    private Vector3D Low(int top, int lines, int left, int samples) => Bound(top, lines, left, samples, Math.Min);

    private Vector3D High(int top, int lines, int left, int samples) => Bound(top, lines, left, samples, Math.Max);

    private Vector3D Bound(int top, int lines, int left, int samples, Func<double, double, double> choose)
    {
        Vector3D bound = _vertices[top, left];
        for (int line = top; line <= top + lines; line++)
        {
            for (int sample = left; sample <= left + samples; sample++)
            {
                Vector3D vertex = _vertices[line, sample];
                bound = new Vector3D(choose(bound.X, vertex.X), choose(bound.Y, vertex.Y), choose(bound.Z, vertex.Z));
            }
        }

        return bound;
    }

    /// <summary>Eight neighbouring vertices relative to a ray's origin.</summary>
    private readonly struct Lanes
    {
        private readonly Vector512<double> _x;
        private readonly Vector512<double> _y;
        private readonly Vector512<double> _z;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Lanes(BlockVertices vertices, int at, Vector3D origin)
        {
            _x = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(vertices.X), (nuint)at) - Vector512.Create(origin.X);
            _y = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(vertices.Y), (nuint)at) - Vector512.Create(origin.Y);
            _z = Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(vertices.Z), (nuint)at) - Vector512.Create(origin.Z);
        }

        /// <summary>Not below 0 if a ray that enters the ground passes on the left side of an edge, or meets it.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector512<double> Side(Vector3D along, in Lanes a, in Lanes b) =>
            (Vector512.Create(along.X) * ((b._y * a._z) - (b._z * a._y)))
            + (Vector512.Create(along.Y) * ((b._z * a._x) - (b._x * a._z)))
            + (Vector512.Create(along.Z) * ((b._x * a._y) - (b._y * a._x)));
    }
}
