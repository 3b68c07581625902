using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Parallel;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Finds the cell blocks that an image may show. It reads the bounds only of blocks that cannot be excluded by their position alone.
/// </summary>
internal sealed class BlockCuller
{
    /// <summary>Number of blocks in one work item of a thread.</summary>
    private const int BlocksAtOnce = 256;

    /// <summary>
    /// m: added on both sides to the radius limits of the model. It is more than the outward rounding of the block bounds, which are
    /// floats.
    /// </summary>
    private const double BoundsRounding = 1.0;

    private readonly SurfaceModel _surface;
    private readonly (double Min, double Max) _limits;
    private readonly List<CellBlock> _candidates = [];
    private readonly List<VisibleBlock> _visible = [];
    private VisibleBlock?[] _found = [];

    public BlockCuller(SurfaceModel surface)
    {
        _surface = surface;
        (double min, double max) = surface.RadiusLimits;
        _limits = (min - BoundsRounding, max + BoundsRounding);
    }

    /// <summary>Returns the blocks that may be visible, always in the same order; the list is valid until the next call.</summary>
    public List<VisibleBlock> Find(ViewFrustum frustum, int threads, CancellationToken cancellation)
    {
        MoonHorizon horizon = new(frustum.CameraMoonMe, _surface.SolidRadius(_limits.Min));
        _candidates.Clear();
        for (int part = 0; part < _surface.Parts.Count; part++)
        {
            if (_surface.Parts[part].IsLeftOut)
            {
                continue;
            }

            BoundsLayout layout = _surface.Parts[part].Bounds.Layout;
            int top = layout.Levels - 1;
            for (int row = 0; row < layout.Rows(top); row++)
            {
                for (int column = 0; column < layout.Columns(top); column++)
                {
                    Descend(part, top, row, column, frustum, horizon);
                }
            }
        }

        if (_found.Length < _candidates.Count)
        {
            _found = new VisibleBlock?[_candidates.Count + (_candidates.Count / 2)];
        }

        int parts = (_candidates.Count + BlocksAtOnce - 1) / BlocksAtOnce;
        WorkerTeam.Run(threads, parts, (_, part) =>
        {
            int end = Math.Min(_candidates.Count, (part + 1) * BlocksAtOnce);
            for (int i = part * BlocksAtOnce; i < end; i++)
            {
                _found[i] = Look(_candidates[i], frustum, horizon);
            }
        }, cancellation);

        _visible.Clear();
        for (int i = 0; i < _candidates.Count; i++)
        {
            if (_found[i] is { } block)
            {
                Add(block);
            }
        }

        AddSeams(frustum, horizon);
        return _visible;
    }

    /// <summary>Adds a block, or the pieces of it that finer models have left.</summary>
    private void Add(VisibleBlock visible)
    {
        CellBlock block = visible.Block;
        if (_surface.Parts[block.Part].Kept is not { } kept || kept.StateOf(block.Row, block.Column) == CellMask.BlockState.Whole)
        {
            _visible.Add(visible);
            return;
        }

        (int first, int count) = kept.PiecesOf(block.Row, block.Column);
        for (int piece = first; piece < first + count; piece++)
        {
            _visible.Add(visible with { Block = block with { Piece = piece + 1 } });
        }
    }

    private void AddSeams(ViewFrustum frustum, MoonHorizon horizon)
    {
        for (int number = 0; number < _surface.Seams.Blocks.Count; number++)
        {
            SeamBlock seam = _surface.Seams.Blocks[number];
            if (!horizon.Hides(seam.Box, seam.MaxRadius) && frustum.TryFindRows(seam.Box.Box, out PixelRows rows))
            {
                CellBlock block = new(0, number) { Part = _surface.Parts.Count };
                _visible.Add(new VisibleBlock(block, rows, frustum.IsOfLens ? frustum.TangentsOf(seam.Box.Box) : default));
            }
        }
    }

    /// <summary>
    /// Collects the blocks of a node that may be in the image if each may have any radius within the limits of the model.
    /// </summary>
    private void Descend(int part, int level, int row, int column, ViewFrustum frustum, MoonHorizon horizon)
    {
        BoundsTree tree = _surface.Parts[part].Bounds;
        NodeBox box = tree.BoxOf(level, row, column, _limits.Min, _limits.Max);
        if (horizon.Hides(box, _limits.Max) || !frustum.TryFindRows(box.Box, out _))
        {
            return;
        }

        if (level == SquareLayout.CellBlockLevel)
        {
            if (_surface.Parts[part].Kept?.StateOf(row, column) != CellMask.BlockState.Empty)
            {
                _candidates.Add(new CellBlock(row, column) { Part = part });
            }

            return;
        }

        // The children are visited quarter by quarter, and each quarter again by its quarters, so that successive blocks are neighbours.
        NodeRange children = tree.Layout.ChildrenOf(level, row, column);
        for (int child = 0; child < SquareLayout.GroupBlocks; child++)
        {
            int childRow = children.FirstRow + ((child >> 2) & 2) + ((child >> 1) & 1);
            int childColumn = children.FirstColumn + ((child >> 1) & 2) + (child & 1);
            if (childRow < children.EndRow && childColumn < children.EndColumn)
            {
                Descend(part, level - 1, childRow, childColumn, frustum, horizon);
            }
        }
    }

    /// <remarks>From a facet's middle to its corners, up turns by less than the angle of a cell.</remarks>
    private VisibleBlock? Look(CellBlock block, ViewFrustum frustum, MoonHorizon horizon)
    {
        GridPatch part = _surface.Parts[block.Part];
        NodeBounds bounds = part.Bounds.Of(SquareLayout.CellBlockLevel, block.Row, block.Column);
        if (bounds.Min < _limits.Min || bounds.Max > _limits.Max)
        {
            throw OutsideLimits(part, block, bounds);
        }

        NodeBox box = part.Bounds.BoxOf(SquareLayout.CellBlockLevel, block.Row, block.Column, bounds.Min, bounds.Max);
        if (horizon.Hides(box, bounds.Max)
            || horizon.IsTurnedAway(box, LowestPoint(part, bounds.Min), bounds.MaxSlope + part.Geometry.CellAngle)
            || !frustum.TryFindRows(box.Box, out PixelRows rows))
        {
            return null;
        }

        return new VisibleBlock(block, rows, frustum.IsOfLens ? frustum.TangentsOf(box.Box) : default);
    }

    private BadInputException OutsideLimits(GridPatch part, CellBlock block, NodeBounds bounds)
    {
        CellRange cells = block.Cells(part.Mesh);
        return new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"{part.Grid.ProductId}, lines {cells.FirstLine + 1} to {cells.EndLine + 1}, "
                + $"samples {cells.FirstSample + 1} to {cells.EndSample + 1}: "
                + $"radii from {bounds.Min:R} to {bounds.Max:R} m, but no radius may lie outside {_limits.Min:R} to {_limits.Max:R} m. "
                + $"The file is damaged: get it again."));
    }

    private static double LowestPoint(GridPatch part, double minRadius) =>
        (minRadius * part.Geometry.Sagitta) - Tolerances.VertexLattice;
}
