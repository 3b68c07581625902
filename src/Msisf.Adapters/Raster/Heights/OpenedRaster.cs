using Msisf.Adapters.Interop;
using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// A raster that GDAL has opened, resampled if its pixels lie on no grid that is read, and where its samples lie. Not safe for several
/// threads, unless <see cref="IsShared"/>.
/// </summary>
internal sealed class OpenedRaster : IDisposable
{
    private const string PdsDriver = "PDS";

    /// <summary>Rows whose two ends are read after each other: what GDAL has unpacked for the first is kept for the second.</summary>
    private const int RowsAtOnce = 16;

    private readonly ResampledMap? _resampled;

    private OpenedRaster(GdalImage file, GeoTiffPlacement placement, ResampledMap? resampled) =>
        (File, Placement, _resampled) = (file, placement, resampled);

    /// <summary>The file.</summary>
    public GdalImage File { get; }

    /// <summary>Where the samples lie.</summary>
    public GeoTiffPlacement Placement { get; }

    /// <summary>Whether several threads may read at once.</summary>
    public bool IsShared => File.IsMapped && !IsWarped;

    /// <summary>Whether samples are bilinear between the file's pixels, and not these.</summary>
    public bool IsWarped => _resampled is not null;

    /// <summary>Reads a rectangle.</summary>
    /// <param name="line">Top line, counted in the placement's window.</param>
    /// <param name="lines">How many lines.</param>
    /// <param name="sample">Leftmost sample, counted in the window, whose first one the file need not begin with.</param>
    /// <param name="samples">How many samples of a line.</param>
    /// <param name="values">Receives the values, NaN without data.</param>
    /// <param name="stride">Values from one line to the next.</param>
    /// <param name="rule">Tells which values have no data.</param>
    /// <returns>Values that can't be heights, and that the file does not declare, in the file's lines and samples.</returns>
    /// <exception cref="BadInputException">The file is damaged.</exception>
    public UndeclaredGaps Read(int line, int lines, int sample, int samples, Span<float> values, int stride, HeightRule rule)
    {
        if (_resampled is not null)
        {
            return _resampled.Read(line, lines, sample, samples, values, stride, rule);
        }

        ReadPixels(line, lines, sample, samples, values, stride);
        UndeclaredGaps undeclared = UndeclaredGaps.None;
        for (int i = 0; i < lines; i++)
        {
            Span<float> row = values.Slice(i * stride, samples);
            for (int j = rule.AreHeights(row) ? row.Length : 0; j < row.Length; j++)
            {
                if (!rule.IsHeight(row[j]))
                {
                    undeclared = float.IsNaN(row[j]) && File.DeclaresGaps
                        ? undeclared
                        : undeclared.With(line + i, Placement.ColumnOf(sample + j), row[j]);
                    row[j] = float.NaN;
                }
            }
        }

        return undeclared;
    }

    /// <summary>Counts the pixels of the file that can't be heights, and that it does not declare.</summary>
    public UndeclaredGaps Undeclared(HeightRule rule)
    {
        UndeclaredGaps found = UndeclaredGaps.None;
        int lines = Math.Clamp((1 << 22) / File.Width, 1, File.Height);
        float[] values = new float[lines * File.Width];
        for (int line = 0; line < File.Height; line += lines)
        {
            int count = Math.Min(lines, File.Height - line);
            File.Read(line, count, 0, File.Width, values);
            for (int i = 0; i < count * File.Width; i++)
            {
                bool counts = !rule.IsHeight(values[i]) && !(float.IsNaN(values[i]) && File.DeclaresGaps);
                found = counts ? found.With(line + (i / File.Width), i % File.Width, values[i]) : found;
            }
        }

        return found;
    }

    private void ReadPixels(int line, int lines, int sample, int samples, Span<float> values, int stride)
    {
        int column = Placement.ColumnOf(sample);
        int before = Math.Min(samples, File.Width - column);
        if (before == samples && File.IsEmpty(line, lines, column, samples))
        {
            for (int i = 0; i < lines; i++)
            {
                values.Slice(i * stride, samples).Fill(float.NaN);
            }

            return;
        }

        int step = before == samples ? lines : RowsAtOnce;
        for (int row = 0; row < lines; row += step)
        {
            int rows = Math.Min(step, lines - row);
            Span<float> part = values[(row * stride)..];
            File.Read(line + row, rows, column, before, part, stride);
            if (before < samples)
            {
                File.Read(line + row, rows, 0, samples - before, part[before..], stride);
            }
        }
    }

    /// <summary>Opens a file.</summary>
    /// <param name="libraryPath">MSISF_GDAL, or null.</param>
    /// <exception cref="ExternalPartException">GDAL is missing.</exception>
    /// <exception cref="BadInputException">The file is not an image, or not of a part of the Moon in a projection that is read.</exception>
    public static OpenedRaster Open(string path, string? libraryPath)
    {
        GdalImage file = GdalImage.Open(
            path, libraryPath, "Give an elevation model in PDS3, or in GeoTIFF or another format of maps that GDAL reads.");
        try
        {
            if (file.Driver == PdsDriver)
            {
                PdsLongitudes.RequireGdals(path);
            }

            GeoTiffPlacement? placement = GeoTiffPlacement.Find(
                path, file.Width, file.Height, file.GeoTransform(), file.Projection(), file.Driver == PdsDriver);
            return placement is not null ? new OpenedRaster(file, placement, resampled: null)
                : ResampledMap.Of(file) is { } resampled ? new OpenedRaster(file, resampled.Placement, resampled)
                : throw new BadInputException(Invariant(
                    $"{path}: its pixels ({file.Projection()}) are smaller than {PolarLabel.MinScale:R} m, or lie nowhere on the Moon. ")
                    + "If they are small, make them larger: "
                    + "gdalwarp -r average -t_srs '+proj=longlat +R=1737400' -tr 0.00002 0.00002 -tap (degrees; 0.6 m).");
        }
        catch
        {
            file.Dispose();
            throw;
        }
    }

    /// <summary>Closes the file.</summary>
    public void Dispose()
    {
        _resampled?.Dispose();
        File.Dispose();
    }
}
