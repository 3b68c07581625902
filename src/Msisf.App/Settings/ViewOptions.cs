using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of msis view, and those of msis serve that are for the viewer's page.</summary>
internal static class ViewOptions
{
    private const string ListOfPaths = "[NAME=]PATH,...";

    public static TextSpec Folders { get; } = new(
        "--folders", OptionRole.HowItRuns, ListOfPaths,
        "Output folders, batch files and trajectories (OEM) for the viewer's time line, separated by commas; the name is the path's last "
            + "part if none is given")
    {
        Separator = ",",
    };

    public static TextSpec Catalogues { get; } = new(
        "--catalogues", OptionRole.HowItRuns,
        ListOfPaths, "Catalogues of craters in CSV for the viewer, separated by commas, named in the same way")
    {
        Separator = ",",
    };

    public static FlagSpec NoBrowser { get; } = new("--no-browser", OptionRole.HowItRuns, "Open no browser; only print the address");

    public static ArgumentSpec Opened { get; } = new("PATH", "An output folder, a batch file or a trajectory (OEM) for the time line")
    {
        IsOptional = true,
    };

    /// <summary>The options of msis serve that are for the viewer.</summary>
    public static OptionGroup OfServe { get; } = new("Viewer", [Folders, Catalogues]);

    public static OptionGroup OfView { get; } = new("Viewer", [Folders, Catalogues, NoBrowser]);

    /// <summary>The options of the server that msis view starts.</summary>
    /// <param name="values">Those of msis view.</param>
    /// <exception cref="Core.Errors.UsageException">Two paths have one name.</exception>
    public static OptionValues OfServer(OptionValues values)
    {
        List<string> words = [.. ServeArguments.ToWords(values)];
        if (!values.IsGiven(ServeOptions.Listen))
        {
            words.Add($"{ServeOptions.Listen.Name}=127.0.0.1:0");
        }

        if (values.Argument is { } opened)
        {
            words.RemoveAll(word => word.StartsWith($"{Folders.Name}=", StringComparison.Ordinal));
            string others = Folders.ReadIfGiven(values) is { } given ? $"{Folders.Separator}{given}" : string.Empty;
            words.Add($"{Folders.Name}={opened}{others}");
        }

        OptionValues server = ServeArguments.FromWords(words);
        foreach (TextSpec option in (TextSpec[])[Folders, Catalogues])
        {
            foreach ((string _, string path) in NamedPaths.Read(option, server))
            {
                if (!Path.Exists(path))
                {
                    throw new Core.Errors.UsageException($"{path}: there is no such file or folder.").About(option);
                }
            }
        }

        return server;
    }
}
