using Msisf.Core.Camera;
using Msisf.Core.Render;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.Core.Metadata;

/// <summary>
/// Computes the records of a frame's grid, row by row; nothing is kept, so memory does not grow with the image. Safe for several threads.
/// </summary>
public sealed class PixelSampler
{
    private readonly IPixelView _view;

    /// <summary>Prepares a frame on the reference sphere.</summary>
    /// <param name="grid">The grid of pixels in the camera's image.</param>
    /// <param name="surface">What the pixels show.</param>
    /// <param name="light">The Sun, or the light that stands for it.</param>
    /// <exception cref="BadInputException">The Sun's position is not finite.</exception>
    public PixelSampler(ICamera camera, PixelGrid grid, ISurface surface, SceneLight light)
    {
        _view = new SpherePixels(camera, surface, light);
        Grid = grid;
    }

    /// <summary>Prepares a frame on the terrain.</summary>
    /// <param name="grid">The grid of pixels in the image of the truth's camera.</param>
    /// <param name="pixelsPerDegree">
    /// Resolution of the elevation model, px/deg, at least 1; null for one that is not of latitude and longitude.
    /// </param>
    /// <param name="referenceRadius">m: radius of the sphere over which heights are counted.</param>
    public PixelSampler(
        PixelGrid grid, IGroundTruth truth, int? pixelsPerDegree, double referenceRadius = MoonConstants.ReferenceRadius)
    {
        _view = new TerrainPixels(truth, pixelsPerDegree, referenceRadius);
        Grid = grid;
    }

    private PixelSampler(PixelGrid grid, IPixelView view) => (Grid, _view) = (grid, view);

    /// <summary>Prepares a frame on the terrain of several elevation models, whose facets have no tiles and name their model.</summary>
    /// <param name="grid">The grid of pixels in the image of the truth's camera.</param>
    public static PixelSampler OfSeveral(PixelGrid grid, IGroundTruth truth) =>
        new(grid, new TerrainPixels(truth, pixelsPerDegree: null, MoonConstants.ReferenceRadius, namesParts: true));

    /// <summary>The surface on which the records' points lie; on the terrain each has a <see cref="PixelRecord.Terrain"/>.</summary>
    public PixelSurface Surface => _view.Surface;

    /// <summary>The grid that is sampled.</summary>
    public PixelGrid Grid { get; }

    /// <summary>Computes one row of the grid, from left to right.</summary>
    /// <param name="row">0 to <see cref="PixelGrid.Rows"/> - 1.</param>
    /// <param name="records">Receives the pixels that show the Moon; needs room for <see cref="PixelGrid.Columns"/>.</param>
    /// <returns>How many there are.</returns>
    public int SampleRow(int row, Span<PixelRecord> records)
    {
        int count = 0;
        int v = Grid.PixelY(row);
        for (int column = 0; column < Grid.Columns; column++)
        {
            if (_view.TryGet(Grid.PixelX(column), v, out PixelRecord record))
            {
                records[count++] = record;
            }
        }

        return count;
    }

    /// <summary>All records, by rows from the top, each from left to right; one row is in memory at a time.</summary>
    public IEnumerable<PixelRecord> Sample()
    {
        PixelRecord[] records = new PixelRecord[Grid.Columns];
        for (int row = 0; row < Grid.Rows; row++)
        {
            int count = SampleRow(row, records);
            for (int i = 0; i < count; i++)
            {
                yield return records[i];
            }
        }
    }
}
