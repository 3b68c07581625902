namespace Msisf.Core.Attitude;

/// <summary>Which way the rotation of an attitude turns vectors.</summary>
public enum RotationDirection
{
    /// <summary>From the camera's axes into those of the reference frame; the default.</summary>
    FromCamera,

    /// <summary>From the axes of the reference frame into the camera's, as SPICE's C-matrices and OpenCV's R.</summary>
    ToCamera,
}
