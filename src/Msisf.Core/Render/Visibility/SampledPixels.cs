namespace Msisf.Core.Render.Visibility;

/// <summary>How many further samples each pixel of an image gets, and whether each needs light of its own.</summary>
internal sealed class SampledPixels
{
    /// <summary>The bits of a code that are the number of vectors of <see cref="SamplePattern.Lanes"/> samples.</summary>
    public const byte Vectors = 0x3f;

    /// <summary>The bit of a code whose samples each get light of their own, because the border of a shadow is near.</summary>
    public const byte HasBorder = 0x80;

    /// <summary>Bands of fewer rows are not divided: with all samples in every pixel, such a band of 1024 px has a million.</summary>
    private const int MinRows = 16;

    /// <summary>Vectors above which a band is divided, so that its depth buffer stays below 4 MB.</summary>
    private const int MaxVectorsOfBand = 1 << 14;

    /// <summary>Vectors above which a band is divided however few its rows are: 30 MB.</summary>
    private const int MostVectorsOfBand = 1 << 17;

    private readonly List<SampledBand> _bands = [];
    private int _height;

    /// <summary>Where the samples of a pixel lie.</summary>
    public SamplePattern Pattern { get; private set; } = SamplePattern.Stratified;

    /// <summary>The code of each pixel, row by row.</summary>
    public byte[] Codes { get; private set; } = [];

    /// <summary>Number of vectors in each row.</summary>
    public int[] VectorsOfRow { get; private set; } = [];

    /// <summary>
    /// The bands in which the samples are drawn, from <see cref="Cut()"/>: rows of one band of <see cref="VisibleSurface"/>, with samples.
    /// </summary>
    public IReadOnlyList<SampledBand> Bands => _bands;

    /// <summary>Gives all pixels of an image all samples of a pattern.</summary>
    /// <param name="hasBorders">Whether each sample gets light of its own.</param>
    public void Fill(SamplePattern pattern, int width, int height, bool hasBorders)
    {
        Prepare(pattern, width, height);
        Codes.AsSpan(0, width * height).Fill((byte)(pattern.Vectors | (hasBorders ? HasBorder : 0)));
        VectorsOfRow.AsSpan(0, height).Fill(pattern.Vectors * width);
        Cut();
    }

    /// <summary>Makes room for an image.</summary>
    /// <param name="pattern">Where the samples of a pixel lie; at most <see cref="Vectors"/> vectors.</param>
    public void Prepare(SamplePattern pattern, int width, int height)
    {
        (Pattern, _height) = (pattern, height);
        _bands.Clear();
        if (Codes.Length < width * height)
        {
            Codes = new byte[width * height];
        }

        if (VectorsOfRow.Length < height)
        {
            VectorsOfRow = new int[height];
        }
    }

    /// <summary>Cuts the image into bands: large ones, as each projects the terrain that it shows, where there are few samples.</summary>
    public void Cut()
    {
        _bands.Clear();
        for (int row = 0; row < _height; row += VisibleSurface.BandRows)
        {
            Cut(row, Math.Min(row + VisibleSurface.BandRows, _height));
        }
    }

    private void Cut(int first, int end)
    {
        int vectors = 0;
        for (int row = first; row < end; row++)
        {
            vectors += VectorsOfRow[row];
        }

        int minRows = vectors > MostVectorsOfBand ? 1 : MinRows;
        if (vectors > MaxVectorsOfBand && end - first > minRows)
        {
            int middle = first + ((end - first) / 2);
            Cut(first, middle);
            Cut(middle, end);
        }
        else if (vectors > 0)
        {
            _bands.Add(new SampledBand(first, end - 1, vectors));
        }
    }
}
