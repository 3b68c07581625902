using System.Globalization;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Mesh;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

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
    private readonly double _sagitta;
    private readonly double _tilt;
    private readonly List<CellBlock> _candidates = [];
    private readonly List<VisibleBlock> _visible = [];
    private VisibleBlock?[] _found = [];

    public BlockCuller(SurfaceModel surface)
    {
        _surface = surface;
        (double min, double max) = surface.Grid.RadiusLimits;
        _limits = (min - BoundsRounding, max + BoundsRounding);
        _sagitta = surface.Geometry.Sagitta;
        _tilt = surface.Geometry.CellAngle; // up turns by less from a facet's middle to its corners
    }

    /// <summary>Returns the blocks that may be visible, always in the same order; the list is valid until the next call.</summary>
    public List<VisibleBlock> Find(ImageView view, int threads, CancellationToken cancellation)
    {
        ViewFrustum frustum = view.Frustum();
        MoonHorizon horizon = new(view.Camera.PositionMoonMe, _surface.SolidRadius(_limits.Min));
        _candidates.Clear();
        int top = _surface.Bounds.Layout.Levels - 1;
        for (int row = 0; row < _surface.Bounds.Layout.Rows(top); row++)
        {
            for (int column = 0; column < _surface.Bounds.Layout.Columns(top); column++)
            {
                Descend(top, row, column, frustum, horizon);
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
                _visible.Add(block);
            }
        }

        return _visible;
    }

    /// <summary>
    /// Collects the blocks of a node that may be in the image if each may have any radius within the limits of the model.
    /// </summary>
    private void Descend(int level, int row, int column, ViewFrustum frustum, MoonHorizon horizon)
    {
        NodeBox box = _surface.Bounds.BoxOf(level, row, column, _limits.Min, _limits.Max);
        if (horizon.Hides(box, _limits.Max) || !frustum.TryFindRows(box.Box, out _))
        {
            return;
        }

        if (level == SquareLayout.CellBlockLevel)
        {
            _candidates.Add(new CellBlock(row, column));
            return;
        }

        // The children are visited quarter by quarter, and each quarter again by its quarters, so that successive blocks are neighbours.
        NodeRange children = _surface.Bounds.Layout.ChildrenOf(level, row, column);
        for (int child = 0; child < SquareLayout.GroupBlocks; child++)
        {
            int childRow = children.FirstRow + ((child >> 2) & 2) + ((child >> 1) & 1);
            int childColumn = children.FirstColumn + ((child >> 1) & 2) + (child & 1);
            if (childRow < children.EndRow && childColumn < children.EndColumn)
            {
                Descend(level - 1, childRow, childColumn, frustum, horizon);
            }
        }
    }

    private VisibleBlock? Look(CellBlock block, ViewFrustum frustum, MoonHorizon horizon)
    {
        NodeBounds bounds = _surface.Bounds.Of(SquareLayout.CellBlockLevel, block.Row, block.Column);
        if (bounds.Min < _limits.Min || bounds.Max > _limits.Max)
        {
            throw OutsideLimits(block, bounds);
        }

        NodeBox box = _surface.Bounds.BoxOf(SquareLayout.CellBlockLevel, block.Row, block.Column, bounds.Min, bounds.Max);
        if (horizon.Hides(box, bounds.Max)
            || horizon.IsTurnedAway(box, LowestPoint(bounds.Min), bounds.MaxSlope + _tilt)
            || !frustum.TryFindRows(box.Box, out PixelRows rows))
        {
            return null;
        }

        return new VisibleBlock(block, rows, frustum.IsOfLens ? frustum.TangentsOf(box.Box) : default);
    }

    private BadInputException OutsideLimits(CellBlock block, NodeBounds bounds)
    {
        CellRange cells = block.Cells(_surface.Mesh);
        return new BadInputException(string.Create(
            CultureInfo.InvariantCulture,
            $"{_surface.Grid.ProductId}, lines {cells.FirstLine + 1} to {cells.EndLine + 1}, "
                + $"samples {cells.FirstSample + 1} to {cells.EndSample + 1}: "
                + $"radii from {bounds.Min:R} to {bounds.Max:R} m, but no radius may lie outside {_limits.Min:R} to {_limits.Max:R} m. "
                + $"The file is damaged: get it again."));
    }

    private double LowestPoint(double minRadius) => (minRadius * _sagitta) - Tolerances.VertexLattice;
}
