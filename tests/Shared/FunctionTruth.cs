using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Terrain;

namespace Msisf.TestSupport;

/// <summary>A frame whose pixels a function gives; null is space.</summary>
internal sealed class FunctionTruth(
    PinholeCamera camera, Vector3D lightPositionMoonMe, Func<int, int, (SurfaceHit Hit, PixelLight Light)?> pixelOf) : IFrameTruth
{
    private static readonly PixelLight[] Lights =
        [new(SunState.Lit, 1.0), new(SunState.Penumbra, 0.25), new(SunState.Shadow, 0.0), new(SunState.Night, 0.0)];

    public PinholeCamera Camera => camera;

    public Vector3D LightPositionMoonMe => lightPositionMoonMe;

    /// <summary>The reference sphere cut into cells of 4 px/deg; the states take turns from column to column.</summary>
    public static FunctionTruth OfSphere(PinholeCamera camera, Vector3D lightPositionMoonMe) =>
        new(camera, lightPositionMoonMe, (x, y) =>
        {
            if (!ReferenceSphere.Lola.TryFirstHit(camera.RayThrough(x, y), out Vector3D point))
            {
                return null;
            }

            SelenographicPoint below = SelenographicPoint.Below(point);
            int line = (int)((90.0 - double.RadiansToDegrees(below.Latitude)) * 4.0);
            int sample = (int)(double.RadiansToDegrees(below.Longitude) * 4.0);
            SurfaceHit hit = new(point, point.Normalized(), new FacetId(line, sample, (FacetHalf)(y % 2)), 1.0);
            return (hit, Lights[x % Lights.Length]);
        });

    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelLight light)
    {
        (SurfaceHit Hit, PixelLight Light)? pixel = pixelOf(x, y);
        (hit, light) = pixel ?? default;
        return pixel is not null;
    }
}
