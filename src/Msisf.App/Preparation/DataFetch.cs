using System.Buffers.Binary;
using System.Security.Cryptography;
using Msisf.Adapters.Fetching;
using Msisf.Adapters.Input;
using Msisf.Adapters.Raster.Albedo;
using Msisf.Adapters.Raster.Heights;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.App.Preparation;

/// <summary><c>msis fetch</c>: puts NASA's elevation models and maps where the program finds them.</summary>
internal sealed class DataFetch
{
    private const string MapSite = "https://svs.gsfc.nasa.gov/vis/a000000/a004700/a004720";

    /// <summary>SHA-256 of LDEM_4.IMG, version V3.0, with which the published numbers were made.</summary>
    private const string Ldem4Checksum = "972d66d7f330abca62abc21aae270661516c00dd1a881ec102b94df9563656b5";

    /// <summary>The first bytes of TIFF, BigTIFF, JPEG and PNG files; a page that says "not found" has others.</summary>
    private static readonly uint[] Images =
        [0x49492a00, 0x4d4d002a, 0x49492b00, 0x4d4d002b, 0xffd8ffe0, 0xffd8ffe1, 0xffd8ffdb, 0xffd8ffee, 0x89504e47];

    private readonly ProgramHost _host;
    private readonly string _folder;
    private readonly string? _from;
    private readonly FileFetcher _files;

    private DataFetch(OptionValues values, ProgramHost host, string kind)
    {
        _host = host;
        FetchTarget target = new(values, host, kind);
        (_folder, _from, _files) = (target.Folder, target.From, target.Files);
    }

    /// <summary>Gets all files of an elevation model.</summary>
    /// <exception cref="MsisfException">No place has one of them.</exception>
    public static async Task<int> LdemAsync(OptionValues values, ProgramHost host, CancellationToken cancellation)
    {
        DataFetch fetch = new(values, host, DataFolders.Ldem);
        bool hasFloats = FetchOptions.Floats.Read(values);
        try
        {
            foreach (string name in LdemProducts.Of(FetchOptions.ReadResolution(values), hasFloats))
            {
                host.Results.WriteLine(await fetch.ProductAsync(name, LdemProducts.Sites(hasFloats), cancellation).ConfigureAwait(false));
            }

            return 0;
        }
        finally
        {
            fetch._files.CleanUp();
        }
    }

    /// <summary>Gets a map of the reflectance.</summary>
    /// <exception cref="MsisfException">No place has it.</exception>
    public static async Task<int> AlbedoAsync(OptionValues values, ProgramHost host, CancellationToken cancellation)
    {
        DataFetch fetch = new(values, host, DataFolders.Albedo);
        string name = Invariant($"lroc_color_poles_{FetchOptions.Size.Read(values)}k.tif");
        try
        {
            host.Results.WriteLine(await fetch.MapAsync(name, values.IsGiven(FetchOptions.Size), cancellation).ConfigureAwait(false));
            return 0;
        }
        finally
        {
            fetch._files.CleanUp();
        }
    }

    private async Task<string> ProductAsync(string name, IReadOnlyList<LdemSite> sites, CancellationToken cancellation)
    {
        string path = Path.Combine(_folder, $"{name}.LBL");
        if (File.Exists(path))
        {
            if (FaultOf(path) is not { } fault)
            {
                _host.Log.Note($"{name} is in place.");
                return path;
            }

            _host.Log.Warning($"{fault} It is replaced.");
        }

        foreach (LdemSite site in Own().Concat(sites))
        {
            if (await TryProductAsync(name, site, cancellation).ConfigureAwait(false))
            {
                return path;
            }
        }

        throw new ExternalPartException(
            $"No place has the elevation model {name}. Put {name}.LBL and {name}.IMG of {sites[0].Place} into {_folder}, or give --from.");
    }

    /// <summary>The place of <c>--from</c>, in whichever letters its names are.</summary>
    private IEnumerable<LdemSite> Own() =>
        _from is null ? [] : [new LdemSite(_from, HasCapitals: true), new LdemSite(_from, HasCapitals: false)];

    /// <summary>Gets label and image from a place; the label first, since a place that lacks it then costs little.</summary>
    private async Task<bool> TryProductAsync(string name, LdemSite site, CancellationToken cancellation)
    {
        string? labelPart = null;
        try
        {
            labelPart = await GetAsync(site, $"{name}.LBL", bytes: null, cancellation).ConfigureAwait(false);
            LdemLabel label = LdemLabelReader.ReadFile(labelPart);
            string imagePart = await GetAsync(site, $"{name}.IMG", label.FileBytes ?? label.ImageBytes, cancellation)
                .ConfigureAwait(false);
            CheckVersion(name, imagePart);
            _files.Keep(imagePart, $"{name}.IMG");
            _files.Keep(labelPart, $"{name}.LBL");
            _host.Log.Note($"{name} comes from {site.Place}.");
            return true;
        }
        catch (MsisfException exception)
        {
            if (labelPart is not null)
            {
                FileFetcher.Drop(labelPart); // half an image stays, with which another run goes on
            }

            _host.Log.Note(exception.Message);
            return false;
        }
    }

    private async Task<string> GetAsync(LdemSite site, string name, long? bytes, CancellationToken cancellation)
    {
        using IRunProgress? progress = bytes is null || !FileFetcher.IsAddress(site.Place)
            ? null
            : _host.Progress.Start(name, FractionProgress.Steps, unattended: false);
        return await _files.GetAsync(
            site.Place, site.NameOf(name), bytes, progress is null ? null : new FractionProgress(progress, name), cancellation)
            .ConfigureAwait(false);
    }

    private void CheckVersion(string name, string image)
    {
        using FileStream stream = File.OpenRead(image);
        if (name == "LDEM_4" && Convert.ToHexStringLower(SHA256.HashData(stream)) != Ldem4Checksum)
        {
            _host.Log.Warning("LDEM_4.IMG is not version V3.0, with which the published numbers were made: heights may differ a little.");
        }
    }

    /// <summary>What is wrong with a model in place; null if nothing is.</summary>
    private static string? FaultOf(string labelPath)
    {
        try
        {
            LdemLabel label = LdemLabelReader.ReadFile(labelPath);
            FileInfo image = new(label.ImagePath);
            long expected = label.FileBytes ?? label.ImageBytes;
            return !image.Exists ? $"{label.ImagePath}: the image is missing."
                : image.Length != expected ? Invariant($"{label.ImagePath}: it has {image.Length} bytes, but its label says {expected}.")
                : null;
        }
        catch (BadInputException exception)
        {
            return exception.Message;
        }
    }

    private async Task<string> MapAsync(string name, bool mustHaveName, CancellationToken cancellation)
    {
        if (MapIn(_folder, mustHaveName ? name : null) is { } present)
        {
            _host.Log.Note($"{Path.GetFileName(present)} is in place.");
            return present;
        }

        bool isFolder = _from is not null && !FileFetcher.IsAddress(_from);
        string? own = isFolder ? MapIn(_from!, mustHaveName ? name : null) : null;
        (string Place, string Name)[] places =
        [
            .. own is not null ? [(_from!, Path.GetFileName(own))]
                : _from is not null && !isFolder ? [(_from, name)] : Array.Empty<(string, string)>(),
            (MapSite, name),
        ];
        foreach ((string place, string file) in places)
        {
            try
            {
                string part = await _files.GetAsync(place, file, bytes: null, progress: null, cancellation).ConfigureAwait(false);
                if (!IsImage(part))
                {
                    FileFetcher.Drop(part);
                    throw new ExternalPartException($"{place}/{file}: what was sent is not an image.");
                }

                _host.Log.Note($"{file} comes from {place}.");
                return _files.Keep(part, file);
            }
            catch (ExternalPartException exception)
            {
                _host.Log.Note(exception.Message);
            }
        }

        throw new ExternalPartException(
            $"No place has the map {name}. Put it, from https://svs.gsfc.nasa.gov/4720, into {_folder}, or give --from.");
    }

    /// <summary>A map of the reflectance in a folder, that of the name if there is one; null if there is none.</summary>
    private static string? MapIn(string folder, string? name) => !Directory.Exists(folder) ? null
        : Directory.EnumerateFiles(folder).Order(StringComparer.Ordinal)
            .FirstOrDefault(path => name is null ? OpenedAlbedoMap.IsKnown(path) : Path.GetFileName(path) == name);

    private static bool IsImage(string path)
    {
        Span<byte> first = stackalloc byte[sizeof(uint)];
        using FileStream stream = File.OpenRead(path);
        return stream.ReadAtLeast(first, first.Length, throwOnEndOfStream: false) == first.Length
            && Images.Contains(BinaryPrimitives.ReadUInt32BigEndian(first));
    }
}
