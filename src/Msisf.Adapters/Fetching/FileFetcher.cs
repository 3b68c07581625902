using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.Programs;

namespace Msisf.Adapters.Fetching;

/// <summary>
/// Gets files of public data from folders and addresses into a folder. A file has its name only when it is whole; a download that was cut
/// off goes on where it ended.
/// </summary>
/// <param name="folder">The folder into which the files are put; made if it is missing.</param>
/// <param name="curl">The program that downloads; null if curl is not installed.</param>
public sealed class FileFetcher(string folder, string? curl)
{
    private const int ConnectSeconds = 5;
    private const int StalledSeconds = 15;
    private const int StalledBytesPerSecond = 1000;

    private static readonly TimeSpan BetweenReports = TimeSpan.FromSeconds(0.5);

    private string Incoming => Path.Combine(folder, ".incoming");

    /// <summary>Whether a place is an address, not a folder.</summary>
    public static bool IsAddress(string place) => place.Contains("://", StringComparison.Ordinal);

    /// <summary>Gets a file; it stays out of sight until <see cref="Keep"/>.</summary>
    /// <param name="place">The folder or the address of one.</param>
    /// <param name="name">The file's name there.</param>
    /// <param name="bytes">Bytes of the file, if they are known.</param>
    /// <param name="progress">Is told which part of a download is there, 0 to 1, if its bytes are known.</param>
    /// <returns>Where it is.</returns>
    /// <exception cref="ExternalPartException">The place does not have it, or it is not whole.</exception>
    public async Task<string> GetAsync(string place, string name, long? bytes, IProgress<double>? progress, CancellationToken cancellation)
    {
        string part = PartOf(place, name);
        FileErrors.ToExternalPart(
            $"{folder}: can't be written", () => Directory.CreateDirectory(Path.GetDirectoryName(part)!));
        if (IsAddress(place))
        {
            await DownloadAsync($"{place.TrimEnd('/')}/{name}", part, bytes, progress, cancellation).ConfigureAwait(false);
        }
        else
        {
            CopyFrom(Path.Combine(place, name), part);
        }

        long size = new FileInfo(part).Length;
        if (bytes is { } expected && size != expected)
        {
            File.Delete(part);
            throw new ExternalPartException(Invariant($"{place}: {name} has {size} bytes, not {expected}."));
        }

        return part;
    }

    /// <summary>Forgets a file that was got, since something is wrong with it.</summary>
    public static void Drop(string part) => File.Delete(part);

    /// <summary>Gives a file that was got its place and name.</summary>
    /// <returns>Its path.</returns>
    public string Keep(string part, string name)
    {
        string path = Path.Combine(folder, name);
        FileErrors.ToExternalPart($"{path}: can't be written", () => File.Move(part, path, overwrite: true));
        return path;
    }

    /// <summary>Removes the folders of downloads that no other run can go on with.</summary>
    public void CleanUp()
    {
        foreach (string place in Directory.Exists(Incoming) ? Directory.GetDirectories(Incoming) : [])
        {
            RemoveIfEmpty(place);
        }

        RemoveIfEmpty(Incoming);
    }

    private static void RemoveIfEmpty(string folder)
    {
        if (Directory.Exists(folder) && !Directory.EnumerateFileSystemEntries(folder).Any())
        {
            Directory.Delete(folder);
        }
    }

    /// <summary>Each place has a folder of its own: half a file of one is never continued with the other half of another.</summary>
    private string PartOf(string place, string name) => Path.Combine(
        Incoming, Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(place)))[..8], name);

    private static void CopyFrom(string source, string part) => FileErrors.ToExternalPart($"{source}: can't be copied", () =>
    {
        using FileStream from = File.OpenRead(source);
        using FileStream to = File.Create(part); // File.Copy would copy that nobody may write it
        from.CopyTo(to);
    });

    private async Task DownloadAsync(string address, string part, long? bytes, IProgress<double>? progress, CancellationToken cancellation)
    {
        if (curl is null)
        {
            throw new ExternalPartException("curl is not installed, by which files are downloaded. Install it, or give --from FOLDER.");
        }

        if (File.Exists(part) && new FileInfo(part).Length == bytes)
        {
            return;
        }

        bool isContinued = File.Exists(part);
        ProcessResult result = await RunAsync(address, part, bytes, progress, cancellation).ConfigureAwait(false);
        if (result.ExitCode != 0 && isContinued && File.Exists(part))
        {
            File.Delete(part); // a site that cannot continue a file, or has another one now
            result = await RunAsync(address, part, bytes, progress, cancellation).ConfigureAwait(false);
        }

        if (result.ExitCode != 0 || !File.Exists(part))
        {
            string reason = result.Error.Trim().Split('\n')[^1];
            throw new ExternalPartException($"{address}: {(reason.Length > 0 ? reason : Invariant($"curl ended with {result.ExitCode}"))}");
        }
    }

    /// <summary>A refused connection fails at once, a silent one after 5 s, a stalled one after 15 s.</summary>
    private async Task<ProcessResult> RunAsync(
        string address, string part, long? bytes, IProgress<double>? progress, CancellationToken cancellation)
    {
        ChildProgram download = new(
            curl!,
            [
                "--fail", "--silent", "--show-error", "--location", "--continue-at", "-",
                "--connect-timeout", Invariant($"{ConnectSeconds}"),
                "--speed-limit", Invariant($"{StalledBytesPerSecond}"), "--speed-time", Invariant($"{StalledSeconds}"), "--output", part,
                "--", address,
            ]);
        Task<ProcessResult> running = download.RunAsync(cancellation);
        while (await Task.WhenAny(running, Task.Delay(BetweenReports, CancellationToken.None)).ConfigureAwait(false) != running)
        {
            if (bytes is { } all && File.Exists(part))
            {
                progress?.Report((double)new FileInfo(part).Length / all);
            }
        }

        return await running.ConfigureAwait(false);
    }
}
