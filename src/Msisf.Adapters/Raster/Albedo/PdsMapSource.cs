using System.Buffers.Binary;
using System.Globalization;
using System.Runtime.InteropServices;
using Msisf.Core.Errors;
using Msisf.Core.Render.Photometry;

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
    {
        _label = label;
        _stream = FileErrors.ToBadInput(
            $"{label.ImagePath}: can't be read", () => new FileStream(label.ImagePath, FileMode.Open, FileAccess.Read, FileShare.Read));
        long needed = label.ImageOffset + ((long)label.Lines * label.LineSamples * label.SampleBits / 8);
        if (_stream.Length < needed)
        {
            long found = _stream.Length;
            _stream.Dispose();
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{label.ImagePath}: {found} bytes, {needed} expected ({label.Lines} lines of {label.LineSamples} samples by "
                    + $"{label.LabelPath}). Get the file again."));
        }
    }

    /// <inheritdoc/>
    public override int Width => _label.LineSamples;

    /// <inheritdoc/>
    public override int Height => _label.Lines;

    /// <inheritdoc/>
    public override MapExtent? Extent => _label.Extent;

    /// <inheritdoc/>
    public override bool IsBytes => _label.SampleBits == 8;

    /// <inheritdoc/>
    public override void Read(int first, int count, Span<float> values)
    {
        int samples = count * Width;
        int sampleBytes = _label.SampleBits / 8;
        if (_bytes.Length < samples * sampleBytes)
        {
            _bytes = new byte[samples * sampleBytes];
        }

        Span<byte> bytes = _bytes.AsSpan(0, samples * sampleBytes);
        FileErrors.ToBadInput($"{_label.ImagePath}: can't be read", () =>
        {
            _stream.Position = _label.ImageOffset + ((long)first * Width * sampleBytes);
            _stream.ReadExactly(_bytes, 0, samples * sampleBytes);
            return true;
        });
        Decode(bytes, values[..samples]);
        if (_label.MissingConstant is double missing)
        {
            values[..samples].Replace((float)missing, float.NaN);
        }
    }

    /// <inheritdoc/>
    public override void Dispose() => _stream.Dispose();

    private void Decode(Span<byte> bytes, Span<float> values)
    {
        switch (_label.SampleBits)
        {
            case 8:
                for (int i = 0; i < values.Length; i++)
                {
                    values[i] = bytes[i];
                }

                break;
            case 16:
                Span<ushort> numbers = MemoryMarshal.Cast<byte, ushort>(bytes);
                if (_label.IsMostSignificantFirst == BitConverter.IsLittleEndian)
                {
                    BinaryPrimitives.ReverseEndianness(numbers, numbers);
                }

                for (int i = 0; i < values.Length; i++)
                {
                    values[i] = _label.IsSigned ? (short)numbers[i] : numbers[i];
                }

                break;
            default:
                Span<uint> words = MemoryMarshal.Cast<byte, uint>(bytes);
                if (_label.IsMostSignificantFirst == BitConverter.IsLittleEndian)
                {
                    BinaryPrimitives.ReverseEndianness(words, words);
                }

                MemoryMarshal.Cast<uint, float>(words).CopyTo(values);
                for (int i = 0; i < values.Length; i++)
                {
                    values[i] = values[i] > LeastReal ? values[i] : float.NaN;
                }

                break;
        }
    }
}
