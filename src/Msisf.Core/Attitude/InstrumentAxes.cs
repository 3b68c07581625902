namespace Msisf.Core.Attitude;

/// <summary>How a camera's image lies in the axes of its instrument; <c>default</c> is none.</summary>
/// <param name="Right">To the right in the image, length 1, in the instrument's axes.</param>
/// <param name="Down">Down in the image, the same; perpendicular to <paramref name="Right"/>. The camera looks along their product.</param>
public readonly record struct InstrumentAxes(Vector3D Right, Vector3D Down)
{
    /// <summary>What axes may look like, for messages.</summary>
    public const string ValidValues =
        "RIGHT,DOWN such as +x,+y: two of the axes +x, -x, +y, -y, +z, -z; the camera looks along right x down";

    /// <summary>Turns camera axes (looks along -x, y right, z up) into the instrument's.</summary>
    public UnitQuaternion InstrumentFromCamera =>
        UnitQuaternion.FromMatrix(new RotationMatrix(-Vector3D.Cross(Right, Down), Right, -Down).Transposed);

    /// <summary>Reads axes.</summary>
    /// <param name="text">E.g. "+y,-x".</param>
    /// <exception cref="BadInputException">They are none, or parallel.</exception>
    public static InstrumentAxes Parse(string text)
    {
        string[] parts = text.Split(',', StringSplitOptions.TrimEntries);
        return parts.Length == 2 && Axis(parts[0]) is { } right && Axis(parts[1]) is { } down && Vector3D.Dot(right, down) == 0.0
            ? new InstrumentAxes(right, down)
            : throw new BadInputException($"'{text}' are not axes; {ValidValues}.");
    }

    private static Vector3D? Axis(string text) => text.ToUpperInvariant() switch
    {
        "X" or "+X" => Vector3D.UnitX,
        "-X" => -Vector3D.UnitX,
        "Y" or "+Y" => Vector3D.UnitY,
        "-Y" => -Vector3D.UnitY,
        "Z" or "+Z" => Vector3D.UnitZ,
        "-Z" => -Vector3D.UnitZ,
        _ => null,
    };
}
