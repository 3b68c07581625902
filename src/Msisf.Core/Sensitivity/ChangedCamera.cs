using Msisf.Core.Camera;

namespace Msisf.Core.Sensitivity;

/// <summary>Cameras that differ from one in a number.</summary>
internal static class ChangedCamera
{
    /// <summary>
    /// The camera whose pixels' centres are a grid over another one's image: so many steps along each pixel's edge, from its corner on.
    /// </summary>
    public static CameraModel Grid(CameraModel whole, int perAxis) => new(
        (whole.Width * perAxis) + 1, (whole.Height * perAxis) + 1, (whole.FocalX * perAxis, whole.FocalY * perAxis),
        (((whole.PrincipalX - 0.5) * perAxis) + 1.0, ((whole.PrincipalY - 0.5) * perAxis) + 1.0), whole.Skew * perAxis, whole.Distortion);

    /// <summary>The camera with another focal length or principal point.</summary>
    /// <param name="parameter">Which of them.</param>
    /// <param name="by">px.</param>
    public static CameraModel By(CameraModel model, Parameter parameter, double by)
    {
        double scale = parameter.Kind == ParameterKind.FocalLength ? 1.0 + (by / model.FocalX) : 1.0;
        (double right, double down) = (parameter.Kind, parameter.Axis) switch
        {
            (ParameterKind.Principal, 0) => (by, 0.0),
            (ParameterKind.Principal, _) => (0.0, by),
            _ => (0.0, 0.0),
        };
        return new CameraModel(
            model.Width, model.Height, (model.FocalX * scale, model.FocalY * scale), (model.PrincipalX + right, model.PrincipalY + down),
            model.Skew * scale, model.Distortion);
    }
}
