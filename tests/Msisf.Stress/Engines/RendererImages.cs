using Msisf.TestSupport;

namespace Msisf.Stress.Engines;

/// <summary>A scene by both renderers.</summary>
/// <param name="Scene">The arguments that make it.</param>
/// <param name="Distance">m, from the Moon's centre to the camera.</param>
/// <param name="PovRay">8 bit.</param>
/// <param name="Native">8 bit, of the same size.</param>
internal sealed record RendererImages(string Scene, double Distance, PngPixels PovRay, PngPixels Native)
{
    /// <summary>Grey levels: the two round the same brightness.</summary>
    private const int SameGrey = 1;

    /// <summary>How many there are.</summary>
    public int PixelCount => PovRay.Width * PovRay.Height;

    /// <summary>Those that differ by more than rounding, by rows.</summary>
    public IReadOnlyList<(int X, int Y, int PovRay, int Native)> Differences { get; } =
    [
        .. from y in Enumerable.Range(0, PovRay.Height)
           from x in Enumerable.Range(0, PovRay.Width)
           let levels = (PovRay: PovRay[x, y, 0], Native: Native[x, y, 0])
           where Math.Abs(levels.PovRay - levels.Native) > SameGrey
           select (x, y, levels.PovRay, levels.Native),
    ];
}
