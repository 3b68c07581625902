using Msisf.Benchmarks.Definitions;
using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.TestSupport.Images;

namespace Msisf.Benchmarks.Fronts;

/// <summary>
/// The truth of an image: the full model, nothing skipped, 64 samples a pixel on a regular grid, Lambert's law as in POV-Ray's scene. Drawn
/// by the native renderer, which shows the same facets as the exact tracer in every sample (docs/native-renderer.md).
/// </summary>
internal sealed class ImageTruth
{
    private const int SubsamplesPerAxis = 8;
    private const int White = 255;

    private ImageTruth(double[,] levels, double[,] litFractions, double[,] coverage)
    {
        Levels = levels;
        LinearGrey = SrgbCurve.Linear(levels);
        LitFractions = litFractions;
        Coverage = coverage;
    }

    /// <summary>Grey levels of 255, [y, x].</summary>
    public double[,] Levels { get; }

    /// <summary>The same as linear grey, 0 to 1.</summary>
    public double[,] LinearGrey { get; }

    /// <summary>Part of each pixel's samples that are lit, [y, x].</summary>
    public double[,] LitFractions { get; }

    /// <summary>Part of them that show the surface, [y, x].</summary>
    public double[,] Coverage { get; }

    /// <summary>Draws it.</summary>
    /// <param name="camera">Of the image.</param>
    /// <param name="sun">Its light.</param>
    /// <param name="model">The full model.</param>
    public static ImageTruth Draw(PinholeCamera camera, SceneLight sun, IGlobalGrid model)
    {
        NativeRenderer renderer = new(model);
        GreyScale grey = new();
        SceneLight lamp = new(camera.PositionBodyFixed, IsSun: false);
        double[,] Drawn(SceneLight light, IReflectance law, Func<double, double> value)
        {
            NativeRenderOptions options = new() { Reflectance = law, SubsamplesPerAxis = SubsamplesPerAxis };
            using NativeFrame frame = renderer.Render(camera, light, options, Environment.ProcessorCount, CancellationToken.None);
            double[,] values = new double[camera.Height, camera.Width];
            for (int i = 0; i < values.Length; i++)
            {
                values[i / camera.Width, i % camera.Width] = value(frame.RadianceFactors[i]);
            }

            return values;
        }

        return new ImageTruth(
            Drawn(sun, new LambertReflectance(PovRayScene.Albedo), radiance => grey.Level(radiance, White)),
            Drawn(sun, new EvenReflectance(), part => part),
            Drawn(lamp, new EvenReflectance(), part => part));
    }
}
