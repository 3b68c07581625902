using Msisf.Core.Numerics;
using Msisf.Core.Scene;

namespace Msisf.Core.Render;

/// <summary>The Sun as a pixel's surface point sees it; <c>default</c> is a pixel without surface.</summary>
/// <param name="State">Lit, penumbra, shadow or night.</param>
/// <param name="VisibleFraction">Part of the Sun's disc that is not hidden by terrain, 0 to 1.</param>
public readonly record struct PixelIllumination(IlluminationState State, double VisibleFraction)
{
    /// <summary>The light at a point of the surface that a camera sees.</summary>
    /// <param name="pointMoonMe">m, MOON_ME.</param>
    /// <param name="visibleFraction">
    /// Of the Sun, 0 to 1; a Sun that is a point is seen wholly or not at all. Means nothing with a lamp.
    /// </param>
    /// <param name="light">The Sun, or the lamp at the camera, which lights all that the camera sees.</param>
    public static PixelIllumination At(Vector3D pointMoonMe, double visibleFraction, SceneLight light)
    {
        if (!light.IsSun || visibleFraction >= 1.0)
        {
            return new PixelIllumination(IlluminationState.Lit, 1.0);
        }

        if (visibleFraction > 0.0)
        {
            return new PixelIllumination(IlluminationState.Penumbra, visibleFraction);
        }

        bool isAboveHorizon = Vector3D.Dot(pointMoonMe, light.PositionMoonMe - pointMoonMe) > 0.0;
        return new PixelIllumination(isAboveHorizon ? IlluminationState.Shadow : IlluminationState.Night, 0.0);
    }
}
