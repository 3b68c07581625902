namespace Msisf.TestSupport.Images;

/// <summary>Images that are compared have one size.</summary>
internal static class ImageSize
{
    /// <exception cref="ArgumentException">The sizes differ.</exception>
    public static void Check(double[,] truth, double[,] other)
    {
        if (truth.GetLength(0) != other.GetLength(0) || truth.GetLength(1) != other.GetLength(1))
        {
            throw new ArgumentException(FormattableString.Invariant(
                $"The image is {other.GetLength(1)} x {other.GetLength(0)} px, its truth {truth.GetLength(1)} x {truth.GetLength(0)} px."));
        }
    }
}
