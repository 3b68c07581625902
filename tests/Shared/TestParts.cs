namespace Msisf.TestSupport;

/// <summary>Where the real parts are that tests work with; a path is null if the part is missing.</summary>
internal static class TestParts
{
    /// <summary>The folder that holds MSISF.sln.</summary>
    public static string RepositoryRoot { get; } = FindRoot();

    /// <summary>The real LOLA model at 4 px/deg.</summary>
    public static string? Ldem4Label => FirstFile(
        Path.Combine(RepositoryRoot, "input", "ldem", "LDEM_4.LBL"),
        Path.Combine(RepositoryRoot, "..", "shared", "ldem", "LDEM_4.LBL"));

    /// <summary>NAIF's CSPICE as a shared library.</summary>
    public static string? CSpiceLibrary => FirstFile(
        Environment.GetEnvironmentVariable("MSISF_CSPICE"),
        Path.Combine(RepositoryRoot, "lib", "native", "libcspice.so"),
        Path.Combine(RepositoryRoot, "..", "shared", "cspice", "libcspice.so"));

    /// <summary>A real piece of LOLA's 5 m maps of the south pole, float32 GeoTIFF, by the beginning of its name.</summary>
    public static string? PolarPiece(string name) => Directory.Exists(PolarPieces)
        ? Directory.EnumerateFiles(PolarPieces, name + "*.tif").Order(StringComparer.Ordinal).FirstOrDefault()
        : null;

    /// <summary>Orion's flight of Artemis I as flown, CCSDS OEM (NASA/JSC).</summary>
    public static string? ArtemisOem => FirstFile(Path.Combine(
        RepositoryRoot, "..", "shared", "missions", "artemis1", "Post_TLI_Orion_AsFlown_20221213_EPH_OEM.asc.gz"));

    /// <summary>Craters above 20 km of Head et al. (2010), as DeepMoon has them.</summary>
    public static string? HeadCraters =>
        FirstFile(Path.Combine(RepositoryRoot, "..", "shared", "craters", "Head2010_gt20km_DeepMoon.csv"));

    /// <summary>Files and reports from the field, each in a folder with what is right; beside the repository.</summary>
    public static string Field => Path.Combine(RepositoryRoot, "..", "shared", "field");

    /// <summary>The folder of the kernels that the project ships.</summary>
    public static string Kernels => Path.Combine(RepositoryRoot, "kernels");

    /// <summary>The system's Python: its packages come from the system too, another Python on the PATH does not know them.</summary>
    public static string? Python => FirstFile("/usr/bin/python3", Program("python3"));

    /// <summary>Where a package of the system's Python 3 is.</summary>
    public static string? PythonPackage(string name) => FirstFile(
        Path.Combine("/usr/lib/python3/dist-packages", name, "__init__.py"));

    /// <summary>A program on the PATH.</summary>
    public static string? Program(string name) => FirstFile(
        (Environment.GetEnvironmentVariable("PATH") ?? string.Empty)
            .Split(Path.PathSeparator)
            .Select(folder => Path.Combine(folder, name))
            .ToArray());

    /// <summary>MariaDB's server, which Debian keeps off the PATH of most users.</summary>
    public static string? MariaDb => FirstFile(Program("mariadbd"), "/usr/sbin/mariadbd");

    private static string PolarPieces => Path.Combine(RepositoryRoot, "..", "shared", "dem_polar");

    private static string? FirstFile(params string?[] candidates) =>
        candidates.FirstOrDefault(candidate => candidate is not null && File.Exists(candidate));

    private static string FindRoot()
    {
        DirectoryInfo? folder = new(AppContext.BaseDirectory);
        while (folder is not null && !File.Exists(Path.Combine(folder.FullName, "MSISF.sln")))
        {
            folder = folder.Parent;
        }

        return folder?.FullName ?? throw new InvalidOperationException("MSISF.sln is in no folder above the tests.");
    }
}
