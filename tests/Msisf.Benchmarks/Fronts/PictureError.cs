using Msisf.TestSupport;
using Msisf.TestSupport.Pictures;

namespace Msisf.Benchmarks.Fronts;

/// <summary>How wrong a picture is.</summary>
/// <param name="Grey">Grey levels.</param>
/// <param name="Light">Lit or dark.</param>
/// <param name="Limb">Silhouette.</param>
internal sealed record PictureError(GreyDifference Grey, LightDisagreement Light, LimbDisplacement Limb)
{
    private const double White = 255.0;

    /// <summary>Compares a picture with its truth.</summary>
    /// <param name="truth">The truth.</param>
    /// <param name="picturePath">The picture, PNG; of a picture in colours the first, which is grey with POV-Ray too.</param>
    public static PictureError Of(PictureTruth truth, string picturePath)
    {
        double[,] levels = PngPixels.Read(picturePath).ChannelParts(0);
        for (int y = 0; y < levels.GetLength(0); y++)
        {
            for (int x = 0; x < levels.GetLength(1); x++)
            {
                levels[y, x] *= White;
            }
        }

        return new PictureError(
            GreyDifference.Of(truth.Levels, levels),
            LightDisagreement.Of(truth.Coverage, truth.LitFractions, truth.Levels, levels),
            LimbDisplacement.Of(truth.Coverage, truth.LinearGrey, SrgbCurve.Linear(levels)));
    }
}
