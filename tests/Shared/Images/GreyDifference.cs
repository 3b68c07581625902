namespace Msisf.TestSupport.Images;

/// <summary>How far the grey levels of an image are from those of another one.</summary>
/// <param name="DifferingFraction">Part of all pixels that differ by more than one level, 0 to 1.</param>
/// <param name="Rms">Root of the mean square of the differences over all pixels, levels.</param>
/// <param name="Largest">Maximum difference, levels.</param>
internal readonly record struct GreyDifference(double DifferingFraction, double Rms, double Largest)
{
    /// <summary>Rounding alone makes a difference of one level.</summary>
    private const double OneLevel = 1.0;

    /// <summary>Compares two images of the same size.</summary>
    /// <param name="truth">Grey levels, [y, x].</param>
    /// <param name="image">Grey levels, [y, x].</param>
    public static GreyDifference Of(double[,] truth, double[,] image)
    {
        ImageSize.Check(truth, image);
        int differing = 0;
        double squares = 0.0;
        double largest = 0.0;
        for (int y = 0; y < truth.GetLength(0); y++)
        {
            for (int x = 0; x < truth.GetLength(1); x++)
            {
                double difference = Math.Abs(image[y, x] - truth[y, x]);
                differing += difference > OneLevel ? 1 : 0;
                squares += difference * difference;
                largest = Math.Max(largest, difference);
            }
        }

        return new GreyDifference((double)differing / truth.Length, Math.Sqrt(squares / truth.Length), largest);
    }
}
