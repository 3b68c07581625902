using Msisf.Core.Camera;

namespace Msisf.Core.Lod;

/// <summary>
/// Chooses levels of detail, for both renderers: a cell is at most twice as wide as the allowed error in the image. A coarse sample is
/// the mean over its cell, so a point moves by at most half a cell.
/// </summary>
public sealed class DetailRule
{
    /// <summary>
    /// px: the default error where a whole image is drawn with one level, in units of the distance between samples on the nearest ground.
    /// Measured (docs/native-renderer.md): the image is as close to the mean of many samples of the full model as an image of the full
    /// model with the same number of samples.
    /// </summary>
    public const double DefaultError = 0.35;

    private const double ErrorsPerCell = 2.0;

    private readonly int _levels;
    private readonly double _finestCell;
    private readonly double _errorPixels;
    private readonly double _referenceRadius;

    /// <summary>Takes the model and the allowed error.</summary>
    /// <param name="errorPixels">How far a coarser level may move what is seen, in pixels; 0 for the model itself everywhere.</param>
    public DetailRule(TerrainLevels levels, double errorPixels)
    {
        _levels = levels.Count;
        _referenceRadius = levels.Grid(0).ReferenceRadius;
        _finestCell = levels.Grid(0).Projection.Resolution.OnSphere(_referenceRadius).MetresPerPixel;
        _errorPixels = errorPixels;
    }

    /// <summary>The level of a whole image, from the camera's height over the reference sphere; only mountains can be nearer.</summary>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    /// <returns>0 for the model itself; each further level has half the resolution.</returns>
    public int LevelOfImage(PixelFootprint footprint, int subsamplesPerAxis)
    {
        double height = footprint.PositionBodyFixed.Length - _referenceRadius;
        return LevelOfPixel(height * footprint.Tangent / subsamplesPerAxis);
    }

    /// <summary>The coarsest level that is allowed for a pixel of this size.</summary>
    /// <param name="metresPerPixel">Width that a pixel covers, m.</param>
    public int LevelOfPixel(double metresPerPixel) => LevelOfCell(WidestCell(metresPerPixel));

    /// <summary>m: the widest cell that is allowed for a pixel of this size.</summary>
    /// <param name="metresPerPixel">Width that a pixel covers, m.</param>
    public double WidestCell(double metresPerPixel) => ErrorsPerCell * _errorPixels * metresPerPixel;

    /// <summary>m: width of the cells of a level, on the reference sphere, where they are widest.</summary>
    /// <param name="level">0 for the model itself.</param>
    public double CellOf(int level) => Math.ScaleB(_finestCell, level);

    /// <summary>The coarsest level with cells no wider than a limit; the model itself, 0, if even its cells are wider.</summary>
    /// <param name="widestCell">m, on the reference sphere, where the model's cells are widest.</param>
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
