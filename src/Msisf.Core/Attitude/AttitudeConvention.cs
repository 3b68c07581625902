namespace Msisf.Core.Attitude;

/// <summary>How the rotation of a given attitude is meant. <c>default</c> is the thesis's way.</summary>
/// <param name="Direction">Which way the rotation turns vectors.</param>
public readonly record struct AttitudeConvention(CameraAxes Axes, RotationDirection Direction)
{
    /// <summary>x_cv = y, y_cv = -z, z_cv = -x (docs/camera-model.md).</summary>
    private static readonly UnitQuaternion OpenCvFromCamera = UnitQuaternion.FromMatrix(
        new RotationMatrix(Vector3D.UnitY, -Vector3D.UnitZ, -Vector3D.UnitX));

    /// <summary>The attitude in the thesis's way; one that is given so stays as it is, to the last bit.</summary>
    /// <param name="given">The rotation as it was given.</param>
    /// <returns>Turns camera axes (looks along -x, y right, z up) into those of the reference frame.</returns>
    public UnitQuaternion FrameFromCamera(UnitQuaternion given)
    {
        UnitQuaternion frameFromAxes = Direction == RotationDirection.ToCamera ? given.Conjugate : given;
        return Axes == CameraAxes.OpenCv ? frameFromAxes * OpenCvFromCamera : frameFromAxes;
    }
}

/// <summary>The axes of a camera in which its attitude is given.</summary>
public enum CameraAxes
{
    /// <summary>The thesis's: the camera looks along -x, y is to the right in the image, z up; the default.</summary>
    Camera,

    /// <summary>OpenCV's: x is to the right in the image, y down, the camera looks along z.</summary>
    OpenCv,
}

/// <summary>Which way the rotation of an attitude turns vectors.</summary>
public enum RotationDirection
{
    /// <summary>From the camera's axes into those of the reference frame; the default.</summary>
    FromCamera,

    /// <summary>From the axes of the reference frame into the camera's, as SPICE's C-matrices and OpenCV's R.</summary>
    ToCamera,
}
