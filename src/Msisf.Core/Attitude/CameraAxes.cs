namespace Msisf.Core.Attitude;

/// <summary>The axes of a camera in which its attitude is given.</summary>
public enum CameraAxes
{
    /// <summary>The thesis's: the camera looks along -x, y is to the right in the image, z up; the default.</summary>
    Camera,

    /// <summary>OpenCV's: x is to the right in the image, y down, the camera looks along z.</summary>
    OpenCv,
}
