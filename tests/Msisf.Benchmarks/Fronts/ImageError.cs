using Msisf.TestSupport;
using Msisf.TestSupport.Images;

namespace Msisf.Benchmarks.Fronts;

/// <summary>How wrong an image is.</summary>
/// <param name="Grey">Grey levels.</param>
/// <param name="Light">Lit or dark.</param>
/// <param name="Limb">Silhouette.</param>
internal sealed record ImageError(GreyDifference Grey, LightDisagreement Light, LimbDisplacement Limb)
{
    private const double White = 255.0;

    /// <summary>Compares an image with its truth.</summary>
    /// <param name="truth">The truth.</param>
    /// <param name="imagePath">The image, PNG; of an image in colours the first, which is grey with POV-Ray too.</param>
    public static ImageError Of(ImageTruth truth, string imagePath)
    {
        double[,] levels = PngPixels.Read(imagePath).ChannelParts(0);
        for (int y = 0; y < levels.GetLength(0); y++)
        {
            for (int x = 0; x < levels.GetLength(1); x++)
            {
                levels[y, x] *= White;
            }
        }

        return new ImageError(
            GreyDifference.Of(truth.Levels, levels),
            LightDisagreement.Of(truth.Coverage, truth.LitFractions, truth.Levels, levels),
            LimbDisplacement.Of(truth.Coverage, truth.LinearGrey, SrgbCurve.Linear(levels)));
    }
}
