using Msisf.Core.Camera;
using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>
/// Chooses levels of detail, for both renderers: a cell is at most twice as wide as what may move in the image. It is a mean over its
/// width, so nothing moves by more than half of that.
/// </summary>
public sealed class DetailRule
{
    /// <summary>
    /// px: the default error where a whole image is drawn with one level, beside a sample of the nearest ground. Measured
    /// (docs/native-renderer.md): the image is as near to the mean of many samples of the full model as one of the full model with as many
    /// samples is.
    /// </summary>
    public const double DefaultErrorOfImage = 0.35;

    /// <summary>px: the default error where each part of the surface has a level of its own. Measured (docs/levels-of-detail.md).</summary>
    public const double DefaultErrorOfParts = 0.33;

    private const double ErrorsPerCell = 2.0;

    /// <summary>
    /// A coarser ridge lies somewhat lower than the true one, and what is behind it somewhat higher. Differences in height are mostly below
    /// half a cell, the error; the rest is reserve.
    /// </summary>
    private const double ErrorsOfSlack = 8.0;

    private readonly int _levels;
    private readonly double _finestCell;
    private readonly double _errorPixels;

    /// <summary>Takes the model and the allowed error.</summary>
    /// <param name="levels">The model and its levels.</param>
    /// <param name="errorPixels">How far a coarser level may move what is seen, in pixels; 0 for the model itself everywhere.</param>
    public DetailRule(LodLevels levels, double errorPixels)
    {
        _levels = levels.Count;
        _finestCell = MoonConstants.ReferenceRadius * Math.PI / 180.0 / levels.Level(0).PixelsPerDegree;
        _errorPixels = errorPixels;
    }

    /// <summary>px: ground this far beside the image may be drawn inside it by a coarser level.</summary>
    public double MarginPixels => ErrorsPerCell * _errorPixels;

    /// <summary>px: ground that is hidden by less than this may be seen with a coarser level.</summary>
    public double SlackPixels => ErrorsOfSlack * _errorPixels;

    /// <summary>
    /// The level of a whole image, by the height over the reference sphere: no ground in the image is nearer but for mountains.
    /// </summary>
    /// <param name="footprint">Of the image's pixels.</param>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    /// <returns>0 for the model itself; each further level has half the resolution.</returns>
    public int LevelOfImage(PixelFootprint footprint, int subsamplesPerAxis)
    {
        double height = footprint.PositionMoonMe.Length - MoonConstants.ReferenceRadius;
        return LevelOfPixel(height * footprint.Tangent / subsamplesPerAxis);
    }

    /// <summary>The coarsest level that is allowed where a pixel covers so much.</summary>
    /// <param name="metresPerPixel">m.</param>
    public int LevelOfPixel(double metresPerPixel) => LevelOfCell(WidestCell(metresPerPixel));

    /// <summary>m: the widest cell that is allowed where a pixel covers so much.</summary>
    /// <param name="metresPerPixel">m.</param>
    public double WidestCell(double metresPerPixel) => ErrorsPerCell * _errorPixels * metresPerPixel;

    /// <summary>m: how far the edge of a shadow may move where a pixel covers so much.</summary>
    /// <param name="metresPerPixel">m.</param>
    public double MaxShift(double metresPerPixel) => _errorPixels * metresPerPixel;

    /// <summary>The coarsest level with cells no wider than a limit; the model itself, 0, if even its cells are wider.</summary>
    /// <param name="widestCell">m, at the reference sphere's equator.</param>
    public int LevelOfCell(double widestCell)
    {
        int level = 0;
        for (double cell = 2.0 * _finestCell; level + 1 < _levels && cell <= widestCell; cell *= 2.0)
        {
            level++;
        }

        return level;
    }
}
