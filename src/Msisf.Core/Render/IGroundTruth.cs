using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>Ground truth of one frame: the exact surface point and illumination at each pixel's centre. Safe for several threads.</summary>
public interface IGroundTruth
{
    /// <summary>The frame's camera.</summary>
    ICamera Camera { get; }

    /// <summary>The Sun, or the lamp at the camera that replaces it; <see cref="SceneLight.At"/> has the light of a row.</summary>
    SceneLight Light { get; }

    /// <summary>
    /// Radiance factor I/F of each pixel, by rows from the top, each from left to right; 0 where there is no surface or no light. Empty if
    /// the renderer does not know them.
    /// </summary>
    ReadOnlySpan<double> RadianceFactors { get; }

    /// <summary>The part of <see cref="RadianceFactors"/> that is light from the ground; empty if it was not asked for.</summary>
    ReadOnlySpan<double> IndirectFactors => [];

    /// <summary>Electrons of each pixel in the detector, before noise, by rows; empty without a detector.</summary>
    ReadOnlySpan<double> Electrons => [];

    /// <summary>Saturation of each pixel of the detector, by rows; empty without a detector.</summary>
    ReadOnlySpan<byte> Saturated => [];

    /// <summary>Number of the crater that each pixel shows, by rows, 0 for none; empty without a catalogue of craters.</summary>
    ReadOnlySpan<int> CraterNumbers => [];

    /// <summary>Number of the object that each pixel shows, by rows; empty without a sky.</summary>
    ReadOnlySpan<int> ObjectNumbers => [];

    /// <summary>Rows that are known at once; rows are best asked for from the top, in parts of so many.</summary>
    int RowsAtOnce => Camera.Height;

    /// <summary>I/F of the pixels of a row, from 0; empty if the renderer does not know it.</summary>
    internal ReadOnlySpan<double> RadianceFactorsOf(int row) => RowOf(RadianceFactors, row);

    /// <summary>I/F of the pixels of a row that is light from the ground; empty if it was not asked for.</summary>
    internal ReadOnlySpan<double> IndirectFactorsOf(int row) => RowOf(IndirectFactors, row);

    /// <summary>Electrons of the pixels of a row, from 0; empty without a detector.</summary>
    internal ReadOnlySpan<double> ElectronsOf(int row) => RowOf(Electrons, row);

    /// <summary>Saturation of the pixels of a row, from 0; empty without a detector.</summary>
    internal ReadOnlySpan<byte> SaturatedOf(int row) => RowOf(Saturated, row);

    private ReadOnlySpan<T> RowOf<T>(ReadOnlySpan<T> image, int row) =>
        image.IsEmpty ? [] : image.Slice(row * Camera.Width, Camera.Width);

    /// <summary>Gets the surface point on the ray through a pixel's centre (<see cref="ICamera.RayThrough"/>).</summary>
    /// <param name="x">1 to the image's width, to the right.</param>
    /// <param name="y">1 to the image's height, down.</param>
    /// <param name="hit">The surface point; <c>default</c> if the ray meets no surface.</param>
    /// <returns>Whether the pixel shows the surface.</returns>
    bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light);

    /// <summary>Gets the surface points of a row; each has the bits of <see cref="TryGet"/>.</summary>
    /// <param name="y">1 to the image's height, down.</param>
    /// <param name="row">Receives the points.</param>
    internal void ReadRow(int y, TruthRow row)
    {
        row.Clear(Camera.Width);
        for (int x = 1; x <= Camera.Width; x++)
        {
            if (TryGet(x, y, out SurfaceHit hit, out PixelIllumination light))
            {
                row.Add(x - 1, hit, light);
            }
        }
    }
}
