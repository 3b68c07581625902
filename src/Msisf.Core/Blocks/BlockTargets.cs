using Msisf.Core.Render.Shadows;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;

namespace Msisf.Core.Blocks;

/// <summary>Bounds, in light space, of blocks on which a shadow may be seen.</summary>
internal sealed class BlockTargets : IReceiverBounds
{
    private const int Bins = 128;

    private readonly LightAxis _u;
    private readonly LightAxis _v;
    private readonly double[] _depths = new double[Bins * Bins];

    /// <param name="sunBodyFixed">The Sun's centre, m, body-fixed.</param>
    public BlockTargets(SurfaceModel surface, IEnumerable<CellBlock> blocks, Vector3D sunBodyFixed)
    {
        MoonHorizon fromSun = new(sunBodyFixed, innerRadius: 0.0);
        (TerrainNode Node, double CellAngle)[] nodes = [.. blocks.Select(block => NodeOf(surface, block))];
        Vector3D middle = default;
        foreach ((TerrainNode node, _) in nodes)
        {
            middle += node.Cap.Centre;
        }

        Frame = new LightFrame(sunBodyFixed, middle);
        List<LightBounds> targets = [];
        Box = LightBox.Empty;
        foreach ((TerrainNode node, double cellAngle) in nodes)
        {
            NodeBox box = new(node.Cap.Centre, new SineCosine(node.Cap.SinRadius, node.Cap.CosRadius), default);
            if (!fromSun.IsTurnedAway(box, node.MinRadius, node.MaxSlope + cellAngle)) // else black without any shadow
            {
                LightBounds bounds = LightBounds.Of(Frame, node);
                targets.Add(bounds);
                Box = LightBox.Union(Box, bounds.Box);
            }
        }

        _u = new LightAxis(Box.MinU, Box.MaxU, Bins);
        _v = new LightAxis(Box.MinV, Box.MaxV, Bins);
        Array.Fill(_depths, double.NegativeInfinity);
        foreach (LightBounds target in targets)
        {
            for (int row = _v.BinOf(target.Box.MinV); row <= _v.BinOf(target.Box.MaxV); row++)
            {
                for (int column = _u.BinOf(target.Box.MinU); column <= _u.BinOf(target.Box.MaxU); column++)
                {
                    ref double depth = ref _depths[(row * Bins) + column];
                    depth = Math.Max(depth, target.MaxDepth);
                }
            }
        }

        MaxDepth = targets.Select(target => target.MaxDepth).DefaultIfEmpty(double.NegativeInfinity).Max();
    }

    public LightFrame Frame { get; }

    public LightBox Box { get; }

    public double MaxDepth { get; }

    public double MaxDepthIn(in LightBox box)
    {
        double max = double.NegativeInfinity;
        int lastColumn = _u.BinOf(box.MaxU);
        int lastRow = _v.BinOf(box.MaxV);
        for (int row = _v.BinOf(box.MinV); row <= lastRow; row++)
        {
            for (int column = _u.BinOf(box.MinU); column <= lastColumn; column++)
            {
                max = Math.Max(max, _depths[(row * Bins) + column]);
            }
        }

        return max;
    }

    private static (TerrainNode Node, double CellAngle) NodeOf(SurfaceModel surface, CellBlock block)
    {
        Patch patch = surface.Patches[block.Part];
        return (patch.NodeOf(block.Node, patch.BoundsOf(block.Node)), patch.CellAngle);
    }
}
