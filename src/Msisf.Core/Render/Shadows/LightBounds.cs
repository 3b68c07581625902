using Msisf.Core.Surface;

namespace Msisf.Core.Render.Shadows;

/// <summary>Bounds of a piece of terrain in light space, m.</summary>
/// <param name="Box">Bounds across the Sun's rays.</param>
/// <param name="MinDepth">Minimum depth.</param>
/// <param name="MaxDepth">Maximum depth.</param>
internal readonly record struct LightBounds(LightBox Box, double MinDepth, double MaxDepth)
{
    /// <summary>
    /// Dimensionless margin for the rounding errors of directions, of cosines, of products of up to three of them, and of light space.
    /// </summary>
    public const double Rounding = 1e-12;

    /// <summary>The bounds of a node of the terrain.</summary>
    public static LightBounds Of(LightFrame frame, in TerrainNode node)
    {
        (double minW, double maxW) = Component(frame.AxisW, node);
        double minScale = frame.SunDistance / (frame.SunDistance + maxW);
        double maxScale = frame.SunDistance / (frame.SunDistance + minW);
        (double minU, double maxU) = Component(frame.AxisU, node);
        (double minV, double maxV) = Component(frame.AxisV, node);
        LightBox box = new(
            minU * (minU < 0.0 ? maxScale : minScale),
            maxU * (maxU < 0.0 ? minScale : maxScale),
            minV * (minV < 0.0 ? maxScale : minScale),
            maxV * (maxV < 0.0 ? minScale : maxScale));
        return new LightBounds(box, minW * maxScale, maxW * minScale);
    }

    /// <summary>Bounds, m, of one coordinate of all points of a node.</summary>
    private static (double Min, double Max) Component(Vector3D axis, in TerrainNode node)
    {
        SphericalCap cap = node.Cap;
        double cosine = Vector3D.Dot(cap.Centre, axis);
        double across = cap.SinRadius * Math.Sqrt(Math.Max(0.0, (1.0 - cosine) * (1.0 + cosine)));
        double along = cosine * cap.CosRadius;
        double low = (cosine <= -cap.CosRadius ? -1.0 : along - across) - Rounding;
        double high = (cosine >= cap.CosRadius ? 1.0 : along + across) + Rounding;
        return (low * (low < 0.0 ? node.MaxRadius : node.MinRadius), high * (high < 0.0 ? node.MinRadius : node.MaxRadius));
    }
}
