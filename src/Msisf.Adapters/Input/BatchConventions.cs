using Msisf.Core.Attitude;
using Msisf.Core.Orbit;
using Msisf.Core.Time;

namespace Msisf.Adapters.Input;

/// <summary>How the numbers of a batch file are meant, where its columns do not say it; null is what is not said.</summary>
public sealed record BatchConventions
{
    /// <summary>Words for <see cref="Frame"/>.</summary>
    public static (string Word, OrbitFrame Value)[] Frames { get; } =
        [("moon-me", OrbitFrame.MoonMe), ("moon-me-epoch", OrbitFrame.MoonMeEpoch), ("j2000", OrbitFrame.J2000)];

    /// <summary>Words for <see cref="Axes"/>.</summary>
    public static (string Word, CameraAxes Value)[] CameraAxesWords { get; } =
        [("camera", CameraAxes.Camera), ("opencv", CameraAxes.OpenCv)];

    /// <summary>Words for <see cref="Rotation"/>.</summary>
    public static (string Word, RotationDirection Value)[] Rotations { get; } =
        [("from-camera", RotationDirection.FromCamera), ("to-camera", RotationDirection.ToCamera)];

    /// <summary>Frame of positions and attitudes.</summary>
    public OrbitFrame? Frame { get; init; }

    /// <summary>Axes of the camera in which its attitudes are given.</summary>
    public CameraAxes? Axes { get; init; }

    /// <summary>Which way quaternions and matrices turn vectors.</summary>
    public RotationDirection? Rotation { get; init; }

    /// <summary>Sequence of the Euler angles.</summary>
    public EulerSequence? Euler { get; init; }

    /// <summary>From when on seconds are counted, and of the frame that is held still, UTC.</summary>
    public ModifiedJulianDate? Epoch { get; init; }

    /// <summary>Whether columns that are not known are left out.</summary>
    public bool IgnoresColumns { get; init; }

    /// <summary>Whether quaternions and matrices may be rounded to a few decimals.</summary>
    public bool Normalizes { get; init; }
}
