namespace Msisf.Core.Detector;

/// <summary>The electrons that a detector's rows collect while they are shifted past the light of other rows.</summary>
internal static class SmearSum
{
    /// <summary>Computes the smear of some columns.</summary>
    /// <param name="electrons">Electrons of the exposure, by rows.</param>
    /// <param name="width">px.</param>
    /// <param name="settings">Settings of the detector, with smear.</param>
    /// <param name="smear">Receives the electrons of these columns, by rows.</param>
    public static void Fill(
        ReadOnlySpan<double> electrons, int width, Range columns, DetectorSettings settings, Span<double> smear)
    {
        if (settings.Smear is not Smear shift)
        {
            return;
        }

        int height = electrons.Length / width;
        (int start, int count) = columns.GetOffsetAndLength(width);
        double part = shift.RowTime / settings.ExposureTime;
        double[] passed = new double[count];
        if (shift.BeforeExposure)
        {
            // Shifted past the rows on one side before the exposure and past those on the other side after it.
            for (int row = 0; row < height; row++)
            {
                Add(electrons.Slice((row * width) + start, count), passed);
            }

            for (int row = 0; row < height; row++)
            {
                ReadOnlySpan<double> own = electrons.Slice((row * width) + start, count);
                Span<double> target = smear.Slice((row * width) + start, count);
                for (int column = 0; column < count; column++)
                {
                    target[column] = part * Math.Max(0.0, passed[column] - own[column]);
                }
            }

            return;
        }

        for (int step = 0; step < height; step++)
        {
            int row = shift.TowardsBottom ? height - 1 - step : step;
            Span<double> target = smear.Slice((row * width) + start, count);
            for (int column = 0; column < count; column++)
            {
                target[column] = part * passed[column];
            }

            Add(electrons.Slice((row * width) + start, count), passed);
        }
    }

    private static void Add(ReadOnlySpan<double> row, Span<double> sums)
    {
        for (int column = 0; column < row.Length; column++)
        {
            sums[column] += row[column];
        }
    }
}
