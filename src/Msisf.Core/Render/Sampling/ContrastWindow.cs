using System.Runtime.Intrinsics;

namespace Msisf.Core.Render.Sampling;

/// <summary>Looks at the 3 x 3 pixels around each pixel of a row. Each thread needs its own object.</summary>
internal sealed class ContrastWindow
{
    /// <summary>Bit of a pixel whose centre is lit.</summary>
    public const byte Lit = 1;

    /// <summary>Bit of a pixel whose centre has not all light.</summary>
    public const byte Dark = 2;

    /// <summary>Lit and dark pixels meet.</summary>
    public const byte Mixed = Lit | Dark;

    /// <summary>Levels of 65535 in a contrast of 1.</summary>
    private const ushort Fine = 256;

    /// <summary>Elements beyond the row: one on each side, and whole vectors.</summary>
    private const int Padding = 34;

    private ushort[] _min = [];
    private ushort[] _max = [];
    private byte[] _light = [];

    /// <summary>Starts a frame.</summary>
    public void Begin(int width)
    {
        if (_min.Length < width + Padding)
        {
            (_min, _max, _light) = (new ushort[width + Padding], new ushort[width + Padding], new byte[width + Padding]);
        }
    }

    /// <summary>Finds the contrasts of a row's pixels, and the light around them.</summary>
    /// <param name="levels">Levels of 65535 of the rows above, here and below; the borders of the image are repeated.</param>
    /// <param name="above">First pixel of the row above.</param>
    /// <param name="here">First pixel of the row.</param>
    /// <param name="below">First pixel of the row below.</param>
    /// <param name="light"><see cref="Lit"/> and <see cref="Dark"/> of the pixels.</param>
    /// <param name="contrasts">Receives the contrasts of the row, rounded up.</param>
    /// <param name="codes">Receives <see cref="Lit"/> and <see cref="Dark"/> of the pixels around.</param>
    public void Look(ushort[] levels, byte[] light, int above, int here, int below, Span<byte> contrasts, Span<byte> codes)
    {
        int width = contrasts.Length;
        Join(levels.AsSpan(above, width), levels.AsSpan(here, width), levels.AsSpan(below, width));
        for (int i = 0; i < width; i++)
        {
            _light[i + 1] = (byte)(light[above + i] | light[here + i] | light[below + i]);
        }

        (_min[0], _max[0], _light[0]) = (_min[1], _max[1], _light[1]);
        (_min[width + 1], _max[width + 1], _light[width + 1]) = (_min[width], _max[width], _light[width]);
        int column = 0;
        for (; column + Vector512<ushort>.Count <= width; column += Vector512<ushort>.Count)
        {
            Vector512<ushort> min = Vector512.Min(
                Vector512.Min(ArrayLanes.Load(_min, column), ArrayLanes.Load(_min, column + 1)),
                ArrayLanes.Load(_min, column + 2));
            Vector512<ushort> max = Vector512.Max(
                Vector512.Max(ArrayLanes.Load(_max, column), ArrayLanes.Load(_max, column + 1)),
                ArrayLanes.Load(_max, column + 2));
            Vector512<ushort> contrast = Vector512.ShiftRightLogical(
                Vector512.Min(max - min, Vector512.Create((ushort)(ushort.MaxValue - Fine + 1))) + Vector512.Create((ushort)(Fine - 1)), 8);
            Vector512.Narrow(contrast, contrast).GetLower().StoreTo(contrasts, column);
            Vector256<byte> around = ArrayLanes.Load256(_light, column) | ArrayLanes.Load256(_light, column + 1)
                | ArrayLanes.Load256(_light, column + 2);
            around.StoreTo(codes, column);
        }

        for (; column < width; column++)
        {
            int min = Math.Min(Math.Min(_min[column], _min[column + 1]), _min[column + 2]);
            int max = Math.Max(Math.Max(_max[column], _max[column + 1]), _max[column + 2]);
            contrasts[column] = (byte)((Math.Min(max - min, ushort.MaxValue - Fine + 1) + Fine - 1) >> 8);
            codes[column] = (byte)(_light[column] | _light[column + 1] | _light[column + 2]);
        }
    }

    /// <summary>Finds the extremes of each column of three rows.</summary>
    private void Join(ReadOnlySpan<ushort> above, ReadOnlySpan<ushort> here, ReadOnlySpan<ushort> below)
    {
        int i = 0;
        for (; i + Vector512<ushort>.Count <= here.Length; i += Vector512<ushort>.Count)
        {
            Vector512<ushort> a = Vector512.Create(above[i..]);
            Vector512<ushort> b = Vector512.Create(here[i..]);
            Vector512<ushort> c = Vector512.Create(below[i..]);
            Vector512.Min(Vector512.Min(a, b), c).CopyTo(_min, i + 1);
            Vector512.Max(Vector512.Max(a, b), c).CopyTo(_max, i + 1);
        }

        for (; i < here.Length; i++)
        {
            _min[i + 1] = Math.Min(Math.Min(above[i], here[i]), below[i]);
            _max[i + 1] = Math.Max(Math.Max(above[i], here[i]), below[i]);
        }
    }
}
