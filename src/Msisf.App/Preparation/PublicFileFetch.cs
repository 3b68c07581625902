using Msisf.Adapters.Fetching;
using Msisf.Adapters.IO;
using Msisf.App.Host;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Preparation;

/// <summary><c>msis fetch stars</c> and <c>kernels</c>: files of which every byte is known.</summary>
internal static class PublicFileFetch
{
    /// <summary>Gets the files that are not in place, and prints the paths of all.</summary>
    /// <param name="kind">One of the kinds of <see cref="DataFolders"/>.</param>
    /// <exception cref="MsisfException">No place has one of them; those before it are in place.</exception>
    public static async Task<int> GetAsync(
        IReadOnlyList<PublicFile> files, string kind, OptionValues values, ProgramHost host, CancellationToken cancellation)
    {
        FetchTarget target = new(values, host, kind);
        try
        {
            foreach (PublicFile file in files)
            {
                host.Results.WriteLine(
                    InPlace(file, target, host) ?? await FetchedAsync(file, target, host, cancellation).ConfigureAwait(false));
            }

            return 0;
        }
        finally
        {
            target.Files.CleanUp();
        }
    }

    private static string? InPlace(PublicFile file, FetchTarget target, ProgramHost host)
    {
        foreach (string path in target.Searched.Select(folder => Path.Combine(folder, file.Name)).Where(File.Exists))
        {
            if (FileErrors.ToBadInput($"{path}: can't be read", () => file.FaultOf(path)) is not { } fault)
            {
                host.Log.Note($"{file.Name} is in place.");
                return path;
            }

            host.Log.Warning($"{fault} It is replaced.");
        }

        return null;
    }

    private static async Task<string> FetchedAsync(
        PublicFile file, FetchTarget target, ProgramHost host, CancellationToken cancellation)
    {
        foreach (string place in ((string?[])[target.From, file.Place]).OfType<string>())
        {
            try
            {
                using IRunProgress? progress =
                    FileFetcher.IsAddress(place) ? host.Progress.Start(file.Name, FractionProgress.Steps, unattended: false) : null;
                string part = await target.Files.GetAsync(
                    place, file.Name, file.Bytes, progress is null ? null : new FractionProgress(progress, file.Name), cancellation)
                    .ConfigureAwait(false);
                if (file.FaultOf(part) is not null)
                {
                    FileFetcher.Drop(part);
                    throw new ExternalPartException($"{place}: {file.Name} is not the published file, by its SHA-256.");
                }

                host.Log.Note($"{file.Name} comes from {place}.");
                return target.Files.Keep(part, file.Name);
            }
            catch (ExternalPartException exception)
            {
                host.Log.Note(exception.Message);
            }
        }

        throw new ExternalPartException(
            $"No place has {file.Name}. Put it, from {file.Place}/{file.Name}, into {target.Folder}, or give --from.");
    }
}
