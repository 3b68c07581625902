using Msisf.Core.Camera;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Tracing;

namespace Msisf.Core.Render;

/// <summary>What a finished frame shows, in the memory of whoever drew it.</summary>
internal interface IDrawnFrame
{
    /// <inheritdoc cref="IGroundTruth.Camera"/>
    ICamera Camera { get; }

    /// <inheritdoc cref="IGroundTruth.Light"/>
    SceneLight Light { get; }

    /// <inheritdoc cref="IGroundTruth.RadianceFactors"/>
    Memory<double> RadianceFactors { get; }

    /// <inheritdoc cref="IGroundTruth.IndirectFactors"/>
    ReadOnlyMemory<double> IndirectFactors => default;

    /// <inheritdoc cref="IGroundTruth.TryGet"/>
    bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light);

    /// <summary>Gets the surface point at a pixel's centre, without its illumination; the normal may be that of the facet.</summary>
    bool TryGetSurface(int x, int y, out SurfaceHit hit);

    /// <inheritdoc cref="IGroundTruth.ReadRow"/>
    void ReadRow(int y, TruthRow row);
}

/// <summary>A frame whose bands are drawn each as a frame of its own, whose rows are copied.</summary>
internal sealed class DrawnBands(ICamera camera, SceneLight light) : IDrawnFrame
{
    private readonly TruthRow?[] _truth = new TruthRow?[camera.Height];
    private readonly double[] _radianceFactors = new double[camera.Width * camera.Height];

    public ICamera Camera => camera;

    public SceneLight Light => light;

    public Memory<double> RadianceFactors => _radianceFactors;

    /// <summary>Copies the rows of a band.</summary>
    /// <param name="drawn">The band, drawn as a frame.</param>
    /// <param name="first">Its first row, from 0.</param>
    /// <param name="hasTruth">Whether the ground truth was kept.</param>
    public void Take(IGroundTruth drawn, int first, bool hasTruth)
    {
        for (int row = 0; row < drawn.Camera.Height; row++)
        {
            Take(drawn, row, first + row, hasTruth);
        }
    }

    /// <summary>Copies a row of an image.</summary>
    /// <param name="row">Its row, from 0.</param>
    /// <param name="target">Which row it becomes, from 0.</param>
    /// <param name="hasTruth">Whether the ground truth was kept.</param>
    public void Take(IGroundTruth drawn, int row, int target, bool hasTruth)
    {
        drawn.RadianceFactors.Slice(row * camera.Width, camera.Width).CopyTo(_radianceFactors.AsSpan(target * camera.Width));
        if (hasTruth)
        {
            drawn.ReadRow(row + 1, _truth[target] = new TruthRow());
        }
    }

    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        TruthRow row = RowAt(y);
        int index = row.Points.Columns.AsSpan(0, row.Points.Count).BinarySearch(x - 1);
        (hit, light) = index < 0 ? default : (row.HitAt(index), row.Lights[index]);
        return index >= 0;
    }

    public bool TryGetSurface(int x, int y, out SurfaceHit hit) => TryGet(x, y, out hit, out _);

    public void ReadRow(int y, TruthRow row)
    {
        TruthRow kept = RowAt(y);
        row.Clear(camera.Width);
        for (int i = 0; i < kept.Points.Count; i++)
        {
            row.Add(kept.Points.Columns[i], kept.HitAt(i), kept.Lights[i]);
        }
    }

    private TruthRow RowAt(int y) => _truth[y - 1]
        ?? throw new InvalidOperationException($"The frame was drawn without {nameof(NativeRenderOptions.KeepGroundTruth)}.");
}
