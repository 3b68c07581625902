using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Surface;
using Msisf.Core.Tracing;

namespace Msisf.TestSupport;

/// <summary>A frame whose pixels a function gives; null is space.</summary>
internal sealed class FunctionTruth(
    ICamera camera, Vector3D lightPositionBodyFixed, Func<int, int, (SurfaceHit Hit, PixelIllumination Light)?> pixelOf) : IGroundTruth
{
    private static readonly PixelIllumination[] Lights =
        [new(IlluminationState.Lit, 1.0), new(
            IlluminationState.Penumbra, 0.25), new(IlluminationState.Shadow, 0.0), new(IlluminationState.Night, 0.0)];

    public ICamera Camera => camera;

    public SceneLight Light => new(lightPositionBodyFixed, IsSun: true);

    public double[] Factors { get; init; } = [];

    public ReadOnlySpan<double> RadianceFactors => Factors;

    /// <summary>
    /// A <see cref="SphereTruth"/> of 4 px/deg that shows all there is: the states take turns from column to column, the halves from row to
    /// row.
    /// </summary>
    public static FunctionTruth OfSphere(ICamera camera, Vector3D lightPositionBodyFixed)
    {
        SphereTruth sphere = new(camera, lightPositionBodyFixed, pixelsPerDegree: 4);
        return new FunctionTruth(camera, lightPositionBodyFixed, (x, y) => sphere.TryGet(x, y, out SurfaceHit hit, out _)
            ? (hit with { Facet = hit.Facet with { Half = (FacetHalf)(y % 2) } }, Lights[x % Lights.Length])
            : null);
    }

    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        (SurfaceHit Hit, PixelIllumination Light)? pixel = pixelOf(x, y);
        (hit, light) = pixel ?? default;
        return pixel is not null;
    }
}
