using System.Numerics;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The parts of pixels that show one facet each: the samples of a pixel on the same facet are one part, which stands at their mean. Where a
/// shadow's border is near, each sample is a part of its own. One object is used for many bands.
/// </summary>
internal sealed class PixelParts
{
    private const int Lanes = SamplePattern.Lanes;
    private const int FirstCapacity = 1024;

    private FacetRecord[] _records = [];
    private int _recordCount;

    public int Count { get; private set; }

    /// <summary>The pixel of each part: row of the image times its width plus column.</summary>
    public int[] Pixels { get; private set; } = new int[FirstCapacity];

    /// <summary>Number of samples of each part over those of its pixel.</summary>
    public double[] Weights { get; private set; } = new double[FirstCapacity];

    /// <summary>1/m: inverse depth of each part.</summary>
    public double[] InverseDepths { get; private set; } = new double[FirstCapacity];

    /// <summary>Each part's factor of the camera's vector to the right in its ray's direction.</summary>
    public double[] Across { get; private set; } = new double[FirstCapacity];

    /// <summary>Each part's factor of the camera's vector up, with a lens of the vector down.</summary>
    public double[] Along { get; private set; } = new double[FirstCapacity];

    /// <summary>Index of each part's first sample in its pixel.</summary>
    public byte[] FirstSamples { get; private set; } = new byte[FirstCapacity];

    /// <summary>Index of each part's facet in <see cref="Records"/>.</summary>
    public int[] Facets { get; private set; } = new int[FirstCapacity];

    public ReadOnlySpan<FacetRecord> Records => _records.AsSpan(0, _recordCount);

    /// <summary>Takes the parts of a band that was drawn.</summary>
    /// <param name="mayBeSplit">Whether samples near a shadow's border are parts of their own.</param>
    public void Take(SubsampleBand band, CameraModel model, bool mayBeSplit = true)
    {
        Count = 0;
        if (_records.Length < band.Records.Count)
        {
            _records = new FacetRecord[band.Records.Count + (band.Records.Count / 4)];
        }

        _recordCount = band.Records.Count;
        band.Records.AsSpan().CopyTo(_records);
        for (int pixel = band.NextPixel(0); pixel >= 0; pixel = band.NextPixel(pixel + 1))
        {
            (int row, int column) = Math.DivRem(pixel, band.Width);
            row += band.FirstRow;
            TakePixel(band, model, column, row, band.VectorsOf(column, row), mayBeSplit && band.HasBorder(column, row));
        }
    }

    /// <summary>Starts without parts.</summary>
    public void Begin() => (Count, _recordCount) = (0, 0);

    /// <summary>Adds a facet and returns its number.</summary>
    public int Add(in FacetRecord record)
    {
        if (_recordCount == _records.Length)
        {
            Array.Resize(ref _records, Math.Max(FirstCapacity, 2 * _recordCount));
        }

        _records[_recordCount] = record;
        return _recordCount++;
    }

    /// <summary>Adds one sample of a pinhole's pixel as a part, for which <see cref="EnsureRoom"/> has made room.</summary>
    /// <param name="pixel">As in <see cref="Pixels"/>.</param>
    /// <param name="facet">As in <see cref="Facets"/>.</param>
    /// <param name="weight">As in <see cref="Weights"/>.</param>
    /// <param name="inverseDepth">As in <see cref="InverseDepths"/>.</param>
    /// <param name="column">Column of the sample, px from the centre of the first pixel.</param>
    public void Add(int pixel, int facet, double weight, double inverseDepth, double column, double row, CameraModel model)
    {
        (Pixels[Count], Facets[Count], FirstSamples[Count]) = (pixel, facet, 0);
        (Weights[Count], InverseDepths[Count]) = (weight, inverseDepth);
        (Across[Count], Along[Count]) = PlaceOf(column, row, model);
        Count++;
    }

    private void TakePixel(SubsampleBand band, CameraModel model, int column, int row, int vectors, bool isSplit)
    {
        EnsureRoom(vectors * Lanes);
        int start = band.Starts[band.IndexOf(column, row)];
        int pixel = (row * band.Width) + column;
        double weight = 1.0 / (vectors * Lanes);
        ulong left = ulong.MaxValue >> (64 - (vectors * Lanes));
        while (left != 0)
        {
            int first = BitOperations.TrailingZeroCount(left);
            int facet = band.Facets[start + first];
            ulong same = isSplit ? 1ul << first : SamplesOf(band, start, vectors, facet);
            left &= ~same;
            if (facet == Band.NotRecorded)
            {
                continue;
            }

            Add(band, model, start, same, weight);
            Pixels[Count] = pixel;
            FirstSamples[Count] = (byte)first;
            Facets[Count++] = facet;
        }
    }

    private static ulong SamplesOf(SubsampleBand band, int start, int vectors, int facet)
    {
        ulong samples = 0;
        for (int vector = 0; vector < vectors; vector++)
        {
            ulong same = Vector256.Equals(ArrayLanes.Load256(band.Facets, start + (vector * Lanes)), Vector256.Create(facet))
                .ExtractMostSignificantBits();
            samples |= same << (vector * Lanes);
        }

        return samples;
    }

    /// <summary>Places a part at the mean of its samples: the inverse depth is linear in the image.</summary>
    private void Add(SubsampleBand band, CameraModel model, int start, ulong samples, double weight)
    {
        bool hasLens = model.Lens is not null;
        (double[] xs, double[] ys) = hasLens ? (band.Right, band.Down) : (band.Columns, band.Rows);
        double[] inverses = band.InverseDepths;
        int count = BitOperations.PopCount(samples);
        double x, y, inverse;
        if (count == 1)
        {
            int only = start + BitOperations.TrailingZeroCount(samples);
            (x, y, inverse) = (xs[only], ys[only], inverses[only]);
        }
        else
        {
            (x, y, inverse) = Sum(xs, ys, inverses, start, samples);
        }

        double perCount = 1.0 / count;
        Weights[Count] = weight * count;
        InverseDepths[Count] = inverse * perCount;
        (Across[Count], Along[Count]) = hasLens ? (x * perCount, y * perCount) : PlaceOf(x * perCount, y * perCount, model);
    }

    /// <summary>Sums up the coordinates and inverse depths of some samples.</summary>
    private static (double X, double Y, double Inverse) Sum(
        double[] xs, double[] ys, double[] inverses, int start, ulong samples)
    {
        Vector512<double> sumX = Vector512<double>.Zero;
        Vector512<double> sumY = Vector512<double>.Zero;
        Vector512<double> sumInverse = Vector512<double>.Zero;
        for (int sample = start; samples != 0; samples >>= Lanes, sample += Lanes)
        {
            Vector512<double> isMeant = Vector512.Equals(
                Vector512.Create((long)(samples & 0xff)) & Vector512.Create(1L, 2L, 4L, 8L, 16L, 32L, 64L, 128L),
                Vector512.Create(1L, 2L, 4L, 8L, 16L, 32L, 64L, 128L)).AsDouble();
            sumX += isMeant & ArrayLanes.Load(xs, sample);
            sumY += isMeant & ArrayLanes.Load(ys, sample);
            sumInverse += isMeant & ArrayLanes.Load(inverses, sample);
        }

        return (Sum(sumX), Sum(sumY), Sum(sumInverse));
    }

    /// <summary>The sum of eight numbers, in an order that does not depend on the processor.</summary>
    private static double Sum(Vector512<double> numbers)
    {
        Vector256<double> four = numbers.GetLower() + numbers.GetUpper();
        Vector128<double> two = four.GetLower() + four.GetUpper();
        return two[0] + two[1];
    }

    /// <summary>The factors of the camera's vectors to the right and up in the ray at a place of a pinhole's image.</summary>
    private static (double Across, double Along) PlaceOf(double x, double y, CameraModel model) =>
        (((2.0 * x) + 1.0 - model.Width) / (2.0 * model.Width), (model.Height - 1.0 - (2.0 * y)) / (2.0 * model.Height));

    /// <summary>Makes room for further parts.</summary>
    public void EnsureRoom(int more)
    {
        if (Count + more <= Pixels.Length)
        {
            return;
        }

        int room = Math.Max(2 * Pixels.Length, Count + more);
        (int[] pixels, int[] facets, byte[] firstSamples) = (Pixels, Facets, FirstSamples);
        (double[] weights, double[] depths, double[] across, double[] along) = (Weights, InverseDepths, Across, Along);
        Array.Resize(ref pixels, room);
        Array.Resize(ref facets, room);
        Array.Resize(ref firstSamples, room);
        Array.Resize(ref weights, room);
        Array.Resize(ref depths, room);
        Array.Resize(ref across, room);
        Array.Resize(ref along, room);
        (Pixels, Facets, FirstSamples) = (pixels, facets, firstSamples);
        (Weights, InverseDepths, Across, Along) = (weights, depths, across, along);
    }
}
