using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Tests.Support;
using Msisf.Stress.Time;
using Msisf.TestSupport;

namespace Msisf.Stress.Engines;

/// <summary>The native renderer against POV-Ray, without antialiasing: one ray a pixel, through the same facets.</summary>
public sealed class RendererStress : IStressTest
{
    /// <summary>
    /// 1, part of an image: as for the images of <c>NativeImageTests</c>. A ray, or a ray to the Sun, that passes an edge closer than
    /// POV-Ray's 32-bit floats are apart may fall to its other side.
    /// </summary>
    private const double MaxDiffering = 0.001;

    /// <summary>Other scenes for another seed.</summary>
    private const int Seeds = 1000;

    /// <inheritdoc/>
    public string Name => "renderers";

    /// <inheritdoc/>
    public string Subject =>
        "The two renderers, native and POV-Ray, on LDEM_4 without antialiasing and levels of detail: "
            + "images of 64 x 64 or as many pixels (256 x 256 at full length) by cameras of twelve kinds, "
            + "from 50 m over the ground to 1e9 m, at the poles, on the seam, along the limb, fields of view from 0.001 to 175 degrees, "
            + "at random times of the local day.";

    /// <inheritdoc/>
    public string? MissingPart =>
        TestParts.Ldem4Label is null ? "LDEM_4 (msis fetch ldem)" : TestParts.Program("povray") is null ? "POV-Ray" : null;

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        (int scenes, int size) = length == StressLength.Full ? (6 * CameraCases.Kinds, 256 * 256) : (2, 64 * 64);
        using TemporaryFolder folder = new();
        using LdemImage grid = LdemImage.Open(LdemLabelReader.ReadFile(TestParts.Ldem4Label!));
        using BuiltInKernels kernels = ProjectKernels.Open();
        RendererScenes renderers = new(folder, grid, kernels.Ephemeris, size);
        CaseRandom random = new(seed, part: 0);
        WorstCase share = new();
        WorstCase level = new();
        SeriesBuilder overDistance = new(1.7e6, 1.2e9, 12, isLogarithmic: true);
        long pixels = 0;
        for (int i = 0; i < scenes; i++)
        {
            RendererImages images = renderers.Draw(Camera(i) + (CameraCases.Kinds * (seed % Seeds)), random);
            double differing = (double)images.Differences.Count / images.PixelCount;
            pixels += images.PixelCount;
            overDistance.Add(images.Distance, differing);
            share.Note(differing, () => Input(images));
            level.Note(
                images.Differences.Select(pixel => Math.Abs(pixel.PovRay - pixel.Native)).DefaultIfEmpty().Max(), () => Input(images));
        }

        return new StressReport(
            Name,
            pixels,
            [
                share.ToFigure("part of an image's pixels that differ by more than one grey level", "1", MaxDiffering),
                level.ToFigure("greatest difference of a pixel, at an edge or a leak", "grey levels of 255", null),
            ],
            [overDistance.ToSeries(
                "part of an image's pixels that differ", "1", "distance of the camera from the Moon's centre", "m", MaxDiffering)]);
    }

    /// <summary>All kinds in turn, beginning with a view from 100 km and one of the seam: few tiles, much ground.</summary>
    private static int Camera(int number) =>
        (number / CameraCases.Kinds * CameraCases.Kinds) + (((7 * number) + 2) % CameraCases.Kinds);

    private static string Input(RendererImages images) =>
        $"{images.Scene}, {images.PixelCount} pixels; {images.Differences.Count} differ: "
        + string.Join(
            "; ", images.Differences.Take(5).Select(pixel => $"({pixel.X}, {pixel.Y}) POV-Ray {pixel.PovRay}, native {pixel.Native}"));
}
