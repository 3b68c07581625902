namespace Msisf.Core.Render.Visibility;

/// <summary>How many further samples each pixel of an image gets, and whether each needs light of its own.</summary>
internal sealed class SampledPixels
{
    /// <summary>The bits of a code that are the number of vectors of <see cref="SamplePattern.Lanes"/> samples: 0, 1, 2, 4 or 8.</summary>
    public const byte Vectors = 0x0f;

    /// <summary>The bit of a code whose samples each get light of their own, because the border of a shadow is near.</summary>
    public const byte HasBorder = 0x80;

    /// <summary>The code of each pixel, row by row.</summary>
    public byte[] Codes { get; private set; } = [];

    /// <summary>Number of vectors in each band of <see cref="BandRows"/> rows.</summary>
    public int[] VectorsOfBand { get; private set; } = [];

    /// <summary>Rows of a band: with all samples in every pixel a band of 1024 px has a million.</summary>
    public const int BandRows = 16;

    /// <summary>Makes room for an image.</summary>
    public void Prepare(int width, int height)
    {
        if (Codes.Length < width * height)
        {
            Codes = new byte[width * height];
        }

        VectorsOfBand = new int[(height + BandRows - 1) / BandRows];
    }
}
