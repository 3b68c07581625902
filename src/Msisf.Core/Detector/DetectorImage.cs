using Msisf.Core.Scene;

namespace Msisf.Core.Detector;

/// <summary>What a detector reads out for one frame. All planes are by rows from the top, each from left to right.</summary>
public sealed class DetectorImage
{
    internal DetectorImage(int width, int height)
    {
        Width = width;
        Height = height;
        Numbers = new ushort[width * height];
        Electrons = new double[width * height];
        Saturated = new byte[width * height];
        Charge = new double[width * height];
    }

    /// <summary>px.</summary>
    public int Width { get; }

    /// <summary>px.</summary>
    public int Height { get; }

    /// <summary>Digital numbers.</summary>
    public ushort[] Numbers { get; }

    /// <summary>
    /// Mean number of electrons that the light of the scene frees in each pixel during the exposure: after optics and PSF, before smear,
    /// fixed pattern, dark current and noise.
    /// </summary>
    public double[] Electrons { get; }

    /// <summary>Electrons of light that far wings take out of the image; 0 without them.</summary>
    public double LeftImage { get; internal set; }

    /// <summary>0 where the DN is in proportion to the light, 1 at the highest DN, 2 at the full well, 3 at both.</summary>
    public byte[] Saturated { get; }

    /// <summary>The noise that the user chose; null for that of the detector's seed and the frame's state.</summary>
    public NoiseSeed? Noise { get; internal set; }

    /// <summary>Copies a row of another image of the same width.</summary>
    /// <param name="row">Its row, from 0.</param>
    /// <param name="target">Which row it becomes, from 0.</param>
    internal void Take(DetectorImage other, int row, int target)
    {
        other.Numbers.AsSpan(row * Width, Width).CopyTo(Numbers.AsSpan(target * Width));
        other.Electrons.AsSpan(row * Width, Width).CopyTo(Electrons.AsSpan(target * Width));
        other.Saturated.AsSpan(row * Width, Width).CopyTo(Saturated.AsSpan(target * Width));
    }

    /// <summary>Electrons in the wells at the end of the exposure.</summary>
    internal double[] Charge { get; }
}
