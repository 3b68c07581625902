namespace Msisf.App.Host;

/// <summary>Where data of one kind is searched, and where <c>msis fetch</c> puts it.</summary>
/// <param name="kind">Name of its folder: ldem, albedo, stars or kernels.</param>
internal sealed class DataFolders(string kind, ProgramHost host)
{
    /// <summary>Elevation models.</summary>
    public const string Ldem = "ldem";

    /// <summary>Maps of the reflectance.</summary>
    public const string Albedo = "albedo";

    /// <summary>Catalogues of stars.</summary>
    public const string Stars = "stars";

    /// <summary>SPICE kernels.</summary>
    public const string Kernels = "kernels";

    /// <summary>The folders in which it is searched if no path is given, first choice first; they need not exist.</summary>
    public IReadOnlyList<string> Searched =>
    [
        .. ((string?[])[Path.Combine("input", kind), Directory.Exists(OfUser) ? OfUser : null, Installed])
            .OfType<string>().DistinctBy(Path.GetFullPath),
    ];

    /// <summary>The folder that <c>msis fetch</c> fills: the installation's or, if that can't be written, the user's.</summary>
    public string Fetched => OfUser is { } own && !CanBeWritten(Installed) ? own : Installed;

    private string Installed => kind == Kernels
        ? Path.Combine(host.Installation.Root, kind)
        : Path.Combine(host.Installation.Root, "input", kind);

    private string? OfUser => host.DataFolder is { } folder ? Path.Combine(folder, kind) : null;

    private static bool CanBeWritten(string folder)
    {
        try
        {
            Directory.CreateDirectory(folder);
            string probe = Path.Combine(folder, $".{Guid.NewGuid():N}");
            File.Create(probe).Dispose();
            File.Delete(probe);
            return true;
        }
        catch (Exception exception) when (exception.IsFileError())
        {
            return false;
        }
    }
}
