using Msisf.Adapters.Fetching;
using Msisf.Adapters.Programs;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Preparation;

/// <summary>Where a call of <c>msis fetch</c> puts files, and where it asks first.</summary>
internal sealed class FetchTarget
{
    /// <param name="kind">One of the kinds of <see cref="DataFolders"/>.</param>
    /// <exception cref="UsageException"><c>--from</c> names no folder.</exception>
    public FetchTarget(OptionValues values, ProgramHost host, string kind)
    {
        DataFolders standard = new(kind, host);
        string? to = FetchOptions.To.ReadIfGiven(values);
        Folder = to ?? standard.Fetched;
        Searched = to is null ? standard.Searched : [to];
        From = FetchOptions.From.ReadIfGiven(values);
        if (From is not null && !FileFetcher.IsAddress(From) && !Directory.Exists(From))
        {
            throw FetchOptions.From.Wrong($"{From}: there is no such folder. Name one, or the address of one, or leave the option out.");
        }

        Files = new FileFetcher(Folder, SearchPath.Find(host.Environment("PATH") ?? string.Empty, "curl", "curl.exe"));
    }

    /// <summary>The folder that gets the files.</summary>
    public string Folder { get; }

    /// <summary>Folders in which a file may be already.</summary>
    public IReadOnlyList<string> Searched { get; }

    /// <summary>The place that is asked first, a folder or an address; null if there is none.</summary>
    public string? From { get; }

    /// <summary>Gets the files.</summary>
    public FileFetcher Files { get; }
}
