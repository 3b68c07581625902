using Msisf.Adapters.Interop;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// A raster that GDAL has opened, warped if its pixels lie on no grid that is read, and where its pixels lie. Not safe for several threads.
/// </summary>
internal sealed class OpenedRaster : IDisposable
{
    private OpenedRaster(GdalImage file, GdalImage image, GeoTiffPlacement placement) =>
        (File, Image, Placement) = (file, image, placement);

    /// <summary>The file.</summary>
    public GdalImage File { get; }

    /// <summary>It, or the warped one.</summary>
    public GdalImage Image { get; }

    /// <summary>Where the pixels of the image lie.</summary>
    public GeoTiffPlacement Placement { get; }

    /// <summary>Whether the image is warped.</summary>
    public bool IsWarped => !ReferenceEquals(File, Image);

    /// <summary>Opens a file.</summary>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <param name="gap">The value of pixels without data, where the file does not say it but is warped; null for none.</param>
    /// <exception cref="ExternalPartException">GDAL is missing.</exception>
    /// <exception cref="BadInputException">The file is no image, or not of a part of the Moon in a projection that is read.</exception>
    public static OpenedRaster Open(string path, string? libraryPath, float? gap = null)
    {
        GdalImage file = GdalImage.Open(path, libraryPath);
        GdalImage? warped = null;
        try
        {
            if (PlacementOf(path, file, out string otherForm) is { } own)
            {
                return new OpenedRaster(file, file, own);
            }

            string? noData = gap?.ToString("R", CultureInfo.InvariantCulture).Replace("Infinity", "inf", StringComparison.Ordinal);
            string[] gapWords = noData is null ? [] : ["-srcnodata", noData];
            warped = GeoTiffWarp.Of(path, file, gapWords);
            return warped is not null && PlacementOf(path, warped, out _) is { } placement
                ? new OpenedRaster(file, warped, placement)
                : throw new BadInputException(otherForm);
        }
        catch
        {
            warped?.Dispose();
            file.Dispose();
            throw;
        }
    }

    /// <summary>Closes the file.</summary>
    public void Dispose()
    {
        if (IsWarped)
        {
            Image.Dispose();
        }

        File.Dispose();
    }

    private static GeoTiffPlacement? PlacementOf(string path, GdalImage image, out string otherForm) =>
        GeoTiffPlacement.Find(path, image.Width, image.Height, image.GeoTransform(), image.Projection(), out otherForm);
}

/// <summary>
/// Looks for pixels that can't be heights in a raster that is warped: interpolated with their neighbours they would look like heights.
/// </summary>
internal static class GapsOfSource
{
    /// <summary>Such pixels, all of one value.</summary>
    /// <param name="path">The file, for messages.</param>
    /// <param name="file">It, not warped.</param>
    /// <param name="given">What the user says of its values.</param>
    /// <exception cref="BadInputException">There are pixels of several such values.</exception>
    public static UndeclaredGaps Find(string path, GdalImage file, HeightOptions given)
    {
        HeightRule rule = HeightRule.Of(path, file, given, pixel: double.PositiveInfinity);
        UndeclaredGaps found = UndeclaredGaps.None;
        int lines = Math.Clamp((1 << 22) / file.Width, 1, file.Height);
        float[] values = new float[lines * file.Width];
        for (int line = 0; line < file.Height; line += lines)
        {
            int count = Math.Min(lines, file.Height - line);
            file.Read(line, count, 0, file.Width, values);
            for (int i = 0; i < count * file.Width; i++)
            {
                if (rule.IsHeight(values[i]) || (float.IsNaN(values[i]) && file.NoData is not null))
                {
                    continue;
                }

                (int row, int column) = (line + (i / file.Width), i % file.Width);
                bool isKnown = found.Count == 0 ? file.NoData is null : values[i].Equals(found.Value);
                found = isKnown ? found.With(row, column, values[i]) : throw new BadInputException(Invariant(
                    $"{path}, line {row + 1}, sample {column + 1}: {values[i]:R}, which is no height, besides "
                        + $"{file.NoData ?? found.Value:R}. A map that is warped may have one value without data: make the others "
                        + $"that one, e.g. with gdal_calc.py."));
            }
        }

        return found;
    }
}
