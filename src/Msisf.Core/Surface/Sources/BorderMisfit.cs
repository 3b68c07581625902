namespace Msisf.Core.Surface.Sources;

/// <summary>
/// How far a model's own heights are off the ground of the coarser models along its border, where it is bent to meet them
/// (<see cref="BorderBlend"/>).
/// </summary>
/// <param name="ProductId">Name of the model.</param>
/// <param name="Mean">m: the model's height less that of the coarser ones, the mean.</param>
/// <param name="Rms">m: the root of the mean square.</param>
/// <param name="Greatest">m: the one that is farthest from 0.</param>
/// <param name="BentSamples">Samples from the border over which the model is bent.</param>
/// <param name="BentMetres">m: the same.</param>
public readonly record struct BorderMisfit(
    string ProductId, double Mean, double Rms, double Greatest, int BentSamples, double BentMetres)
{
    /// <summary>
    /// Tiles of the border that are looked at; of more, these are spread over it evenly. 4,096 samples tell a mean, and their blocks of a
    /// compressed file are read in less than a second.
    /// </summary>
    private const int MaxTiles = 128;

    /// <summary>Compares a model's outermost samples, also those around places without data.</summary>
    internal static BorderMisfit Of(BorderBlend model)
    {
        int[] tiles = [.. model.BorderTiles()];
        int step = Math.Max(1, (tiles.Length + MaxTiles - 1) / MaxTiles);
        (double sum, double squares, double greatest, int count) = (0.0, 0.0, 0.0, 0);
        for (int i = 0; i < tiles.Length; i += step)
        {
            foreach (double misfit in model.MisfitsIn(tiles[i]))
            {
                sum += misfit;
                squares += misfit * misfit;
                greatest = Math.Abs(misfit) > Math.Abs(greatest) ? misfit : greatest;
                count++;
            }
        }

        double number = Math.Max(1, count);
        return new BorderMisfit(
            model.ProductId, sum / number, Math.Sqrt(squares / number), greatest, model.Width,
            model.Width * model.Projection.Resolution.MetresPerPixel);
    }
}
