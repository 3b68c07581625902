using Msisf.Core.Camera;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Finds the cell blocks that an image may show. It reads the bounds only of blocks that cannot be excluded by their position alone.
/// </summary>
internal sealed class BlockCuller
{
    /// <summary>
    /// m: added on both sides to the radius limits of the model. It is more than the outward rounding of the block bounds, which are
    /// floats.
    /// </summary>
    private const double BoundsRounding = 1.0;

    private readonly SurfaceModel _surface;
    private readonly (double Min, double Max) _limits;
    private readonly BlockSearch<VisibleBlock> _search;

    public BlockCuller(SurfaceModel surface)
    {
        _surface = surface;
        _search = new BlockSearch<VisibleBlock>(surface);
        (double min, double max) = surface.RadiusLimits;
        _limits = (min - BoundsRounding, max + BoundsRounding);
    }

    /// <summary>Returns the blocks that may be visible, always in the same order; the list is valid until the next call.</summary>
    public List<VisibleBlock> Find(ViewFrustum frustum, int threads, CancellationToken cancellation) =>
        _search.Find(BoundsOf(frustum), threads, cancellation);

    /// <summary>Tells of single nodes whether an image may show them.</summary>
    public InImage BoundsOf(ViewFrustum frustum) =>
        new(frustum, new MoonHorizon(frustum.CameraBodyFixed, _surface.SolidRadius(_limits.Min)), _limits);

    /// <summary>What an image may show.</summary>
    internal readonly struct InImage(ViewFrustum frustum, MoonHorizon horizon, (double Min, double Max) limits)
        : IBlockTester<VisibleBlock>
    {
        /// <summary>Whether a node may be in the image if its blocks may have any radius within the limits of the model.</summary>
        public bool MayHold(Patch patch, NodePlace node)
        {
            NodeBox box = patch.BoxOf(node, limits.Min, limits.Max);
            return !horizon.Hides(box, limits.Max) && frustum.TryFindRows(box.Box, out _);
        }

        /// <summary>Whether a node may be in the image; its bounds are read if they were not yet.</summary>
        public bool MaySee(Patch patch, NodePlace node) => MaySee(patch, node, out _, out _);

        public bool TryFind(Patch patch, CellBlock block, out VisibleBlock found)
        {
            if (!MaySee(patch, block.Node, out PixelRows rows, out NodeBox box))
            {
                found = default;
                return false;
            }

            found = new VisibleBlock(block, rows, frustum.IsOfLens ? frustum.TangentsOf(box.Box) : default);
            return true;
        }

        public CellBlock BlockOf(VisibleBlock found) => found.Block;

        public VisibleBlock WithBlock(VisibleBlock found, CellBlock piece) => found with { Block = piece };

        private bool MaySee(Patch patch, NodePlace node, out PixelRows rows, out NodeBox box)
        {
            NodeBounds bounds = patch.BoundsOf(node);
            if (patch.ProductId is { } product && (bounds.Min < limits.Min || bounds.Max > limits.Max))
            {
                throw OutsideLimits(product, patch.Layout.Cells(node.Level, node.Row, node.Column), bounds);
            }

            rows = default;
            box = patch.BoxOf(node, bounds.Min, bounds.Max);
            return !horizon.Hides(box, bounds.Max) && !horizon.IsTurnedAway(patch, box, bounds) && frustum.TryFindRows(box.Box, out rows);
        }

        private BadInputException OutsideLimits(string product, CellRange cells, NodeBounds bounds) => new(Invariant(
            $"{product}, lines {cells.FirstLine + 1} to {cells.EndLine + 1}, samples {cells.FirstSample + 1} to {cells.EndSample + 1}: "
                + $"radii from {bounds.Min:R} to {bounds.Max:R} m, but no radius may lie outside {limits.Min:R} to {limits.Max:R} m. "
                + $"The file is damaged: get it again."));
    }
}

/// <summary>A cell block that may be visible in the image.</summary>
/// <param name="Rows">Image rows outside of which the block is not visible; not used with a lens.</param>
/// <param name="Tangents">The part of the ideal image plane outside of which the block is not visible; only used with a lens.</param>
internal readonly record struct VisibleBlock(CellBlock Block, PixelRows Rows, TangentBox Tangents);
