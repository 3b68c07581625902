using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render;

/// <summary>Chooses the level of a model that an image is drawn with.</summary>
public static class LevelOfDetail
{
    /// <summary>
    /// px: half of what a cell of a coarser level may be wide, if nothing else is asked for, beside a sample of the nearest ground. Measured
    /// (docs/native-renderer.md): the image is as near to the mean of many samples of the full model as one of the full model with as many samples is.
    /// </summary>
    public const double DefaultErrorPixels = 0.35;

    /// <summary>The level: 0 is the model itself, each further one has half the resolution.</summary>
    /// <param name="camera">Decides by its height over the reference sphere: no ground in the image is nearer but for mountains.</param>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    /// <param name="pixelsPerDegree">Of the model.</param>
    /// <param name="levels">How many levels there are, the model itself included.</param>
    /// <param name="errorPixels">So far, in samples, may a level move what is seen: a cell is at most twice as wide.</param>
    public static int For(PinholeCamera camera, int subsamplesPerAxis, int pixelsPerDegree, int levels, double errorPixels = DefaultErrorPixels)
    {
        double height = camera.PositionMoonMe.Length - MoonConstants.ReferenceRadius;
        double pixel = 2.0 * Math.Tan(camera.FieldOfView / 2.0) / camera.Width;
        double widest = 2.0 * errorPixels * height * pixel / subsamplesPerAxis;
        return LodLevels.CoarsestWithin(widest, pixelsPerDegree, levels);
    }
}
