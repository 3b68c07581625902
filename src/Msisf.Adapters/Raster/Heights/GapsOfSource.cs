using Msisf.Adapters.Interop;

namespace Msisf.Adapters.Raster.Heights;

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
                found = isKnown ? found.With(row, column, values[i]) : throw new BadInputException(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{path}, line {row + 1}, sample {column + 1}: {values[i]:R}, which is no height, besides "
                        + $"{file.NoData ?? found.Value:R}. A map that is warped may have one value without data: make the others "
                        + $"that one, e.g. with gdal_calc.py."));
            }
        }

        return found;
    }
}
