namespace Msisf.Core.Render.Shading;

/// <summary>The light of the Sun, or of the lamp, on a frame's pixels, row by row; the arrays are kept from frame to frame.</summary>
internal sealed class PixelSunlight
{
    private double[] _ownCosines = [];

    /// <summary>
    /// Cosine of the incidence angle on the facet, for the Sun's disc the mean over its visible part; 0 or less where the facet faces away
    /// or there is no surface. Shading overwrites them in memory that was lent.
    /// </summary>
    public double[] CosIncidence { get; private set; } = [];

    /// <summary>Not 0 where terrain hides the whole light; for the Sun's disc also where the facet faces away from all of it.</summary>
    public byte[] Hidden { get; private set; } = [];

    /// <summary>Visible fraction of the light, 0 to 1: of the Sun's disc, or for several samples together; otherwise empty.</summary>
    public double[] VisibleFractions { get; private set; } = [];

    /// <summary>Mask of the points of the Sun's disc that terrain hides; empty if the light is a point.</summary>
    public ulong[] HiddenPoints { get; private set; } = [];

    /// <summary>Makes room for an image.</summary>
    /// <param name="hasFractions">Whether the light may be visible in part, as the Sun's disc.</param>
    /// <param name="lent">Memory for <see cref="CosIncidence"/>, which the factors then replace; null for its own.</param>
    public void Prepare(int pixels, bool hasFractions, double[]? lent = null)
    {
        if (lent is null && _ownCosines.Length < pixels)
        {
            _ownCosines = new double[pixels];
        }

        CosIncidence = lent ?? _ownCosines;
        if (Hidden.Length < pixels)
        {
            Hidden = new byte[pixels];
        }

        int discPixels = hasFractions ? pixels : 0;
        if (VisibleFractions.Length < discPixels || discPixels == 0)
        {
            VisibleFractions = new double[discPixels];
            HiddenPoints = new ulong[discPixels];
        }
    }

    /// <summary>Visible fraction of the light at a pixel, 0 to 1; 0 if the facet faces away.</summary>
    public double VisibleFraction(int pixel)
    {
        double ofPoint = Hidden[pixel] == 0 && CosIncidence[pixel] > 0.0 ? 1.0 : 0.0;
        return VisibleFractions.Length > 0 ? VisibleFractions[pixel] : ofPoint;
    }

    /// <summary>Reads the cosines and the visible fractions of some pixels of a row.</summary>
    /// <param name="start">The row's first pixel.</param>
    /// <param name="columns">Columns of the pixels, from left to right.</param>
    public void Read(int start, ReadOnlySpan<int> columns, Span<double> cosines, Span<double> fractions)
    {
        bool isPoint = VisibleFractions.Length == 0;
        for (int i = 0; i < columns.Length; i++)
        {
            int pixel = start + columns[i];
            double cosine = CosIncidence[pixel];
            cosines[i] = cosine;
            fractions[i] = !isPoint ? VisibleFractions[pixel] : Hidden[pixel] == 0 && cosine > 0.0 ? 1.0 : 0.0;
        }
    }
}
