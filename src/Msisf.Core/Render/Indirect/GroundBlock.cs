using System.Numerics;
using System.Runtime.CompilerServices;
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

    /// <inheritdoc/>
    public override void Meet(GroundFan fan, ulong ways)
    {
        for (uint patches = _patches.Meet(fan); patches != 0; patches &= patches - 1)
        {
            int patch = BitOperations.TrailingZeroCount(patches);
            ulong some = _patches.Meet(patch, fan) & ways & fan.Open;
            for (uint lines = some == 0 ? 0 : _strips[patch].Meet(fan); lines != 0; lines &= lines - 1)
            {
                int inPatch = BitOperations.TrailingZeroCount(lines);
                ulong few = _strips[patch].Meet(inPatch, fan) & some & fan.Open;
                if (few != 0)
                {
                    MeetStrip((patch / PatchesPerEdge * Edge) + inPatch, patch % PatchesPerEdge * Edge, fan, few);
                }
            }
        }
    }

    /// <summary>Tests the facets of eight cells of a line.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void MeetStrip(int line, int sample, ref GroundRay ray)
    {
        StripEdges edges = new(_vertices, (line * BlockVertices.Stride) + sample, ray.Origin);
        edges.Pass(ray.Direction, out uint isSouth, out uint isNorth);
        for (uint met = (isSouth | isNorth) & CellsOf(line, sample); met != 0; met &= met - 1)
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

    /// <summary>The same for some ways of a fan.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void MeetStrip(int line, int sample, GroundFan fan, ulong ways)
    {
        StripEdges edges = new(_vertices, (line * BlockVertices.Stride) + sample, fan.End);
        uint cells = CellsOf(line, sample);
        for (; ways != 0; ways &= ways - 1)
        {
            int way = BitOperations.TrailingZeroCount(ways);
            edges.Pass(fan.Directions[way], out uint isSouth, out uint isNorth);
            for (uint met = (isSouth | isNorth) & cells; met != 0; met &= met - 1)
            {
                int cell = sample + BitOperations.TrailingZeroCount(met);
                Vector3D nw = _vertices[line, cell] - fan.End;
                Vector3D se = _vertices[line + 1, cell + 1] - fan.End;
                uint bit = met & (uint)-(int)met;
                if ((isSouth & bit) != 0)
                {
                    fan.Take(way, nw, _vertices[line + 1, cell] - fan.End, se, GroundTree.Gap);
                }

                if ((isNorth & bit) != 0)
                {
                    fan.Take(way, nw, se, _vertices[line, cell + 1] - fan.End, GroundTree.Gap);
                }
            }
        }
    }

    private uint CellsOf(int line, int sample) =>
        (_vertices.CellsOfLine(line) >> sample) & (uint)((1UL << Math.Min(Edge, _vertices.Samples - 1 - sample)) - 1);

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
}
