using Msisf.Core.Camera;
using Msisf.Core.Detector;

namespace Msisf.App.Rendering;

/// <summary>
/// A camera with the view of another one and few pixels, each of which gets the electrons of one pixel of the other: its pixels are
/// larger, and its aperture is smaller by as much. Drawn fast, it tells the levels of an image. Blur, defects and noise are left out.
/// </summary>
/// <param name="Model">Its geometry.</param>
internal sealed record ReducedCamera(CameraModel Model, DetectorSettings Detector)
{
    /// <summary>px: longer side of the small image.</summary>
    public const int LongerSide = 96;

    /// <summary>Reduces a camera; a small one keeps its size.</summary>
    public static ReducedCamera Of(CameraModel model, DetectorSettings detector)
    {
        CameraModel reduced = ModelOf(model, LongerSide);
        (double x, double y) = ((double)model.Width / reduced.Width, (double)model.Height / reduced.Height);
        return new ReducedCamera(reduced, detector with
        {
            ApertureArea = detector.ApertureArea / (x * y),
            PointSpread = null,
            FarWings = null,
            Shutter = null,
            CosmicRays = null,
            DeadPixels = [],
            Dark = detector.Dark with { HotPixels = [] },
            Smear = detector.Smear is { } smear ? smear with { RowTime = smear.RowTime * y } : null,
            IsBlooming = false,
            Seed = null,
        });
    }

    /// <summary>The geometry of a camera with the same view and fewer pixels; a small one keeps its size.</summary>
    /// <param name="longerSide">px: maximum width and height.</param>
    public static CameraModel ModelOf(CameraModel model, int longerSide)
    {
        double reduction = Math.Max(1.0, (double)Math.Max(model.Width, model.Height) / longerSide);
        int width = Math.Max(1, (int)Math.Round(model.Width / reduction));
        int height = Math.Max(1, (int)Math.Round(model.Height / reduction));
        (double x, double y) = ((double)model.Width / width, (double)model.Height / height);
        return new CameraModel(
            width,
            height,
            (model.FocalX / x, model.FocalY / y),
            (Reduced(model.PrincipalX, x), Reduced(model.PrincipalY, y)),
            model.Skew / x,
            model.Distortion).Simplified();

        // Rendering coordinates are 0.5 at the image's border.
        static double Reduced(double principal, double reduction) => ((principal - 0.5) / reduction) + 0.5;
    }
}
