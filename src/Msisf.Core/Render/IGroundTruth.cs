using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>What the pixels of one frame show, exactly. Safe for several threads.</summary>
public interface IGroundTruth
{
    /// <summary>The frame's camera.</summary>
    PinholeCamera Camera { get; }

    /// <summary>The Sun, or the lamp that stands for it, m, MOON_ME.</summary>
    Vector3D LightPositionMoonMe { get; }

    /// <summary>The surface on the ray through a pixel's centre (<see cref="PinholeCamera.RayThrough"/>).</summary>
    /// <param name="x">1 to the image's width, to the right.</param>
    /// <param name="y">1 to the image's height, down.</param>
    /// <param name="hit">What is met; <c>default</c> if nothing is.</param>
    /// <param name="light">How it is lit.</param>
    /// <returns>Whether the pixel shows the surface.</returns>
    bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light);
}
