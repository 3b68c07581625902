using Msisf.Core.Camera;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Navigation;

/// <summary>The ground in a direction from the Moon's centre, on the facets that images show. Thread-safe.</summary>
internal sealed class GroundBelow(ITerrain terrain)
{
    /// <summary>m above the highest ground, from where it is looked for.</summary>
    private const double Above = 1e3;

    /// <summary>Follows single rays on the same facets.</summary>
    public TerrainTracer Tracer { get; } = new(terrain);

    /// <summary>Finds the ground.</summary>
    /// <param name="direction">Length 1, body-fixed.</param>
    /// <returns>False where a map of a part has none.</returns>
    public bool TryFind(Vector3D direction, out SurfaceHit ground) =>
        Tracer.TryTrace(new Ray((terrain.RadiusLimits.Max + Above) * direction, -direction), out ground);

    /// <summary>m from the Moon's centre to the ground; to the reference sphere where a map of a part has none.</summary>
    /// <param name="direction">Length 1, body-fixed.</param>
    public double RadiusAt(Vector3D direction) =>
        TryFind(direction, out SurfaceHit ground) ? ground.PointBodyFixed.Length : terrain.ReferenceRadius;
}
