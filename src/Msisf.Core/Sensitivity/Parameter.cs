using Msisf.Core.Errors;

namespace Msisf.Core.Sensitivity;

/// <summary>
/// A number on which an image depends (docs/sensitivities.md). Compared by reference; the only ones are those of <see cref="All"/>.
/// </summary>
public sealed class Parameter
{
    /// <summary>The word for all of them.</summary>
    public const string AllText = "all";

    private Parameter(string name, ParameterKind kind, int axis, string unit, string description)
    {
        (Name, Kind, Axis, Unit, Description) = (name, kind, axis, unit, description);
    }

    /// <summary>All parameters, in the order in which files hold them.</summary>
    public static IReadOnlyList<Parameter> All { get; } =
    [
        new("position-x", ParameterKind.Position, 0, "m", "camera position along its own x axis (backward)"),
        new("position-y", ParameterKind.Position, 1, "m", "camera position along its own y axis (right)"),
        new("position-z", ParameterKind.Position, 2, "m", "camera position along its own z axis (up)"),
        new("turn-x", ParameterKind.Turn, 0, "rad", "right-handed turn of the camera about its own x axis (backward)"),
        new("turn-y", ParameterKind.Turn, 1, "rad", "right-handed turn of the camera about its own y axis (right)"),
        new("turn-z", ParameterKind.Turn, 2, "rad", "right-handed turn of the camera about its own z axis (up)"),
        new("focal-length", ParameterKind.FocalLength, 0, "px", "focal length along rows; that along columns in proportion"),
        new("principal-x", ParameterKind.Principal, 0, "px", "principal point, to the right"),
        new("principal-y", ParameterKind.Principal, 1, "px", "principal point, down"),
        new("sun-east", ParameterKind.Sun, 0, "rad", "direction to the Sun, eastward at the subsolar point"),
        new("sun-north", ParameterKind.Sun, 1, "rad", "direction to the Sun, northward at the subsolar point"),
        new("albedo", ParameterKind.Albedo, 0, "1", "scale of the albedo; 1 is the image's own"),
    ];

    /// <summary>The six numbers of the camera's position and orientation.</summary>
    public static IReadOnlyList<Parameter> Pose { get; } =
        [.. All.Where(parameter => parameter.Kind is ParameterKind.Position or ParameterKind.Turn)];

    /// <summary>For messages and help: what <see cref="ParseList"/> reads.</summary>
    public static string ValidValues => $"{AllText}, or a list of {string.Join(", ", All.Select(parameter => parameter.Name))}";

    /// <summary>Name, e.g. "turn-x".</summary>
    public string Name { get; }

    /// <summary>What it moves.</summary>
    public ParameterKind Kind { get; }

    /// <summary>Which number of its kind, from 0.</summary>
    public int Axis { get; }

    /// <summary>"m", "rad", "px" or "1".</summary>
    public string Unit { get; }

    /// <summary>What it is, in some words.</summary>
    public string Description { get; }

    /// <summary>Reads the value of an option.</summary>
    /// <param name="text">"all", or names with commas between; capitals and blanks around names don't matter.</param>
    /// <param name="option">What messages call the list.</param>
    /// <returns>In the order of <see cref="All"/>, each once; at least one.</returns>
    /// <exception cref="UsageException">A name is unknown, empty or given twice.</exception>
    public static IReadOnlyList<Parameter> ParseList(string text, string option = "parameters")
    {
        string[] names = text.Split(',', StringSplitOptions.TrimEntries);
        if (names is [var only] && string.Equals(only, AllText, StringComparison.OrdinalIgnoreCase))
        {
            return All;
        }

        HashSet<Parameter> wanted = [];
        foreach (string name in names)
        {
            Parameter found = All.FirstOrDefault(parameter => string.Equals(parameter.Name, name, StringComparison.OrdinalIgnoreCase))
                ?? throw new UsageException($"{option} {text}: '{name}' is not a parameter. Give {ValidValues}.");
            if (!wanted.Add(found))
            {
                throw new UsageException($"{option} {text}: '{name}' is given twice. Give each parameter once.");
            }
        }

        return [.. All.Where(wanted.Contains)];
    }

    /// <inheritdoc/>
    public override string ToString() => Name;
}

/// <summary>What a parameter moves.</summary>
public enum ParameterKind
{
    /// <summary>The camera, along its own axes.</summary>
    Position,

    /// <summary>The camera's axes.</summary>
    Turn,

    /// <summary>The image, away from the principal point.</summary>
    FocalLength,

    /// <summary>The image, as a whole.</summary>
    Principal,

    /// <summary>The direction to the Sun.</summary>
    Sun,

    /// <summary>Nothing: the brightness of all ground.</summary>
    Albedo,
}
