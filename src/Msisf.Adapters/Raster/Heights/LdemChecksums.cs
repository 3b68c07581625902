using Msisf.Adapters.IO;
using Msisf.Core.Metadata;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// SHA-256 of a model's files. Those of large files are computed once and remembered in a file beside the model or in the user's cache,
/// as long as length and time of the file stay the same. Only pieces of the largest models' images are read.
/// </summary>
public sealed class LdemChecksums
{
    /// <summary>Bytes: files up to this length are hashed in every run, which takes some ms; LDEM_4 has 2 MB.</summary>
    private const long LongestHashedEachRun = 4L << 20;

    /// <summary>
    /// Bytes of all images of a model that are read completely: a minute at 300 MB/s. LDEM_256 has 8.5 GB, LDEM_512 34 GB.
    /// </summary>
    private const long LargestRead = 16L << 30;

    private readonly ModelFile[] _files;
    private readonly bool _ofPieces;
    private readonly SidecarPlaces _places;
    private readonly HashSet<RememberedChecksum> _remembered;

    private LdemChecksums(ModelFile[] files, bool ofPieces, SidecarPlaces places, HashSet<RememberedChecksum> remembered) =>
        (_files, _ofPieces, _places, _remembered) = (files, ofPieces, places, remembered);

    /// <summary>Bytes that <see cref="Read"/> will read, but for pieces.</summary>
    public long BytesToRead => _files.Where(file => !IsOfPieces(file) && file.FindIn(_remembered) is null).Sum(file => file.Bytes);

    /// <summary>Finds the files and the checksums that were remembered.</summary>
    /// <param name="cacheFolder">The user's cache folder of this program, which need not exist; null if there is none.</param>
    /// <param name="largestRead">bytes: images of a model that has more in all of them are not read completely.</param>
    /// <exception cref="ExternalPartException">A file of the model can't be read.</exception>
    public static LdemChecksums Open(LdemSet set, string? cacheFolder, long largestRead = LargestRead)
    {
        SidecarPlaces places = set.PlacesOf(".checksums", cacheFolder);
        ModelFile[] files = FileErrors.ToExternalPart(
            $"{set.Location}: can't be read", () => set.Parts.SelectMany(FilesOf).ToArray());
        bool ofPieces = files.Where(file => file.Kind == InputKind.ElevationImage).Sum(file => file.Bytes) > largestRead;
        return new LdemChecksums(
            files, ofPieces, places, [.. RememberedChecksum.ReadFile(places.Beside), .. RememberedChecksum.ReadFile(places.Cached)]);
    }

    /// <summary>The model's files with their checksums; computes those that are not remembered, and remembers them.</summary>
    /// <returns>Label and image of each part, and why the checksums could not be stored; null if they were, or need not be.</returns>
    /// <exception cref="ExternalPartException">A file of the model can't be read.</exception>
    public (IReadOnlyList<InputFile> Files, string? Warning) Read(CancellationToken cancellation)
    {
        bool isNew = false;
        InputFile[] inputs = [.. _files.Select(file =>
        {
            if (IsOfPieces(file))
            {
                return file.HashPieces();
            }

            RememberedChecksum? known = file.FindIn(_remembered);
            if (known is null)
            {
                known = FileErrors.ToExternalPart($"{file.Path}: can't be read", () => file.Hash(cancellation));
                isNew |= file.Bytes > LongestHashedEachRun && file.IsUnchanged;
                _remembered.Add(known);
            }

            return new InputFile(file.Kind, known.Name, known.Bytes, known.Sha256);
        })];
        return (inputs, isNew ? Store() : null);
    }

    /// <summary>Whether only pieces are read: also of a file on another computer, or in an archive.</summary>
    private bool IsOfPieces(ModelFile file) =>
        (_ofPieces && file.Kind == InputKind.ElevationImage) || RasterFiles.IsVirtual(file.Path);

    private static IEnumerable<ModelFile> FilesOf(LdemLabel label)
    {
        string image = FileNames.FindIgnoringCase(label.ImagePath) ?? label.ImagePath;
        return image == label.LabelPath
            ? ((string[])[image, .. label.OtherFiles]).Select(path => ModelFile.Of(InputKind.ElevationImage, path))
            : [ModelFile.Of(InputKind.ElevationLabel, label.LabelPath), ModelFile.Of(InputKind.ElevationImage, image)];
    }

    /// <returns>Why it failed; null if it did not.</returns>
    private string? Store()
    {
        string path = _places.ForWriting();
        try
        {
            FileErrors.ToExternalPart($"{path}: can't be written", () =>
                Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!));
            RememberedChecksum[] kept = [.. _files
                .Where(file => file.Bytes > LongestHashedEachRun && !IsOfPieces(file) && file.IsUnchanged)
                .Select(file => file.FindIn(_remembered)!)];
            AtomicFile.WriteText(path, writer => RememberedChecksum.Write(writer, kept));
            return null;
        }
        catch (ExternalPartException exception)
        {
            return $"{exception.Message} The model's checksums are computed anew in each run.";
        }
    }

    /// <summary>A file of the model as it was when the model was opened.</summary>
    private sealed record ModelFile(InputKind Kind, string Path, long Bytes, long WrittenTicks)
    {
        /// <summary>Whether the file still has the length and time that it had.</summary>
        public bool IsUnchanged => this == Of(Kind, Path);

        public static ModelFile Of(InputKind kind, string path)
        {
            if (RasterFiles.IsVirtual(path))
            {
                using Stream stream = RasterFiles.OpenRead(path);
                return new ModelFile(kind, path, stream.Length, 0);
            }

            FileInfo file = new(path);
            FileInfo target = file.LinkTarget is null ? file : file.ResolveLinkTarget(returnFinalTarget: true) as FileInfo ?? file;
            return new ModelFile(kind, path, target.Length, target.LastWriteTimeUtc.Ticks);
        }

        public RememberedChecksum? FindIn(IEnumerable<RememberedChecksum> known) => known.FirstOrDefault(
            one => one.Name == System.IO.Path.GetFileName(Path) && one.Bytes == Bytes && one.WrittenTicks == WrittenTicks);

        public InputFile HashPieces() => FileErrors.ToExternalPart($"{Path}: can't be read", () =>
        {
            using Stream file = RasterFiles.OpenRead(Path);
            return new InputFile(Kind, System.IO.Path.GetFileName(Path), Bytes, FilePieces.Sha256Of(file)) { IsOfPieces = true };
        });

        public RememberedChecksum Hash(CancellationToken cancellation) =>
            new(System.IO.Path.GetFileName(Path), Bytes, WrittenTicks, FileHash.Sha256Of(Path, cancellation));
    }
}

/// <summary>A checksum that was computed before, and the file that it belongs to: a line of a text file.</summary>
/// <param name="Name">Name of the file, without folders.</param>
/// <param name="Bytes">Its length.</param>
/// <param name="WrittenTicks">When it was last written: .NET ticks, UTC.</param>
/// <param name="Sha256">64 hexadecimal digits in small letters.</param>
internal sealed record RememberedChecksum(string Name, long Bytes, long WrittenTicks, string Sha256)
{
    private const string FirstLine = "MSISF checksums 1: SHA-256, bytes, time of last change (.NET ticks, UTC), name";
    private const int Sha256Digits = 64;

    /// <summary>Reads a file of checksums; lines that are damaged are left out.</summary>
    /// <param name="path">May be missing, or null.</param>
    public static IReadOnlyList<RememberedChecksum> ReadFile(string? path)
    {
        try
        {
            string[] lines = File.Exists(path) ? File.ReadAllLines(path) : [];
            return lines.FirstOrDefault() == FirstLine ? [.. lines.Skip(1).Select(TryParse).OfType<RememberedChecksum>()] : [];
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return []; // what can't be read is computed
        }
    }

    /// <summary>Writes a file of checksums.</summary>
    public static void Write(TextWriter writer, IEnumerable<RememberedChecksum> checksums)
    {
        writer.WriteLine(FirstLine);
        foreach (RememberedChecksum one in checksums)
        {
            writer.WriteLine(Invariant($"{one.Sha256} {one.Bytes} {one.WrittenTicks} {one.Name}"));
        }
    }

    private static RememberedChecksum? TryParse(string line) =>
        line.Split(' ', 4) is [{ Length: Sha256Digits } hash, var bytes, var ticks, var name]
            && hash.All(char.IsAsciiHexDigitLower)
            && long.TryParse(bytes, NumberStyles.None, CultureInfo.InvariantCulture, out long length)
            && long.TryParse(ticks, NumberStyles.None, CultureInfo.InvariantCulture, out long written)
            ? new RememberedChecksum(name, length, written, hash)
            : null;
}
