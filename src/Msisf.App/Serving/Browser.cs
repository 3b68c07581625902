using Msisf.Adapters.Programs;
using Msisf.App.Host;

namespace Msisf.App.Serving;

/// <summary>The user's browser, started by what the system has for it.</summary>
/// <param name="host">Log and environment of the program.</param>
internal sealed class Browser(ProgramHost host)
{
    private static readonly string[] Displays = ["DISPLAY", "WAYLAND_DISPLAY"];

    /// <summary>Opens a page; a note says so where there is no browser to be opened.</summary>
    public void Open(string address)
    {
        if (Opener() is not { } opener)
        {
            host.Log.Note($"Open {address} in a browser.");
            return;
        }

        try
        {
            (opener with { Arguments = [.. opener.Arguments, address] }).StartBeside();
        }
        catch (ExternalPartException exception)
        {
            host.Log.Note($"{exception.Message} Open {address} in a browser.");
        }
    }

    private ChildProgram? Opener()
    {
        if (OperatingSystem.IsWindows())
        {
            return new ChildProgram("explorer", []);
        }

        string name = OperatingSystem.IsMacOS() ? "open" : "xdg-open";
        bool hasScreen = OperatingSystem.IsMacOS() || Displays.Any(display => host.Environment(display) is not null);
        return hasScreen && SearchPath.Find(host.Environment("PATH") ?? string.Empty, name) is { } program
            ? new ChildProgram(program, [])
            : null;
    }
}
