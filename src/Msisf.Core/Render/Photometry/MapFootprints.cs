using Msisf.Core.Camera;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Where the pixels of an image lie on a map, and how much of it they cover: the middle of each and its long axis, in pixels of the finest
/// level, and at how many places along the axis which levels are to be read. One object is used for many rows.
/// </summary>
internal sealed class MapFootprints
{
    private readonly FootprintLanes _lanes = new();

    /// <summary>Distance of the middle from the map's left edge.</summary>
    public double[] X { get; private set; } = [];

    /// <summary>Distance of the middle from the map's upper edge.</summary>
    public double[] Y { get; private set; } = [];

    /// <summary>The long axis, to the right.</summary>
    public double[] AxisX { get; private set; } = [];

    /// <summary>The long axis, down.</summary>
    public double[] AxisY { get; private set; } = [];

    /// <summary>Number of places along the axis, a whole number from 1: each covers about a square.</summary>
    public double[] Probes { get; private set; } = [];

    /// <summary>The finer of the two levels between which the width of such a square lies.</summary>
    public long[] Levels { get; private set; } = [];

    /// <summary>How far the width lies towards the coarser level, 0 to below 1.</summary>
    public double[] Parts { get; private set; } = [];

    /// <summary>Finds the footprints of points.</summary>
    /// <param name="points">The surface points.</param>
    /// <param name="camera">The camera that sees them.</param>
    /// <param name="width">Their width, px.</param>
    public void Find(SunlitPoints points, FrameCamera camera, double width, AlbedoMap map)
    {
        EnsureRoom(points.Count);
        for (int first = 0; first < points.Count; first += FootprintLanes.BlockPoints)
        {
            _lanes.Find(points, first, camera, camera.PixelTangent * width, map, this);
        }
    }

    private void EnsureRoom(int count)
    {
        int size = count + SunlitPoints.Padding;
        if (X.Length < size)
        {
            (X, Y) = (new double[size], new double[size]);
            (AxisX, AxisY) = (new double[size], new double[size]);
            (Probes, Parts, Levels) = (new double[size], new double[size], new long[size]);
        }
    }
}
