using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Render;
using Msisf.Core.Tracing;

namespace Msisf.Core.Detector;

/// <summary>The ground truth of a detector's image: that of the drawn frame without the PSF's margin, and the detector's.</summary>
public sealed class DetectedFrame : IGroundTruth
{
    private readonly NativeFrame _drawn;
    private readonly int _margin;
    private readonly double[] _radianceFactors;
    private readonly double[] _indirectFactors;
    private readonly DetectorImage _image;

    /// <summary>Joins a drawn frame and its image.</summary>
    /// <param name="camera">Camera of the frame, without margin.</param>
    /// <param name="drawn">The frame with margin; must live longer than this.</param>
    /// <param name="margin">px.</param>
    public DetectedFrame(ICamera camera, NativeFrame drawn, int margin, DetectorImage image)
    {
        Camera = camera;
        _drawn = drawn;
        _margin = margin;
        _image = image;
        _radianceFactors = Cut(drawn.RadianceFactors);
        _indirectFactors = Cut(drawn.IndirectFactors);
    }

    /// <inheritdoc/>
    public ICamera Camera { get; }

    /// <inheritdoc/>
    public SceneLight Light => _drawn.Light;

    /// <inheritdoc/>
    public ReadOnlySpan<double> RadianceFactors => _radianceFactors;

    /// <inheritdoc/>
    public ReadOnlySpan<double> IndirectFactors => _indirectFactors;

    /// <inheritdoc/>
    public ReadOnlySpan<double> Electrons => _image.Electrons;

    /// <inheritdoc/>
    public ReadOnlySpan<byte> Saturated => _image.Saturated;

    /// <inheritdoc/>
    public bool TryGet(int x, int y, out SurfaceHit hit, out PixelIllumination light)
    {
        if (!_drawn.TryGet(x + _margin, y + _margin, out hit, out light))
        {
            return false;
        }

        hit = hit with { RayParameter = hit.RayParameter * ParameterFactor(y) };
        return true;
    }

    /// <summary>Rays of the two cameras have other lengths, and a hit's parameter counts in them.</summary>
    private double ParameterFactor(int y) =>
        _drawn.Camera.BandAt(y + _margin).Camera.ImagePlaneDistance / Camera.BandAt(y).Camera.ImagePlaneDistance;

    /// <inheritdoc/>
    void IGroundTruth.ReadRow(int y, TruthRow row)
    {
        ((IGroundTruth)_drawn).ReadRow(y + _margin, row);
        row.Cut(_margin, Camera.Width);
        double factor = ParameterFactor(y);
        foreach (ref double parameter in row.Points.Parameters.AsSpan(0, row.Points.Count))
        {
            parameter *= factor;
        }
    }

    /// <summary>The values of an image without its margin.</summary>
    private double[] Cut(ReadOnlySpan<double> drawn)
    {
        double[] values = new double[drawn.IsEmpty ? 0 : Camera.Width * Camera.Height];
        for (int row = 0; !drawn.IsEmpty && row < Camera.Height; row++)
        {
            drawn.Slice(((row + _margin) * _drawn.Camera.Width) + _margin, Camera.Width).CopyTo(values.AsSpan(row * Camera.Width));
        }

        return values;
    }
}
