using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;
using Msisf.Core.Attitude;
using Msisf.Core.Orbit;

namespace Msisf.App.Settings;

/// <summary>The options that say how the numbers of a batch file are meant; a line <c># msis:</c> of the file can say the same.</summary>
internal static class BatchOptions
{
    public static ChoiceSpec<OrbitFrame> Frame { get; } = new(
        "--batch-frame", DecidesBytes.ByStatesOfRun, BatchConventions.Frames,
        "With --batch-file: frame of its x, y, z and of its quaternions, matrices or Euler angles; its line '# msis: frame=...' says "
            + "the same")
    {
        DefaultNote = "moon-me",
    };

    public static ChoiceSpec<CameraAxes> Axes { get; } = new(
        "--batch-axes", DecidesBytes.ByStatesOfRun, BatchConventions.CameraAxesWords,
        "With --batch-file: camera axes of its attitudes: looks along -x, y right, z up; or OpenCV's, x right, y down, looks along z")
    {
        DefaultNote = "camera",
    };

    public static ChoiceSpec<RotationDirection> Rotation { get; } = new(
        "--batch-rotation", DecidesBytes.ByStatesOfRun, BatchConventions.Rotations,
        "With --batch-file: its quaternions or matrices turn vectors from camera axes into the frame's, or to camera axes, as SPICE's "
            + "C-matrices")
    {
        DefaultNote = "from-camera",
    };

    public static TextSpec Euler { get; } = new(
        "--batch-euler", DecidesBytes.ByStatesOfRun, "SEQUENCE",
        "With --batch-file: axes of the turns euler1, euler2, euler3 (degrees) that lead from the frame's axes to the camera's, each about "
            + "a turned axis, e.g. ZYX or 321");

    public static FlagSpec IgnoreColumns { get; } = new(
        "--ignore-columns", DecidesBytes.ByStatesOfRun, "With --batch-file: leave out columns that are not known, instead of an error");

    public static OptionSpec[] All { get; } = [Frame, Axes, Rotation, Euler, IgnoreColumns];

    /// <summary>Reads how the numbers are meant.</summary>
    public static BatchConventions Read(OptionValues values) => new()
    {
        Frame = Frame.ReadIfGiven(values),
        Axes = Axes.ReadIfGiven(values),
        Rotation = Rotation.ReadIfGiven(values),
        Euler = Euler.ReadIfGiven(values) is { } sequence ? Euler.Named(() => EulerSequence.Parse(sequence)) : null,
        Epoch = values.IsGiven(CameraOptions.Epoch) ? CameraOptions.Epoch.Read(values) : null,
        IgnoresColumns = IgnoreColumns.Read(values),
        Normalizes = CameraOptions.Normalize.Read(values),
    };
}
