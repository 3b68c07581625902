using Msisf.Core.Camera;

namespace Msisf.Core.Sky;

/// <summary>The sky of one image. Immutable.</summary>
public sealed class FrameSky
{
    private readonly SkyAxes[] _axes;
    private readonly Star[] _stars;

    /// <summary>Chooses the stars that the image may show.</summary>
    /// <param name="catalogue">All stars.</param>
    /// <param name="camera">The camera of the image.</param>
    /// <param name="axes">How the sky lies, of each of its bands.</param>
    /// <param name="reach">rad: how far beyond its border stars matter, by their spread light and by the camera's turning.</param>
    public FrameSky(StarCatalogue catalogue, ICamera camera, IReadOnlyList<SkyAxes> axes, double reach)
    {
        _axes = [.. axes];
        Vector3D[] forwards = [.. camera.Bands.Select((band, index) => axes[index].J2000FromBody * band.Camera.ForwardBodyFixed)];
        Vector3D sum = forwards.Aggregate(default(Vector3D), (total, forward) => total + forward);
        Vector3D axis = sum.Length > 0.0 ? sum.Normalized() : forwards[0];
        double spread = forwards.Max(forward => Vector3D.AngleBetween(axis, forward));
        double border = camera.Bands.Max(band => Math.Atan(band.Camera.Model.BorderTangent()));
        _stars = [.. catalogue.Near(axis, spread + border + reach, axes[0].YearsPastJ2000)];
    }

    /// <summary>The stars that the image may show.</summary>
    public IReadOnlyList<Star> Stars => _stars;

    /// <summary>How the sky lies at a time: the axes of the nearest band.</summary>
    /// <param name="seconds">s after the image's time.</param>
    public SkyAxes AxesAt(double seconds)
    {
        // The bands of images that grow upwards go back in time, so all are looked at.
        SkyAxes nearest = _axes[0];
        foreach (SkyAxes axes in _axes)
        {
            nearest = Math.Abs(axes.Seconds - seconds) < Math.Abs(nearest.Seconds - seconds) ? axes : nearest;
        }

        return nearest;
    }
}
