using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// An LDEM model of a part of the Moon: the surroundings of a pole; or a band between two latitudes, as SLDEM2015, or one part of a split
/// product, whose lines and samples count in the whole Moon's grid.
/// </summary>
/// <remarks>As of <see cref="LdemImage"/>.</remarks>
public sealed class LdemMapImage : ITerrainGrid, IDisposable
{
    private readonly LdemImage _image;

    private LdemMapImage(LdemImage image)
    {
        _image = image;
        Projection = image.Set.Parts[0].Polar is { } polar ? polar : new Equirectangular(image.PixelsPerDegree);
        (int first, int end) = image.Parts is [{ } only] && only.Label.LineSamples < Samples
            ? (only.FirstSample, only.EndSample)
            : (0, Samples);
        Window = new GridWindow(image.Parts.Min(part => part.FirstLine), image.Parts.Max(part => part.EndLine), first, end);
    }

    /// <inheritdoc/>
    public string ProductId => _image.ProductId;

    /// <inheritdoc/>
    public bool HoldsMeans => RasterProducts.HoldsMeans(ProductId);

    /// <inheritdoc/>
    public MapProjection Projection { get; }

    /// <inheritdoc/>
    public int Lines => _image.Lines;

    /// <inheritdoc/>
    public int Samples => _image.Samples;

    /// <inheritdoc/>
    public GridWindow Window { get; }

    /// <inheritdoc/>
    public double ReferenceRadius => _image.ReferenceRadius;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits => _image.RadiusLimits;

    /// <summary>Opens all images of a model.</summary>
    /// <exception cref="BadInputException">An image is missing, unreadable, or not as long as its label says.</exception>
    public static LdemMapImage Open(LdemSet set) => new(LdemImage.OpenParts(set));

    /// <summary>A model of the whole Moon with places without data, as a map that other models fill.</summary>
    /// <param name="image">Closed with the map.</param>
    public static LdemMapImage Of(LdemImage image) => new(image);

    /// <inheritdoc/>
    public bool MayHaveGaps => _image.HasGaps;

    /// <inheritdoc/>
    public bool MayHaveGapsIn(int firstLine, int lines, int firstSample, int samples) =>
        _image.Parts.Any(part => part.HasGapsIn(firstLine, lines));

    /// <inheritdoc cref="LdemImage.NoteOfGaps"/>
    public string? NoteOfGaps() => _image.NoteOfGaps();

    /// <inheritdoc/>
    public void ReadGaps(int line, int firstSample, Span<bool> isGap)
    {
        for (int i = 0, count; i < isGap.Length; i += count)
        {
            (LdemPart part, int at) = _image.PlaceOf(line, firstSample + i);
            count = Math.Min(isGap.Length - i, part.EndSample - at);
            part.ReadGaps(line, at, isGap.Slice(i, count));
        }
    }

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        // A band goes around the Moon, which the image checks.
        bool isBand = Projection is Equirectangular && Window.Samples == Samples;
        if (line < Window.FirstLine || line >= Window.EndLine
            || (!isBand && (firstSample < Window.FirstSample || radii.Length > Window.EndSample - firstSample)))
        {
            _image.RefuseBlock(line, 1, firstSample, radii.Length);
        }

        if (isBand)
        {
            _image.ReadRadii(line, firstSample, radii);
        }
        else
        {
            _image.Parts[0].ReadRadii(line, firstSample, radii);
        }
    }

    /// <inheritdoc/>
    public void ReleasePages() => _image.ReleasePages();

    /// <summary>Unmaps the files.</summary>
    public void Dispose() => _image.Dispose();
}
