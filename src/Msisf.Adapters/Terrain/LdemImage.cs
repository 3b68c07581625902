using System.Globalization;
using System.IO.MemoryMappedFiles;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Terrain;

/// <summary>
/// A whole-Moon LDEM product, mapped into memory: it opens at once whatever its size, and only what is asked for is read.
/// The radius of a sample is OFFSET + SCALING_FACTOR * value in doubles, in m.
/// </summary>
/// <remarks>Don't use it after or while it is disposed. A file that is made shorter while it is open ends the process.</remarks>
public sealed unsafe class LdemImage : IElevationGrid, IDisposable
{
    private readonly MemoryMappedFile _file;
    private readonly MemoryMappedViewAccessor _view;
    private readonly byte* _samples;
    private readonly SampleCodec _codec;

    private LdemImage(LdemLabel label, FileStream stream)
    {
        Label = label;
        _codec = SampleCodec.For(label);
        _file = MemoryMappedFile.CreateFromFile(stream, mapName: null, capacity: 0, MemoryMappedFileAccess.Read, HandleInheritability.None, leaveOpen: false);
        _view = _file.CreateViewAccessor(0, 0, MemoryMappedFileAccess.Read);
        byte* start = null;
        _view.SafeMemoryMappedViewHandle.AcquirePointer(ref start);
        _samples = start + _view.PointerOffset + label.ImageOffset;
    }

    /// <summary>What the label says.</summary>
    public LdemLabel Label { get; }

    /// <inheritdoc/>
    public string ProductId => Label.ProductId;

    /// <inheritdoc/>
    public int PixelsPerDegree => Label.PixelsPerDegree;

    /// <summary>By the label's MINIMUM and MAXIMUM, which each sample is checked against.</summary>
    public (double Least, double Greatest) RadiusLimits
    {
        get
        {
            double slack = Label.HasIntegers ? 0.0 : Tolerances.FloatSampleLimits * (Label.Maximum - Label.Minimum);
            return (Label.Offset + (Label.ScalingFactor * (Label.Minimum - slack)), Label.Offset + (Label.ScalingFactor * (Label.Maximum + slack)));
        }
    }

    /// <summary>Opens the image of a label.</summary>
    /// <param name="label">A label that covers the whole Moon.</param>
    /// <exception cref="BadInputException">The label covers a part of the Moon; the image is missing, unreadable, or not as long as the label says.</exception>
    public static LdemImage Open(LdemLabel label)
    {
        if (!label.CoversWholeMoon)
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{label.LabelPath}: covers latitudes {label.SouthDegrees:R} to {label.NorthDegrees:R} and longitudes {label.WestDegrees:R} to {label.EastDegrees:R} degrees only; one product of the whole Moon is needed (LDEM_4 to LDEM_128)."));
        }

        string path = FileNames.FindIgnoringCase(label.ImagePath)
            ?? throw new BadInputException($"{label.ImagePath}: missing; {label.LabelPath} says that the samples are there. Put the file beside its label.");
        try
        {
            FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read);
            try
            {
                CheckLength(label, path, stream.Length);
                return new LdemImage(label, stream);
            }
            catch
            {
                stream.Dispose();
                throw;
            }
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new BadInputException($"{path}: can't be read: {exception.Message}", exception);
        }
    }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        CheckBlock(line, 1, firstSample, radii.Length);
        int beforeMeridian = Math.Min(radii.Length, Label.LineSamples - firstSample);
        ReadRun(line, firstSample, radii[..beforeMeridian]);
        ReadRun(line, 0, radii[beforeMeridian..]);
    }

    /// <inheritdoc/>
    public (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples)
    {
        CheckBlock(firstLine, lines, firstSample, samples);
        int beforeMeridian = Math.Min(samples, Label.LineSamples - firstSample);
        (double minimum, double maximum) = BoundsOfRun(firstLine, lines, firstSample, beforeMeridian);
        if (beforeMeridian < samples)
        {
            (double eastMinimum, double eastMaximum) = BoundsOfRun(firstLine, lines, 0, samples - beforeMeridian);
            minimum = Math.Min(minimum, eastMinimum);
            maximum = Math.Max(maximum, eastMaximum);
        }

        return (Label.Offset + (Label.ScalingFactor * minimum), Label.Offset + (Label.ScalingFactor * maximum));
    }

    /// <summary>Unmaps the file.</summary>
    public void Dispose()
    {
        if (!_view.SafeMemoryMappedViewHandle.IsClosed)
        {
            _view.SafeMemoryMappedViewHandle.ReleasePointer();
            _view.Dispose();
            _file.Dispose();
        }
    }

    private static void CheckLength(LdemLabel label, string path, long found)
    {
        long needed = label.ImageOffset + label.ImageBytes;
        long expected = label.FileBytes ?? needed;
        if (found != expected)
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{path}: {found} bytes, {expected} expected ({label.Lines} lines of {label.LineBytes} bytes by {label.LabelPath}). Get the file again."));
        }
    }

    private void CheckBlock(int firstLine, int lines, int firstSample, int sampleCount)
    {
        ObjectDisposedException.ThrowIf(_view.SafeMemoryMappedViewHandle.IsClosed, this);
        ArgumentOutOfRangeException.ThrowIfNegative(firstLine);
        ArgumentOutOfRangeException.ThrowIfLessThan(lines, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan((long)firstLine + lines, Label.Lines, nameof(lines));
        ArgumentOutOfRangeException.ThrowIfNegative(firstSample);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(firstSample, Label.LineSamples);
        ArgumentOutOfRangeException.ThrowIfLessThan(sampleCount, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(sampleCount, Label.LineSamples);
    }

    private byte* Address(int line, int sample) => _samples + (line * Label.LineBytes) + ((long)sample * Label.SampleBytes);

    private void ReadRun(int line, int firstSample, Span<double> radii)
    {
        if (!_codec.TryReadRadii(Address(line, firstSample), radii))
        {
            throw NotAllowed(line, 1, firstSample, radii.Length);
        }
    }

    private (double Minimum, double Maximum) BoundsOfRun(int firstLine, int lines, int firstSample, int sampleCount)
    {
        (double minimum, double maximum) = _codec.Bounds(Address(firstLine, firstSample), Label.LineBytes, lines, sampleCount);
        return _codec.IsAllowed(minimum) && _codec.IsAllowed(maximum)
            ? (minimum, maximum)
            : throw NotAllowed(firstLine, lines, firstSample, sampleCount);
    }

    /// <summary>The error for the first bad sample of a block that has one.</summary>
    private BadInputException NotAllowed(int firstLine, int lines, int firstSample, int sampleCount)
    {
        for (int i = 0; i < lines * (long)sampleCount; i++)
        {
            int line = firstLine + (i / sampleCount);
            int sample = firstSample + (i % sampleCount);
            double value = _codec.ValueAt(Address(line, sample));
            if (!_codec.IsAllowed(value))
            {
                return new BadInputException(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{Label.ImagePath}, line {line + 1}, sample {sample + 1}: the value {value:R} is outside the label's MINIMUM and MAXIMUM ({Label.Minimum:R} to {Label.Maximum:R}). The file is damaged, or the label belongs to another one: get both again."));
            }
        }

        throw new InvalidOperationException("No sample of the block is outside the limits.");
    }
}
