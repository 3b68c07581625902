using Msisf.App.Settings;
using Msisf.Core.Render;

namespace Msisf.App.Serving;

/// <summary>A frame that a client asks for; its options are checked.</summary>
/// <param name="Model">The elevation model.</param>
/// <param name="Place">Where the camera is; null if the request need not say it and does not.</param>
/// <param name="Settings">The other options.</param>
internal sealed record RequestedFrame(ServedModel Model, CameraSettings? Place, RenderSettings Settings)
{
    /// <summary>Whether single rays tell what the image shows: the Sun is a point, and the normals are those of facets.</summary>
    public bool IsTraceable => Settings.Native.Render is { Sun: SunModel.Point, Normals: NormalModel.Facet };

    /// <summary>The same frame without a detector, and with the ground truth of its pixels.</summary>
    public RequestedFrame WithTruth() => this with
    {
        Settings = Settings with
        {
            Native = Settings.Native with { Detector = null, Render = Settings.Native.Render with { KeepGroundTruth = true } },
        },
    };
}
