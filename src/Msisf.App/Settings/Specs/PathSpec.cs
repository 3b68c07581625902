namespace Msisf.App.Settings.Specs;

/// <summary>An option whose value is a path; a relative path in a configuration file starts at that file's folder.</summary>
/// <param name="Name">Long name with its dashes.</param>
/// <param name="Kind">Kind of the path: file, folder or both.</param>
internal sealed record PathSpec(string Name, OptionRole Role, PathKind Kind, string Help) : OptionSpec(Name, Role, Help)
{
    /// <summary>Stands between several paths of a configuration file.</summary>
    public const string Separator = "\n";

    public string? Default { get; init; }

    /// <summary>Whether several paths may be given; a configuration file has them as a list.</summary>
    public bool TakesSeveral { get; init; }

    public override bool MayBeRepeated => TakesSeveral;

    /// <inheritdoc/>
    /// <remarks>No path has a line feed.</remarks>
    public override string? ListSeparator => TakesSeveral ? Separator : null;

    public override string ValueName => Kind switch
    {
        PathKind.File => "FILE",
        PathKind.Folder => "DIR",
        _ => "PATH",
    };

    public override string? DefaultValue => Default;

    /// <summary>Reads the path, or the default, which must exist.</summary>
    /// <exception cref="UsageException">The path is empty.</exception>
    public string Read(OptionValues values) => ReadIfGiven(values) ?? Default!;

    /// <summary>Reads the path where only one may be; null if the option is not given.</summary>
    /// <exception cref="UsageException">The path is empty, or there are several.</exception>
    public string? ReadIfGiven(OptionValues values) => ReadAll(values) switch
    {
        [] => null,
        [string only] => only,
        { Count: var count } => throw new UsageException(
            Invariant($"{Name} is given {count} times; here it names one. Give it once.")).About(this),
    };

    /// <summary>Reads all paths in their order; empty if the option is not given.</summary>
    /// <exception cref="UsageException">A path is empty.</exception>
    public IReadOnlyList<string> ReadAll(OptionValues values)
    {
        IReadOnlyList<string> words = values.Words(this) ?? [];
        if (!TakesSeveral && words.Count > 1)
        {
            words = [string.Join(' ', words)];
        }

        return words.All(word => word.Trim().Length > 0)
            ? words
            : throw new UsageException($"{Name} is empty; a path is needed.").About(this);
    }
}

/// <summary>What a path leads to.</summary>
internal enum PathKind
{
    File,

    Folder,

    /// <summary>A file or a folder.</summary>
    Any,
}
