using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Mesh.Bounds;
using Msisf.Core.Numerics;

namespace Msisf.Core.Tiles.Selection;

/// <summary>Which levels of detail an image allows where.</summary>
internal sealed class DetailRule
{
    /// <summary>
    /// A cell of a coarser level is at most so many times the allowed error wide: it is a mean over its width, so nothing moves by more than half of that.
    /// </summary>
    private const double ErrorsACell = 2.0;

    /// <summary>
    /// What is hidden by less than so many times the error counts as seen: a coarser ridge lies somewhat lower than the true one, and what is behind it
    /// somewhat higher. Differences in height are mostly below half a cell, the error; the rest is reserve.
    /// </summary>
    private const double ErrorsOfSlack = 8.0;

    private readonly Vector3D _camera;
    private readonly Vector3D _forward;
    private readonly double _pixel;
    private readonly double _cosCorner;
    private readonly int _pixelsPerDegree;
    private readonly int _levels;
    private readonly double _errorPixels;

    /// <param name="camera">The camera.</param>
    /// <param name="errorPixels">So far, in pixels, a coarser level may move what is seen; 0 for the model itself everywhere.</param>
    /// <param name="pixelsPerDegree">Samples a degree of the model.</param>
    /// <param name="levels">How many levels there are, the model itself included.</param>
    public DetailRule(PinholeCamera camera, double errorPixels, int pixelsPerDegree, int levels)
    {
        _camera = camera.PositionMoonMe;
        _forward = camera.ForwardMoonMe;
        double focalLength = camera.Direction.Length;
        double right = camera.Right.Length / (2.0 * focalLength);
        double up = camera.Up.Length / (2.0 * focalLength);
        _pixel = Math.Min(2.0 * right / camera.Width, 2.0 * up / camera.Height);
        _cosCorner = 1.0 / Math.Sqrt(1.0 + (right * right) + (up * up));
        _pixelsPerDegree = pixelsPerDegree;
        _levels = levels;
        _errorPixels = errorPixels;
    }

    /// <summary>rad: what is hidden by less than this counts as seen.</summary>
    public double Slack => ErrorsOfSlack * _errorPixels * _pixel;

    /// <summary>px: the image is taken to be so much wider on each side; one for antialiasing, the rest for what a level may move.</summary>
    public double MarginPixels => 1.0 + (2.0 * _errorPixels);

    /// <summary>The coarsest level that any ground in sight may be drawn with.</summary>
    /// <param name="summary">Bounds of the terrain.</param>
    public int CoarsestLevel(ElevationSummary summary)
    {
        double distance = _camera.Length;
        double min = summary.MinRadius;
        double toHorizon = Math.Sqrt(Math.Max(0.0, (distance - min) * (distance + min)));
        double behind = Math.Sqrt((summary.MaxRadius - min) * (summary.MaxRadius + min));
        return LevelOfCell(WidestCell((toHorizon + behind) * _pixel));
    }

    /// <summary>m: what a pixel covers, at least, across the line of sight to a piece of the surface; 0 if the camera may be in it.</summary>
    public double MetresPerPixel(in TerrainNode node)
    {
        (Vector3D centre, double radius) = node.Ball();
        Vector3D toCentre = centre - _camera;
        double distance = toCentre.Length;

        // Towards the corners of a flat image an angle takes more pixels, by the square of the cosine along the radius.
        double cos = Math.Clamp(Vector3D.Dot(toCentre, _forward) / distance, _cosCorner, 1.0);
        return Math.Max(0.0, distance - radius) * _pixel * cos * cos;
    }

    /// <summary>m: the widest cell that is allowed where a pixel covers so much.</summary>
    public double WidestCell(double metresPerPixel) => ErrorsACell * _errorPixels * metresPerPixel;

    /// <summary>m: so far may a shadow's edge move where a pixel covers so much.</summary>
    public double MaxShift(double metresPerPixel) => _errorPixels * metresPerPixel;

    /// <summary>The coarsest level with cells no wider than this.</summary>
    /// <param name="widest">m.</param>
    public int LevelOfCell(double widest) => LodLevels.CoarsestWithin(widest, _pixelsPerDegree, _levels);
}
