namespace Msisf.Core.Render.Shading;

/// <summary>The light on a frame's pixels, row by row. Keeps its memory from frame to frame.</summary>
internal sealed class PixelSunlight
{
    /// <summary>
    /// Cosine of the incidence angle on the facet, of the Sun's disc the mean over its visible part; 0 or less where the facet faces away
    /// or there is no surface.
    /// </summary>
    public double[] CosIncidence { get; private set; } = [];

    /// <summary>Not 0 where other terrain hides the whole light.</summary>
    public byte[] Hidden { get; private set; } = [];

    /// <summary>Visible part of the Sun's disc; empty if the light is a point.</summary>
    public double[] VisibleFractions { get; private set; } = [];

    /// <summary>Of the disc, a bit for each point that terrain hides; empty if the light is a point.</summary>
    public ulong[] HiddenPoints { get; private set; } = [];

    /// <summary>Makes room for an image.</summary>
    /// <param name="pixels">How many.</param>
    /// <param name="hasDisc">Whether the Sun is a disc.</param>
    public void Prepare(int pixels, bool hasDisc)
    {
        if (CosIncidence.Length < pixels)
        {
            CosIncidence = new double[pixels];
            Hidden = new byte[pixels];
        }

        int discPixels = hasDisc ? pixels : 0;
        if (VisibleFractions.Length < discPixels || discPixels == 0)
        {
            VisibleFractions = new double[discPixels];
            HiddenPoints = new ulong[discPixels];
        }
    }

    /// <summary>Visible part of the light at a pixel whose facet faces it: 0 to 1.</summary>
    public double VisibleFraction(int pixel)
    {
        double ofPoint = Hidden[pixel] == 0 && CosIncidence[pixel] > 0.0 ? 1.0 : 0.0;
        return VisibleFractions.Length > 0 ? VisibleFractions[pixel] : ofPoint;
    }
}
