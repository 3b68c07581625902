using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// An LDEM model of the whole Moon, in one file or in the parts of a split product, mapped into memory: opening takes no time whatever its
/// size, and only the samples that are asked for are read. The radius of a sample is OFFSET + SCALING_FACTOR * value in doubles, in m.
/// </summary>
/// <remarks>Don't use it after or while it is disposed. A file that is made shorter while it is open ends the process.</remarks>
public sealed class LdemImage : IGlobalGrid, IDisposable
{
    private readonly LdemPart[] _parts;
    private readonly ushort[] _partOfDegree;
    private readonly int _pixelsPerDegree;
    private readonly int _lines;
    private readonly int _samples;
    private bool _isDisposed;

    private LdemImage(LdemSet set, LdemPart[] parts)
    {
        Set = set;
        _parts = parts;
        _partOfDegree = set.PartOfDegree;
        _pixelsPerDegree = set.PixelsPerDegree;
        (_lines, _samples) = set.Parts[0] is { Polar: not null } map
            ? (map.Lines, map.LineSamples)
            : (180 * _pixelsPerDegree, 360 * _pixelsPerDegree);
    }

    /// <summary>The labels that it is made of.</summary>
    public LdemSet Set { get; }

    /// <inheritdoc/>
    public string ProductId => Set.ProductId;

    /// <inheritdoc/>
    public bool HoldsMeans => RasterProducts.HoldsMeans(ProductId);

    /// <inheritdoc/>
    public int PixelsPerDegree => _pixelsPerDegree;

    /// <inheritdoc/>
    public int Lines => _lines;

    /// <inheritdoc/>
    public int Samples => _samples;

    /// <inheritdoc/>
    public double ReferenceRadius => Set.ReferenceRadius;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits =>
        (Set.Parts.Min(part => part.RadiusLimits.Min), Set.Parts.Max(part => part.RadiusLimits.Max));

    /// <summary>Whether any sample has no data: one that can't be a height, or that a label declares.</summary>
    public bool HasGaps => Array.Exists(_parts, part => part.HasGaps);

    /// <summary>A note on the samples that can't be heights and that no label declares; null if there are none.</summary>
    public string? NoteOfGaps()
    {
        LdemPart? first = Array.Find(_parts, part => part.Undeclared.Count > 0);
        return first is null ? null : UndeclaredGaps.NoteOf(
            Path.GetFileName(first.Label.ImagePath), first.Undeclared with { Count = _parts.Sum(part => part.Undeclared.Count) });
    }

    /// <inheritdoc/>
    public void ReleasePages() => Array.ForEach(_parts, part => part.ReleasePages());

    /// <summary>Opens the image of a label.</summary>
    /// <param name="label">A label that covers the whole Moon.</param>
    /// <exception cref="BadInputException">
    /// The label covers a part of the Moon; the image is missing, unreadable, or not as long as the label says.
    /// </exception>
    public static LdemImage Open(LdemLabel label) => Open(LdemSet.Join([label]));

    /// <summary>Opens all images of a model.</summary>
    /// <exception cref="BadInputException">
    /// An image is missing (all that miss are named), unreadable, or not as long as its label says.
    /// </exception>
    public static LdemImage Open(LdemSet set) => set.IsWholeMoon ? OpenParts(set) : throw new BadInputException(Invariant(
        $"{set.Location}: covers latitudes {set.Parts.Min(part => part.SouthDegrees):R} to {set.Parts.Max(part => part.NorthDegrees):R} "
            + $"degrees; a model of the whole Moon is needed here."));

    /// <summary>Opens all images of a model that may be of a part of the Moon; only samples that it has may be asked for.</summary>
    /// <exception cref="BadInputException">As of <see cref="Open(LdemSet)"/>.</exception>
    internal static LdemImage OpenParts(LdemSet set)
    {
        string[] missing = [.. set.Parts.Select(part => part.ImagePath).Where(path => FileNames.FindIgnoringCase(path) is null)];
        if (missing.Length > 1)
        {
            throw new BadInputException(
                $"{set.Location}: {missing.Length} images are missing: {FileNames.Listed(missing.Select(Path.GetFileName))}. "
                    + $"Put them beside their labels.");
        }

        List<LdemPart> parts = [];
        try
        {
            parts.AddRange(set.Parts.Select(LdemPart.Open));
            return new LdemImage(set, [.. parts]);
        }
        catch
        {
            parts.ForEach(part => part.Dispose());
            throw;
        }
    }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        CheckBlock(line, 1, firstSample, radii.Length);
        while (true)
        {
            LdemPart part = PartAt(line, firstSample);
            int at = InPart(part, firstSample);
            int count = Math.Min(radii.Length, part.EndSample - at);
            part.ReadRadii(line, at, radii[..count]);
            if (count == radii.Length)
            {
                return;
            }

            radii = radii[count..];
            firstSample = part.EndSample % _samples;
        }
    }

    /// <inheritdoc/>
    public void Prefetch(int firstLine, int lines, int firstSample, int samples)
    {
        foreach ((LdemPart part, GridWindow block) in PiecesOf(firstLine, lines, firstSample, samples))
        {
            part.Prefetch(block.FirstLine, block.Lines, block.FirstSample, block.Samples);
        }
    }

    /// <summary>Unmaps the files.</summary>
    public void Dispose()
    {
        _isDisposed = true;
        Array.ForEach(_parts, part => part.Dispose());
    }

    /// <summary>The mapped files, in the order of <see cref="LdemSet.Parts"/>.</summary>
    internal IReadOnlyList<LdemPart> Parts => _parts;

    /// <summary>The file of a sample, which may be one beyond the grid's last, and the sample as the file counts it.</summary>
    internal (LdemPart Part, int Sample) PlaceOf(int line, int sample)
    {
        int inGrid = _parts.Length == 1 && sample < _parts[0].EndSample ? sample : sample % _samples;
        LdemPart part = PartAt(line, inGrid);
        return (part, InPart(part, inGrid));
    }

    /// <summary>What the files have of a block of samples.</summary>
    private IEnumerable<(LdemPart Part, GridWindow Block)> PiecesOf(int firstLine, int lines, int firstSample, int samples)
    {
        CheckBlock(firstLine, lines, firstSample, samples);
        int end = firstLine + lines;
        for (int line = firstLine, next; line < end; line = next)
        {
            // No file's border runs through a degree.
            next = _parts.Length == 1 ? end : Math.Min(end, ((line / _pixelsPerDegree) + 1) * _pixelsPerDegree);
            for (int done = 0, count; done < samples; done += count)
            {
                int sample = firstSample + done < _samples ? firstSample + done : firstSample + done - _samples;
                LdemPart part = PartAt(line, sample);
                int at = InPart(part, sample);
                count = Math.Min(samples - done, part.EndSample - at);
                yield return (part, new GridWindow(line, next, at, at + count));
            }
        }
    }

    /// <summary>A sample as the part counts it: one across the prime meridian counts on there.</summary>
    private int InPart(LdemPart part, int sample) => sample < part.FirstSample ? sample + _samples : sample;

    private LdemPart PartAt(int line, int sample) =>
        _parts.Length == 1
            ? _parts[0]
            : _parts[_partOfDegree[((uint)line / (uint)_pixelsPerDegree * 360u) + ((uint)sample / (uint)_pixelsPerDegree)]];

    private void CheckBlock(int firstLine, int lines, int firstSample, int samples)
    {
        if (_isDisposed || firstLine < 0 || lines < 1 || lines > _lines - firstLine || (uint)firstSample >= (uint)_samples
            || (uint)(samples - 1) >= (uint)_samples)
        {
            RefuseBlock(firstLine, lines, firstSample, samples);
        }
    }

    /// <summary>Throws the error of a block that is not there.</summary>
    internal void RefuseBlock(int firstLine, int lines, int firstSample, int samples)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        throw new ArgumentOutOfRangeException(
            nameof(firstLine),
            $"No block of {_lines} x {_samples} samples: {lines} lines from {firstLine}, {samples} samples from {firstSample}.");
    }
}
