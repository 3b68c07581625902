using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Metadata;

/// <summary>Computes the records of a frame's grid, row by row; nothing is kept, so any picture size streams. Safe for several threads.</summary>
public sealed class PixelSampler
{
    private readonly PinholeCamera _camera;
    private readonly ISurface _surface;
    private readonly Vector3D _sunPositionMoonMe;

    /// <summary>Prepares a frame.</summary>
    /// <param name="camera">The frame's camera.</param>
    /// <param name="grid">Laid over the camera's picture.</param>
    /// <param name="surface">What the pixels show.</param>
    /// <param name="sunPositionMoonMe">The Sun, or the light that stands for it, m.</param>
    /// <exception cref="BadInputException">The Sun's position is not finite.</exception>
    public PixelSampler(PinholeCamera camera, PixelGrid grid, ISurface surface, Vector3D sunPositionMoonMe)
    {
        if (!sunPositionMoonMe.IsFinite)
        {
            throw new BadInputException($"The Sun's position {sunPositionMoonMe} is not finite.");
        }

        _camera = camera;
        _surface = surface;
        _sunPositionMoonMe = sunPositionMoonMe;
        Grid = grid;
    }

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
            int h = Grid.PixelX(column);
            Ray ray = _camera.RayThrough(h, v);
            if (_surface.TryFirstHit(ray, out Vector3D point))
            {
                double? direction = IlluminationDirection.At(_camera, ray.Direction, point, _sunPositionMoonMe);
                records[count++] = new PixelRecord(h, v, SelenographicPoint.Below(point), direction);
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
