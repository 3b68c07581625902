using Msisf.Core.Camera;

namespace Msisf.Core.Tests.Support;

/// <summary>Cameras whose pixels look where samples beside the centres of another camera's pixels do.</summary>
internal static class ShiftedCamera
{
    /// <summary>The camera with its principal point shifted the other way.</summary>
    /// <param name="right">px from the pixel's centre.</param>
    /// <param name="down">px.</param>
    public static FrameCamera Of(FrameCamera camera, double right, double down)
    {
        CameraModel model = camera.Model;
        return new CameraModel(
            model.Width, model.Height, (model.FocalX, model.FocalY), (model.PrincipalX - right, model.PrincipalY - down), model.Skew,
            model.Distortion).At(camera.State);
    }
}
