using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace Msisf.Adapters.Raster.Albedo;

/// <summary>A map in a PDS3 image: whole numbers of 8 or 16 bits, or real numbers of 32.</summary>
internal sealed class PdsMapSource : MapSource
{
    /// <summary>Real numbers below this are the special values of USGS ISIS: no data.</summary>
    private const float LeastReal = -1e30f;

    private readonly PdsMapLabel _label;
    private readonly FileStream _stream;
    private byte[] _bytes = [];

    /// <summary>Opens the image of a label.</summary>
    /// <exception cref="BadInputException">The image is missing, unreadable, or shorter than the label says.</exception>
    public PdsMapSource(PdsMapLabel label)
        : base(label.LineSamples, label.Lines, label.Extent, isBytes: label.SampleBits == 8)
    {
        _label = label;
        _stream = FileErrors.ToBadInput(
            $"{label.ImagePath}: can't be read", () => new FileStream(label.ImagePath, FileMode.Open, FileAccess.Read, FileShare.Read));
        long needed = label.ImageOffset + ((long)label.Lines * label.LineSamples * label.SampleBits / 8);
        long found = _stream.Length;
        if (found < needed)
        {
            _stream.Dispose();
            throw new BadInputException(
                $"{label.ImagePath}: {found} bytes, {needed} expected ({label.Lines} lines of {label.LineSamples} samples by "
                    + $"{label.LabelPath}). Get the file again.");
        }
    }

    /// <inheritdoc/>
    public override void Read(int first, int count, Span<float> values)
    {
        int sampleBytes = _label.SampleBits / 8;
        int length = count * Width * sampleBytes;
        Array.Resize(ref _bytes, Math.Max(_bytes.Length, length));
        FileErrors.ToBadInput($"{_label.ImagePath}: can't be read", () =>
        {
            _stream.Position = _label.ImageOffset + ((long)first * Width * sampleBytes);
            _stream.ReadExactly(_bytes, 0, length);
            return true;
        });
        values = values[..(count * Width)];
        Decode(_bytes.AsSpan(0, length), values);
        if (_label.MissingConstant is double missing)
        {
            values.Replace((float)missing, float.NaN);
        }
    }

    /// <inheritdoc/>
    public override void Dispose() => _stream.Dispose();

    private void Decode(Span<byte> bytes, Span<float> values)
    {
        Span<ushort> numbers = MemoryMarshal.Cast<byte, ushort>(bytes);
        Span<uint> words = MemoryMarshal.Cast<byte, uint>(bytes);
        bool isReversed = _label.IsMostSignificantFirst == BitConverter.IsLittleEndian;
        switch (_label.SampleBits)
        {
            case 8:
                for (int i = 0; i < values.Length; i++)
                {
                    values[i] = bytes[i];
                }

                break;
            case 16:
                if (isReversed)
                {
                    BinaryPrimitives.ReverseEndianness(numbers, numbers);
                }

                bool isSigned = _label.IsSigned;
                for (int i = 0; i < values.Length; i++)
                {
                    values[i] = isSigned ? (short)numbers[i] : numbers[i];
                }

                break;
            default:
                if (isReversed)
                {
                    BinaryPrimitives.ReverseEndianness(words, words);
                }

                for (int i = 0; i < values.Length; i++)
                {
                    float value = BitConverter.UInt32BitsToSingle(words[i]);
                    values[i] = value > LeastReal ? value : float.NaN;
                }

                break;
        }
    }
}
