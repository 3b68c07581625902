using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Msisf.Core.Camera;
using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The parts of pixels that show one facet each: the samples of a pixel on the same facet are one part, which stands at their mean. Where a
/// shadow's border is near, each sample is a part of its own. One object is used for many bands.
/// </summary>
internal sealed class PixelParts
{
    private const int Lanes = SamplePattern.Lanes;
    private const int FirstCapacity = 1024;

    private FacetRecord[] _ownRecords = [];
    private FacetRecord[] _records = []; // own ones, or those of the parts whose samples these are
    private int _recordCount;

    /// <summary>Number of parts.</summary>
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

    /// <summary>px: bound of the distance along columns or rows of each part's samples from its place.</summary>
    public float[] Reaches { get; private set; } = new float[FirstCapacity];

    /// <summary>The samples of each part, a bit for each sample of its pixel.</summary>
    public ulong[] Samples { get; private set; } = new ulong[FirstCapacity];

    /// <summary>Index of each part's facet in <see cref="Records"/>.</summary>
    public int[] Facets { get; private set; } = new int[FirstCapacity];

    /// <summary>The facets.</summary>
    public ReadOnlySpan<FacetRecord> Records => _records.AsSpan(0, _recordCount);

    /// <summary>Takes the parts of a band that was drawn.</summary>
    /// <param name="band">The band.</param>
    /// <param name="model">The camera.</param>
    /// <param name="mayBeSplit">Whether samples near a shadow's border are parts of their own.</param>
    public void Take(SubsampleBand band, CameraModel model, bool mayBeSplit = true)
    {
        Begin(band.Records);
        for (int pixel = band.NextPixel(0); pixel >= 0; pixel = band.NextPixel(pixel + 1))
        {
            (int row, int column) = Math.DivRem(pixel, band.Width);
            row += band.FirstRow;
            TakePixel(band, model, column, row, band.VectorsOf(column, row) * Lanes, mayBeSplit && band.HasBorder(column, row));
        }
    }

    /// <summary>Starts without parts.</summary>
    /// <param name="records">The facets that they will show.</param>
    public void Begin(FacetRecords records)
    {
        Count = 0;
        if (_ownRecords.Length < records.Count)
        {
            _ownRecords = new FacetRecord[records.Count + (records.Count / 4)];
        }

        (_records, _recordCount) = (_ownRecords, records.Count);
        records.AsSpan().CopyTo(_ownRecords);
    }

    /// <summary>Adds a part, for which <see cref="EnsureRoom"/> has made room; the parameters are what the arrays hold.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int pixel, int facet, ulong samples, double weight, double inverseDepth, double across, double along, float reach)
    {
        int part = Count++;
        (Pixels[part], Facets[part], Samples[part]) = (pixel, facet, samples);
        (Weights[part], InverseDepths[part], Across[part], Along[part]) = (weight, inverseDepth, across, along);
        Reaches[part] = reach;
    }

    /// <summary>Number of samples of the parts with a state.</summary>
    public int CountSamples(ReadOnlySpan<byte> states, byte wanted)
    {
        int count = 0;
        for (int part = 0, next; part < Count && (next = states[part..Count].IndexOf(wanted)) >= 0; part++)
        {
            part += next;
            count += BitOperations.PopCount(Samples[part]);
        }

        return count;
    }

    /// <summary>Takes each sample of some parts as a part of its own.</summary>
    /// <param name="parts">The parts, of a pinhole.</param>
    /// <param name="states">A state for each part.</param>
    /// <param name="wanted">The state of the parts that are taken.</param>
    /// <param name="pattern">Where the samples lie.</param>
    /// <param name="view">The projection.</param>
    public void TakeSamples(PixelParts parts, ReadOnlySpan<byte> states, byte wanted, SamplePattern pattern, ImageView view)
    {
        Count = 0;
        (_records, _recordCount) = (parts._records, parts._recordCount);
        FrameCamera camera = view.Camera;
        Vector3D position = camera.PositionMoonMe - view.Anchor;
        for (int part = 0, next; part < parts.Count && (next = states[part..parts.Count].IndexOf(wanted)) >= 0; part++)
        {
            part += next;
            EnsureRoom(pattern.Count);
            (int row, int column) = Math.DivRem(parts.Pixels[part], camera.Width);
            ref readonly FacetRecord record = ref _records[parts.Facets[part]];
            double perDepth = 1.0 / ((record.Offset - Vector3D.Dot(record.Normal, position)) * view.Distance);
            for (ulong left = parts.Samples[part]; left != 0; left &= left - 1)
            {
                int sample = BitOperations.TrailingZeroCount(left);
                (double x, double y) = (column + pattern.Right[sample], row + pattern.Down[sample]);
                (double across, double along) = PlaceOf(x, y, camera.Model);
                Vector3D direction = camera.Direction + (across * camera.Right) + (along * camera.Up);
                Add(
                    parts.Pixels[part], parts.Facets[part], 1ul << sample, 1.0 / pattern.Count,
                    Vector3D.Dot(record.Normal, direction) * perDepth, across, along, reach: 0f);
            }
        }
    }

    private void TakePixel(SubsampleBand band, CameraModel model, int column, int row, int samples, bool isSplit)
    {
        EnsureRoom(samples);
        int start = band.Starts[band.IndexOf(column, row)];
        int pixel = (row * band.Width) + column;
        double weight = 1.0 / samples;
        ulong left = ulong.MaxValue >> (64 - samples);
        while (left != 0)
        {
            int first = BitOperations.TrailingZeroCount(left);
            int facet = band.Facets[start + first];
            ulong same = isSplit ? 1ul << first : left & SampleSums.SamplesOf(ref band.Facets[start], samples / Lanes, facet);
            left &= ~same;
            if (facet == Band.NotRecorded)
            {
                continue;
            }

            Add(band, model, start, same, weight, pixel, facet);
        }
    }

    /// <summary>Places a part at the mean of its samples: the inverse depth is linear in the image.</summary>
    private void Add(SubsampleBand band, CameraModel model, int start, ulong samples, double weight, int pixel, int facet)
    {
        bool hasLens = model.Lens is not null;
        ref double xs = ref MemoryMarshal.GetArrayDataReference(hasLens ? band.Right : band.Columns);
        ref double ys = ref MemoryMarshal.GetArrayDataReference(hasLens ? band.Down : band.Rows);
        ref double inverses = ref MemoryMarshal.GetArrayDataReference(band.InverseDepths);
        int count = BitOperations.PopCount(samples);
        double x, y, inverse;
        if (count == 1)
        {
            int only = start + BitOperations.TrailingZeroCount(samples);
            (x, y, inverse) = (Unsafe.Add(ref xs, only), Unsafe.Add(ref ys, only), Unsafe.Add(ref inverses, only));
        }
        else
        {
            (x, y, inverse) = SampleSums.Sum(
                ref Unsafe.Add(ref xs, start), ref Unsafe.Add(ref ys, start), ref Unsafe.Add(ref inverses, start), samples);
        }

        double perCount = 1.0 / count;
        (double across, double along) = hasLens ? (x * perCount, y * perCount) : PlaceOf(x * perCount, y * perCount, model);
        Add(pixel, facet, samples, weight * count, inverse * perCount, across, along, reach: 1f);
    }

    /// <summary>The factors of the camera's vectors to the right and up in the ray at a place of a pinhole's image.</summary>
    public static (double Across, double Along) PlaceOf(double x, double y, CameraModel model) =>
        (((2.0 * x) + 1.0 - model.Width) / (2.0 * model.Width), (model.Height - 1.0 - (2.0 * y)) / (2.0 * model.Height));

    /// <summary>Makes room for further parts.</summary>
    public void EnsureRoom(int more)
    {
        if (Count + more <= Pixels.Length)
        {
            return;
        }

        int room = Math.Max(Pixels.Length + (Pixels.Length / 2), Count + more);
        (int[] pixels, int[] facets, ulong[] samples, float[] reaches) = (Pixels, Facets, Samples, Reaches);
        (double[] weights, double[] depths, double[] across, double[] along) = (Weights, InverseDepths, Across, Along);
        Array.Resize(ref pixels, room);
        Array.Resize(ref facets, room);
        Array.Resize(ref samples, room);
        Array.Resize(ref reaches, room);
        Array.Resize(ref weights, room);
        Array.Resize(ref depths, room);
        Array.Resize(ref across, room);
        Array.Resize(ref along, room);
        (Pixels, Facets, Samples, Reaches) = (pixels, facets, samples, reaches);
        (Weights, InverseDepths, Across, Along) = (weights, depths, across, along);
    }
}
