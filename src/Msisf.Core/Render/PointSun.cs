using Msisf.Core.Numerics;
using Msisf.Core.Scene;

namespace Msisf.Core.Render;

/// <summary>How a point is lit by a Sun that is a point, or by the lamp at the camera.</summary>
internal static class PointSun
{
    /// <summary>The light at a point that a camera sees.</summary>
    /// <param name="pointMoonMe">m, MOON_ME.</param>
    /// <param name="isDark">Its facet turns away from the light, or other terrain hides the light; means nothing with the lamp.</param>
    /// <param name="light">The Sun, or the lamp, which lights all that its camera sees.</param>
    public static PixelLight At(Vector3D pointMoonMe, bool isDark, SceneLight light)
    {
        if (!light.IsSun || !isDark)
        {
            return new PixelLight(SunState.Lit, 1.0);
        }

        bool isAboveHorizon = Vector3D.Dot(pointMoonMe, light.PositionMoonMe - pointMoonMe) > 0.0;
        return new PixelLight(isAboveHorizon ? SunState.Shadow : SunState.Night, 0.0);
    }
}
