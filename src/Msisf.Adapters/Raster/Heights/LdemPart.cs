using Msisf.Adapters.Interop;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// One image of an elevation model, of the whole Moon or a part of it, mapped into memory. Lines and samples of a cylindrical model count
/// in the whole Moon's grid, those of a polar map in the image; those asked for must lie in the part. Safe for several threads, but not
/// while it is disposed.
/// </summary>
internal sealed unsafe class LdemPart : IDisposable
{
    private readonly MappedFile _file;
    private readonly SampleCodec _codec;
    private readonly byte* _moonOrigin;
    private readonly long _lineBytes;
    private readonly int _sampleBytes;
    private readonly Lazy<(bool[] Lines, UndeclaredGaps Undeclared)> _gaps;

    private LdemPart(LdemLabel label, FileStream stream)
    {
        Label = label;
        if (label.Polar is null)
        {
            FirstLine = (int)Math.Round((90.0 - label.NorthDegrees) * label.PixelsPerDegree);
            FirstSample = (int)Math.Round(label.WestDegrees * label.PixelsPerDegree);
        }

        EndSample = FirstSample + label.LineSamples;
        _codec = SampleCodec.For(label);
        _lineBytes = label.LineBytes;
        _sampleBytes = label.SampleBytes;
        _file = new MappedFile(stream);
        _gaps = new(FindGaps);

        // Where the Moon's first sample would lie, so that an address needs no subtractions.
        _moonOrigin = _file.Start + label.ImageOffset - (FirstLine * _lineBytes) - ((long)FirstSample * _sampleBytes);
    }

    /// <summary>What the label says.</summary>
    public LdemLabel Label { get; }

    /// <summary>The part's northernmost line.</summary>
    public int FirstLine { get; }

    /// <summary>The line below its southernmost one.</summary>
    public int EndLine => FirstLine + Label.Lines;

    /// <summary>The part's westernmost sample.</summary>
    public int FirstSample { get; }

    /// <summary>The sample after its easternmost one; samples count on beyond those of the grid.</summary>
    public int EndSample { get; }

    /// <summary>Whether any sample has no data; if the label allows it, the first request looks at all.</summary>
    public bool HasGaps => HasGapsIn(FirstLine, Label.Lines);

    /// <summary>Samples that can't be heights, and that the label does not declare, in the file's lines and samples.</summary>
    public UndeclaredGaps Undeclared => HasGaps ? _gaps.Value.Undeclared : UndeclaredGaps.None;

    /// <summary>Opens the image of a label.</summary>
    /// <exception cref="BadInputException">The image is missing, unreadable, or not as long as the label says.</exception>
    public static LdemPart Open(LdemLabel label)
    {
        string path = FileNames.FindIgnoringCase(label.ImagePath)
            ?? throw new BadInputException(
                $"{label.ImagePath}: missing; {label.LabelPath} says that the samples are there. Put the file beside its label.");
        return FileErrors.ToBadInput($"{path}: can't be read", () =>
        {
            FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read);
            try
            {
                CheckLength(label, path, stream.Length);
                return new LdemPart(label, stream);
            }
            catch
            {
                stream.Dispose();
                throw;
            }
        });
    }

    /// <summary>Radii of consecutive samples, m.</summary>
    /// <exception cref="BadInputException">A sample is outside the label's limits.</exception>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        if (!_codec.TryReadRadii(Address(line, firstSample), radii))
        {
            throw NotAllowed(line, firstSample, radii.Length);
        }
    }

    /// <summary>Whether any sample of some lines has no data; those of other parts may be among them.</summary>
    public bool HasGapsIn(int firstLine, int lines)
    {
        int first = Math.Max(firstLine, FirstLine) - FirstLine;
        int end = Math.Min(firstLine + lines, EndLine) - FirstLine;
        return Label.MayHaveGaps && first < end && _gaps.Value.Lines.AsSpan(first, end - first).Contains(true);
    }

    /// <summary>Tells which of consecutive samples have no data.</summary>
    public void ReadGaps(int line, int firstSample, Span<bool> isGap)
    {
        isGap.Clear();
        bool hasGaps = HasGapsIn(line, 1);
        for (int i = 0; hasGaps && i < isGap.Length; i++)
        {
            isGap[i] = !_codec.IsAllowed(_codec.ValueAt(Address(line, firstSample + i)));
        }
    }

    /// <summary>Has the pages of a block of samples fetched, if some are not in memory.</summary>
    public void Prefetch(int firstLine, int lines, int firstSample, int samples) =>
        MemoryAdvice.Prefetch((nint)Address(firstLine, firstSample), _lineBytes, lines, samples * _sampleBytes);

    /// <summary>The bytes of a line, as they are in the file.</summary>
    public ReadOnlySpan<byte> LineBytes(int line) => new(Address(line, FirstSample), checked((int)_lineBytes));

    /// <summary>Releases the pages that were read; they are mapped again when they are read again.</summary>
    public void ReleasePages() => _file.ReleasePages();

    /// <summary>Unmaps the file.</summary>
    public void Dispose() => _file.Dispose();

    private static void CheckLength(LdemLabel label, string path, long found)
    {
        long needed = label.ImageOffset + label.ImageBytes;
        long expected = label.FileBytes ?? needed;
        if (found != expected)
        {
            throw new BadInputException(
                $"{path}: {found} bytes, {expected} expected ({label.Lines} lines of {label.LineBytes} bytes by {label.LabelPath}). "
                    + $"Get the file again.");
        }
    }

    private byte* Address(int line, int sample) => _moonOrigin + (line * _lineBytes) + ((long)sample * _sampleBytes);

    /// <summary>Which lines have samples without data, and those that the label does not declare.</summary>
    private (bool[] Lines, UndeclaredGaps Undeclared) FindGaps()
    {
        (bool[] lines, UndeclaredGaps undeclared) = (new bool[Label.Lines], UndeclaredGaps.None);
        double[] radii = new double[Label.LineSamples];
        for (int line = 0; line < Label.Lines; line++)
        {
            lines[line] = !_codec.TryReadRadii(Address(FirstLine + line, FirstSample), radii);
            for (int sample = 0; lines[line] && sample < radii.Length; sample++)
            {
                double value = _codec.ValueAt(Address(FirstLine + line, FirstSample + sample));
                bool isUndeclared = !_codec.IsAllowed(value) && value != (float?)Label.Missing;
                undeclared = isUndeclared ? undeclared.With(line, sample, (float)value) : undeclared;
            }
        }

        return (lines, undeclared);
    }

    /// <summary>The error for the first bad sample of a run. Lines and samples in the message count in the file, from 1.</summary>
    private BadInputException NotAllowed(int line, int firstSample, int samples)
    {
        for (int sample = firstSample; sample < firstSample + samples; sample++)
        {
            double value = _codec.ValueAt(Address(line, sample));
            if (!_codec.IsAllowed(value))
            {
                string place = Invariant($"{Label.ImagePath}, line {line - FirstLine + 1}, sample {sample - FirstSample + 1}: ");
                return new BadInputException(place + (Label.MayHaveGaps
                    ? "no data there. Put a coarser model around it, with a second --ldem."
                    : Invariant(
                        $"the value {value:R} is outside the label's MINIMUM and MAXIMUM ({Label.Minimum:R} to {Label.Maximum:R}). ")
                        + "The file is damaged, or the label belongs to another one: get both again. If such values mean no data, delete "
                        + "MINIMUM and MAXIMUM from the label."));
            }
        }

        throw new InvalidOperationException("No sample of the run is outside the limits.");
    }
}
