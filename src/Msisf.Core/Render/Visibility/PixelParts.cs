using System.Numerics;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The parts of pixels that show one facet each: the samples of a pixel on the same facet are one part, which is at their mean and has
/// one brightness. Its light is that of its receivers: of the part itself or, where a shadow's border may be near, of each sample. One
/// object is used for many bands.
/// </summary>
internal sealed class PixelParts
{
    private const int Lanes = SamplePattern.Lanes;
    private const int FirstCapacity = 1024;

    /// <summary>Samples that are looked at together: those of a larger number may show the same facet in several parts.</summary>
    private const int SamplesAtOnce = 64;

    private FacetRecord[] _records = [];
    private int _recordCount;

    /// <summary>Number of parts.</summary>
    public int Count => Points.Count;

    /// <summary>Where the parts are; their facets are indices in <see cref="Records"/>.</summary>
    public FacetPoints Points { get; } = new();

    /// <summary>Where the light on the parts is found; those of a part follow each other.</summary>
    public FacetPoints Receivers { get; } = new();

    /// <summary>Index of each receiver's sample in its pixel; of a whole part, of its first one.</summary>
    public byte[] Samples { get; private set; } = new byte[FirstCapacity];

    /// <summary>The pixel of each part: row of the image times its width plus column.</summary>
    public int[] Pixels { get; private set; } = new int[FirstCapacity];

    /// <summary>Number of samples of each part over those of its pixel.</summary>
    public double[] Weights { get; private set; } = new double[FirstCapacity];

    /// <summary>Index behind each part's last receiver.</summary>
    public int[] ReceiverEnds { get; private set; } = new int[FirstCapacity];

    public ReadOnlySpan<FacetRecord> Records => _records.AsSpan(0, _recordCount);

    /// <summary>Takes the parts of a band that was drawn.</summary>
    /// <param name="mayBeSplit">Whether samples near a shadow's border are receivers of their own.</param>
    /// <param name="pieces">Knows parts that need no receivers for their samples; null for none.</param>
    public void Take(SubsampleBand band, CameraModel model, bool mayBeSplit = true, IPieces? pieces = null)
    {
        Points.Clear();
        Receivers.Clear();
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
            TakePixel(band, model, column, row, mayBeSplit && band.HasBorder(column, row), pieces);
        }
    }

    private void TakePixel(SubsampleBand band, CameraModel model, int column, int row, bool isSplit, IPieces? pieces)
    {
        int samples = band.SamplesIn(band.VectorsOf(column, row));
        int index = band.IndexOf(column, row);
        EnsureRoom(samples);
        Pixel pixel = new(band, model, column, row, index, band.Starts[index]);
        TangentBox piece = isSplit && pieces is not null ? PieceOf(pixel, samples) : default;
        if (band.TryGetWhole(index, out int whole, out FacetPlane plane))
        {
            AddWhole(pixel, samples, whole, plane);
            if (isSplit && samples > 1 && pieces?.IsEven(in _records[whole], Points.InverseDepths[Count - 1], in piece) != true)
            {
                band.Part(column, row, index);
                for (int begin = 0; begin < samples; begin += SamplesAtOnce)
                {
                    AddReceivers(pixel, begin, ulong.MaxValue >> (SamplesAtOnce - Math.Min(SamplesAtOnce, samples - begin)));
                }
            }
            else
            {
                AddReceiver(whole, sample: 0);
            }

            ReceiverEnds[Count - 1] = Receivers.Count;
            return;
        }

        band.Part(column, row, index);
        for (int begin = 0; begin < samples; begin += SamplesAtOnce)
        {
            int start = pixel.Start + begin;
            int count = Math.Min(SamplesAtOnce, samples - begin);
            ulong left = ulong.MaxValue >> (SamplesAtOnce - count);
            while (left != 0)
            {
                int first = BitOperations.TrailingZeroCount(left);
                int facet = band.Facets[start + first];
                ulong same = left & SamplesOf(band, start, (count + Lanes - 1) / Lanes, facet);
                left &= ~same;
                if (facet != Band.NotRecorded)
                {
                    Pixels[Count] = pixel.Number;
                    Weights[Count] = (double)BitOperations.PopCount(same) / samples;
                    Add(Points, pixel, begin, same, facet);
                    double middle = Points.InverseDepths[Count - 1];
                    if (isSplit && BitOperations.PopCount(same) > 1 && pieces?.IsEven(in _records[facet], middle, in piece) != true)
                    {
                        AddReceivers(pixel, begin, same);
                    }
                    else
                    {
                        AddReceiver(facet, begin + first);
                    }

                    ReceiverEnds[Count - 1] = Receivers.Count;
                }
            }
        }
    }

    /// <summary>Adds all samples of a pixel as one part.</summary>
    private void AddWhole(in Pixel pixel, int samples, int facet, in FacetPlane plane)
    {
        (double right, double down) = pixel.Band.Pattern.Means[pixel.Vectors];
        (double x, double y) = (pixel.Column + right, pixel.Row + down);
        (double across, double along) = PlaceOf(x, y, pixel.Model);
        if (pixel.HasLens)
        {
            (x, y) = MeanOf(pixel.Band.Columns, pixel.Band.Rows, pixel.Start, samples);
            (across, along) = MeanOf(pixel.Band.Right, pixel.Band.Down, pixel.Start, samples);
        }

        Pixels[Count] = pixel.Number;
        Weights[Count] = 1.0;
        Points.Add(facet, plane.At(x, y), across, along);
    }

    private static (double X, double Y) MeanOf(double[] xs, double[] ys, int start, int samples)
    {
        (double x, double y) = (0.0, 0.0);
        for (int sample = start; sample < start + samples; sample++)
        {
            x += xs[sample];
            y += ys[sample];
        }

        return (x / samples, y / samples);
    }

    /// <summary>Adds the last part as a receiver.</summary>
    private void AddReceiver(int facet, int sample)
    {
        Samples[Receivers.Count] = (byte)sample;
        int part = Count - 1;
        Receivers.Add(facet, Points.InverseDepths[part], Points.Across[part], Points.Along[part]);
    }

    /// <summary>The piece of the image that holds a pixel's samples.</summary>
    private static TangentBox PieceOf(in Pixel pixel, int samples)
    {
        if (!pixel.HasLens)
        {
            double margin = pixel.Band.Margin;
            (double left, double top) = PlaceOf(pixel.Column - margin, pixel.Row - margin, pixel.Model);
            (double right, double bottom) = PlaceOf(pixel.Column + margin, pixel.Row + margin, pixel.Model);
            return new TangentBox(left, top, right, bottom);
        }

        TangentBox box = TangentBox.Nothing;
        for (int sample = pixel.Start; sample < pixel.Start + samples; sample++)
        {
            box = box.With(pixel.Band.Right[sample], pixel.Band.Down[sample]);
        }

        return box;
    }

    /// <summary>Adds each of some samples as a receiver.</summary>
    /// <param name="begin">Number in the pixel of the sample of bit 0.</param>
    private void AddReceivers(in Pixel pixel, int begin, ulong samples)
    {
        for (; samples != 0; samples &= samples - 1)
        {
            int sample = BitOperations.TrailingZeroCount(samples);
            Samples[Receivers.Count] = (byte)(begin + sample);
            Add(Receivers, pixel, begin, 1ul << sample, pixel.Band.Facets[pixel.Start + begin + sample]);
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

    /// <summary>Adds the mean of some samples: the inverse depth is linear in the image.</summary>
    /// <param name="begin">Number in the pixel of the sample of bit 0.</param>
    private static void Add(FacetPoints points, in Pixel pixel, int begin, ulong samples, int facet)
    {
        // Without a lens the samples of all pixels lie at the same places beside the centres.
        SubsampleBand band = pixel.Band;
        (double[] xs, double[] ys) = pixel.HasLens ? (band.Right, band.Down) : (band.Pattern.Right, band.Pattern.Down);
        int place = pixel.HasLens ? pixel.Start + begin : begin;
        int start = pixel.Start + begin;
        int count = BitOperations.PopCount(samples);
        double x, y, inverse;
        if (count == 1)
        {
            int only = BitOperations.TrailingZeroCount(samples);
            (x, y, inverse) = (xs[place + only], ys[place + only], band.InverseDepths[start + only]);
        }
        else
        {
            (x, y, inverse) = Sum(xs, ys, place, band.InverseDepths, start, samples);
        }

        double perCount = 1.0 / count;
        (double across, double along) = pixel.HasLens
            ? (x * perCount, y * perCount)
            : PlaceOf(pixel.Column + (x * perCount), pixel.Row + (y * perCount), pixel.Model);
        points.Add(facet, inverse * perCount, across, along);
    }

    /// <summary>Sums up the coordinates and inverse depths of some samples.</summary>
    private static (double X, double Y, double Inverse) Sum(
        double[] xs, double[] ys, int place, double[] inverses, int start, ulong samples)
    {
        Vector512<double> sumX = Vector512<double>.Zero;
        Vector512<double> sumY = Vector512<double>.Zero;
        Vector512<double> sumInverse = Vector512<double>.Zero;
        for (int first = 0; samples != 0; samples >>= Lanes, first += Lanes)
        {
            Vector512<double> isMeant = Vector512.Equals(
                Vector512.Create((long)(samples & 0xff)) & Vector512.Create(1L, 2L, 4L, 8L, 16L, 32L, 64L, 128L),
                Vector512.Create(1L, 2L, 4L, 8L, 16L, 32L, 64L, 128L)).AsDouble();
            sumX += isMeant & ArrayLanes.Load(xs, place + first);
            sumY += isMeant & ArrayLanes.Load(ys, place + first);
            sumInverse += isMeant & ArrayLanes.Load(inverses, start + first);
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

    /// <summary>Makes room for further parts and receivers.</summary>
    private void EnsureRoom(int more)
    {
        if (Count + more > Pixels.Length)
        {
            int room = Math.Max(2 * Pixels.Length, Count + more);
            (int[] pixels, double[] weights, int[] ends) = (Pixels, Weights, ReceiverEnds);
            Array.Resize(ref pixels, room);
            Array.Resize(ref weights, room);
            Array.Resize(ref ends, room);
            (Pixels, Weights, ReceiverEnds) = (pixels, weights, ends);
        }

        if (Receivers.Count + more > Samples.Length)
        {
            byte[] samples = Samples;
            Array.Resize(ref samples, Math.Max(2 * Samples.Length, Receivers.Count + more));
            Samples = samples;
        }
    }

    /// <summary>A pixel with samples.</summary>
    /// <param name="Index">Its index in the band.</param>
    /// <param name="Start">Its first sample.</param>
    private readonly record struct Pixel(SubsampleBand Band, CameraModel Model, int Column, int Row, int Index, int Start)
    {
        public int Number => (Row * Band.Width) + Column;

        public int Vectors => Band.VectorsOf(Column, Row);

        public bool HasLens => Model.Lens is not null;
    }
}
