using Msisf.Core.Errors;

namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a path; a relative path in a configuration file starts at that file's folder.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="Kind">Kind of the path: file, folder or both.</param>
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

    /// <summary>Reads the path, or the default, which must exist.</summary>
    /// <exception cref="UsageException">The path is empty.</exception>
    public string Read(OptionValues values) => ReadIfGiven(values) ?? Default!;

    /// <summary>Reads the path; null if the option is not given.</summary>
    /// <exception cref="UsageException">The path is empty.</exception>
    public string? ReadIfGiven(OptionValues values)
    {
        string? text = values.Text(this);
        return text is null || text.Trim().Length > 0
            ? text
            : throw new UsageException($"{Name} is empty; a path is needed.").About(this);
    }
}
