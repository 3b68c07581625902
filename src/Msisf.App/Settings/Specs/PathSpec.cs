using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a path; in a configuration file it is relative to that file's folder.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="Kind">What lies there.</param>
/// <param name="Help">See <see cref="OptionSpec"/>.</param>
internal sealed record PathSpec(string Name, PathKind Kind, string Help) : OptionSpec(Name, Help)
{
    /// <summary>The default; null if there is none.</summary>
    public string? Default { get; init; }

    /// <inheritdoc/>
    public override string ValueName => Kind switch
    {
        PathKind.File => "FILE",
        PathKind.Folder => "DIR",
        _ => "PATH",
    };

    /// <inheritdoc/>
    public override string? DefaultValue => Default;

    /// <summary>The path, or the default, which the option must have.</summary>
    /// <exception cref="BadInputException">Empty.</exception>
    public string Read(OptionValues values) => ReadIfGiven(values) ?? Default!;

    /// <summary>The path; null if it is not given.</summary>
    /// <exception cref="BadInputException">Empty.</exception>
    public string? ReadIfGiven(OptionValues values)
    {
        string? text = values.Text(this);
        return text is null || text.Trim().Length > 0
            ? text
            : throw new BadInputException($"{Name} is empty; a path is needed.").About(this);
    }
}
