using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;

namespace Msisf.App.DataSets;

/// <summary>What a folder of outputs was like before a data set was to be made there.</summary>
/// <param name="Path">The folder.</param>
/// <param name="FirstMade">The first folder on the way to it that was not there; null if it was.</param>
/// <param name="States">The file of states; null if there was none.</param>
/// <param name="ManifestBytes">Length of the manifest; 0 if there was none.</param>
internal sealed record FolderBefore(string Path, string? FirstMade, byte[]? States, long ManifestBytes)
{
    public static FolderBefore Of(string folder) => FileErrors.ToExternalPart($"{folder}: can't be read", () =>
    {
        string states = System.IO.Path.Combine(folder, DataSetRun.StatesName);
        string? firstMade = null;
        for (string? above = System.IO.Path.GetFullPath(folder); above is not null && !Directory.Exists(above);
            above = System.IO.Path.GetDirectoryName(above))
        {
            firstMade = above;
        }

        return new FolderBefore(folder, firstMade, File.Exists(states) ? File.ReadAllBytes(states) : null, LengthOf(folder));
    });

    /// <summary>Takes back what was written if no run has begun: the manifest has no new line.</summary>
    public void RestoreIfUnused()
    {
        if (LengthOf(Path) != ManifestBytes)
        {
            return;
        }

        FileErrors.ToExternalPart($"{Path}: can't be written", () =>
        {
            string states = System.IO.Path.Combine(Path, DataSetRun.StatesName);
            if (States is not null)
            {
                AtomicFile.Write(states, stream => stream.Write(States));
            }
            else
            {
                File.Delete(states);
            }

            if (FirstMade is not null && Directory.Exists(FirstMade))
            {
                Directory.Delete(FirstMade, recursive: true);
            }
        });
    }

    private static long LengthOf(string folder)
    {
        FileInfo manifest = new(new ManifestFile(folder).FilePath);
        return manifest.Exists ? manifest.Length : 0;
    }
}
