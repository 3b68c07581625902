using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>Bounds of all points of some nodes that do not lie in the night zone.</summary>
internal sealed class BlockReceivers : IReceiverBounds
{
    /// <summary>Number of bins along each edge of the grid: more than there are blocks along the edge of most images.</summary>
    private const int Size = 128;

    /// <summary>m: the night zone begins at the depth 0; above it by more than rounding.</summary>
    private const float Dusk = (float)SureLight.Margin;

    private readonly DepthGrid _depths = new();

    /// <summary>Finds the bounds.</summary>
    /// <param name="places">The nodes; their bounds are known.</param>
    /// <param name="sunBodyFixed">The Sun's centre, m, body-fixed.</param>
    /// <param name="solidRadius">Radius of the night zone, m; 0 for none.</param>
    public BlockReceivers(SurfaceModel surface, IEnumerable<SurfaceNode> places, Vector3D sunBodyFixed, double solidRadius)
    {
        List<TerrainNode> nodes = [];
        Vector3D sum = default;
        foreach (SurfaceNode place in places)
        {
            Patch patch = surface.Patches[place.Part];
            nodes.Add(patch.NodeOf(place.Place, patch.BoundsOf(place.Place)));
            sum += nodes[^1].Cap.Centre;
        }

        Frame = new LightFrame(sunBodyFixed, sum);
        List<LightBounds> bounds = [.. nodes.Select(node => LightBounds.Of(Frame, node)).Where(node => !IsNight(node.Box, node.MinDepth))];
        Box = bounds.Aggregate(LightBox.Empty, (box, node) => LightBox.Union(box, node.Box));
        _depths.Lay(Box, Size, Size);
        _depths.Bins.AsSpan(0, Size * Size).Fill(float.NegativeInfinity);
        foreach (LightBounds node in bounds)
        {
            float depth = MathF.BitIncrement((float)node.MaxDepth);
            GridRange bins = _depths.BinsOf(node.Box);
            for (int row = bins.FirstRow; row <= bins.LastRow; row++)
            {
                for (int column = bins.FirstColumn; column <= bins.LastColumn; column++)
                {
                    ref float bin = ref _depths.Bins[(row * Size) + column];
                    bin = Math.Max(bin, depth > Dusk && IsNight(BoxOf(column, row), depth) ? Dusk : depth);
                }
            }
        }

        _depths.Finish();

        // What is that deep and so near to the axis of light lies in the night zone.
        bool IsNight(in LightBox box, double minDepth)
        {
            double u = Math.Max(Math.Abs(box.MinU), Math.Abs(box.MaxU));
            double v = Math.Max(Math.Abs(box.MinV), Math.Abs(box.MaxV));
            return minDepth >= Dusk && double.Hypot(u, v) < solidRadius - SureLight.Margin;
        }
    }

    public LightFrame Frame { get; }

    public LightBox Box { get; }

    public double MaxDepth => _depths.Max();

    public double MaxDepthIn(in LightBox box) => _depths.Max(_depths.BinsOf(in box));

    private LightBox BoxOf(int column, int row) => new(
        _depths.AxisU.StartOf(column), _depths.AxisU.StartOf(column + 1), _depths.AxisV.StartOf(row), _depths.AxisV.StartOf(row + 1));
}
