using Msisf.TestSupport;

namespace Msisf.Integration.Tests.Run;

/// <summary>Where two 8-bit images of the same size differ, in their first channel.</summary>
internal sealed class ImageDifference
{
    private readonly PngPixels _expected;
    private readonly PngPixels _actual;
    private readonly int _sameGrey;

    /// <param name="expected">The reference.</param>
    /// <param name="actual">The image.</param>
    /// <param name="sameGrey">Grey levels that do not count as a difference; a pixel is black up to it if the other's is 0.</param>
    public ImageDifference(PngPixels expected, PngPixels actual, int sameGrey)
    {
        (_expected, _actual, _sameGrey) = (expected, actual, sameGrey);
        List<(int X, int Y)> offEdge = [];
        for (int y = 0; y < expected.Height; y++)
        {
            for (int x = 0; x < expected.Width; x++)
            {
                (int a, int b) = (expected[x, y, 0], actual[x, y, 0]);
                Black += a == 0 ? 1 : 0;
                if (Math.Abs(a - b) <= sameGrey)
                {
                    Rounded += a == b ? 0 : 1;
                    continue;
                }

                if (IsLeak(x, y))
                {
                    Leaks++;
                    continue;
                }

                BlackDiffers += Math.Min(a, b) == 0 ? 1 : 0;
                GreyDiffers += Math.Min(a, b) == 0 ? 0 : 1;
                if (!HasWithinAPixel(expected, x, y, b) || !HasWithinAPixel(actual, x, y, a))
                {
                    offEdge.Add((x, y));
                }
            }
        }

        OffEdge = offEdge;
    }

    /// <summary>Black pixels of the reference.</summary>
    public int Black { get; }

    /// <summary>Pixels that are black in one image only.</summary>
    public int BlackDiffers { get; }

    /// <summary>
    /// Pixels that are alone in being black, or alone in not being so, in the reference, and are as those around in the image: a ray, or
    /// a ray to the Sun, that meets the edge of two triangles to the last bits slips between them in POV-Ray. Seen closer, nothing is
    /// there.
    /// </summary>
    public int Leaks { get; }

    /// <summary>Pixels black in neither, whose greys differ.</summary>
    public int GreyDiffers { get; }

    /// <summary>Pixels that differ by what is allowed everywhere.</summary>
    public int Rounded { get; }

    /// <summary>Of those that differ, the ones whose grey the other image has nowhere within one pixel.</summary>
    public IReadOnlyList<(int X, int Y)> OffEdge { get; }

    public override string ToString() =>
        $"{_expected.Width} x {_expected.Height} px, {Black} black; {BlackDiffers} black in one image only, {GreyDiffers} of another grey, "
        + $"{Leaks} leaks of the reference, {Rounded} off by {_sameGrey} at most; {OffEdge.Count} of the differing ones at no edge: "
        + string.Join(' ', OffEdge.Take(5).Select(at => $"({at.X}, {at.Y}): {_expected[at.X, at.Y, 0]}, {_actual[at.X, at.Y, 0]};"));

    private bool IsLeak(int x, int y)
    {
        bool isBlack = _expected[x, y, 0] == 0;
        return GreysAround(_expected, x, y).Count(grey => grey == 0 == isBlack) == 1
            && GreysAround(_actual, x, y).All(grey => grey == 0 != isBlack)
            && HasWithinAPixel(_expected, x, y, _actual[x, y, 0]);
    }

    private bool HasWithinAPixel(PngPixels image, int x, int y, int grey) =>
        GreysAround(image, x, y).Any(other => Math.Abs(other - grey) <= _sameGrey);

    private static IEnumerable<int> GreysAround(PngPixels image, int x, int y)
    {
        for (int row = Math.Max(0, y - 1); row <= Math.Min(image.Height - 1, y + 1); row++)
        {
            for (int column = Math.Max(0, x - 1); column <= Math.Min(image.Width - 1, x + 1); column++)
            {
                yield return image[column, row, 0];
            }
        }
    }
}
