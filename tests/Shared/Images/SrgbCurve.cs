namespace Msisf.TestSupport.Images;

/// <summary>Grey levels and linear grey, by IEC 61966-2-1.</summary>
internal static class SrgbCurve
{
    /// <summary>Linear grey, 0 to 1, of levels of 255.</summary>
    /// <param name="levels">[y, x].</param>
    public static double[,] Linear(double[,] levels)
    {
        double[,] linear = new double[levels.GetLength(0), levels.GetLength(1)];
        for (int y = 0; y < levels.GetLength(0); y++)
        {
            for (int x = 0; x < levels.GetLength(1); x++)
            {
                linear[y, x] = Linear(levels[y, x] / 255.0);
            }
        }

        return linear;
    }

    private static double Linear(double encoded) => encoded <= 0.04045 ? encoded / 12.92 : Math.Pow((encoded + 0.055) / 1.055, 2.4);
}
