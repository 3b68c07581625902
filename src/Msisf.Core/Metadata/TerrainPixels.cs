using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;
using Msisf.Core.Tracing;

namespace Msisf.Core.Metadata;

/// <summary>Pixels on the terrain that the image shows. As safe for several threads as its truth.</summary>
internal sealed class TerrainPixels : IPixelView
{
    private readonly IGroundTruth _truth;
    private readonly int? _pixelsPerDegree;
    private readonly bool _namesParts;
    private readonly double _referenceRadius;

    /// <summary>Prepares a frame.</summary>
    /// <param name="truth">What its pixels show.</param>
    /// <param name="pixelsPerDegree">Resolution of the elevation model, px/deg: names the tiles; null for a model without tiles.</param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    /// <param name="namesParts">Whether the terrain has several models, so that records name the one of their facet.</param>
    public TerrainPixels(IGroundTruth truth, int? pixelsPerDegree, double referenceRadius, bool namesParts = false)
    {
        _referenceRadius = referenceRadius;
        ArgumentOutOfRangeException.ThrowIfLessThan(pixelsPerDegree ?? 1, 1, nameof(pixelsPerDegree));
        _truth = truth;
        _pixelsPerDegree = pixelsPerDegree;
        _namesParts = namesParts;
    }

    public PixelSurface Surface => PixelSurface.Terrain;

    public bool TryGet(int h, int v, out PixelRecord record)
    {
        if (!_truth.TryGet(h, v, out SurfaceHit hit, out PixelIllumination light))
        {
            record = default;
            return false;
        }

        FrameCamera camera = _truth.Camera.BandAt(v).Camera;
        Vector3D point = hit.PointBodyFixed;
        Vector3D lightPosition = _truth.Light.At(_truth.Camera, v).PositionBodyFixed;
        TerrainRecord terrain = new(
            point.Length - _referenceRadius,
            point,
            (point - camera.PositionBodyFixed).Length,
            hit.NormalBodyFixed,
            PhotometricAngles.At(point, hit.NormalBodyFixed, camera.PositionBodyFixed, lightPosition),
            light,
            _pixelsPerDegree is { } resolution ? TileId.Holding(hit.Facet, resolution) : null,
            hit.Facet)
        {
            NamesPart = _namesParts,
        };
        double? direction = IlluminationDirection.At(camera, _truth.Camera.RayThrough(h, v).Direction, point, lightPosition);
        record = new PixelRecord(h, v, SelenographicPoint.Below(point), direction, terrain);
        return true;
    }
}
