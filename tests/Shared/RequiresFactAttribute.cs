using Xunit;

namespace Msisf.TestSupport;

/// <summary>A real part that a test needs.</summary>
internal enum Part
{
    Ldem4,
    CSpice,
    PovRay,
    Xmllint,
    CFitsio,
    Fitsverify,
    Astropy,
    Gdal,
    GdalLibrary,
    Slurm,
    Shellcheck,
    Parallel,
    Python,
    Numpy,
    Chromium,
    PolarPieces,
    MariaDb,
    LroNac,
    Artemis,
    Field,
    Craters,
}

/// <summary>A test that needs real parts: on a desk it is skipped, by the missing part's name; with CI=true it runs and fails.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class RequiresFactAttribute : FactAttribute
{
    public RequiresFactAttribute(params Part[] parts) => Skip = MissingParts.ReasonToSkip(parts);
}

/// <summary>As <see cref="RequiresFactAttribute"/>, for theories.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class RequiresTheoryAttribute : TheoryAttribute
{
    public RequiresTheoryAttribute(params Part[] parts) => Skip = MissingParts.ReasonToSkip(parts);
}

internal static class MissingParts
{
    /// <summary>These are published by nobody who could be asked for them by a script.</summary>
    private static readonly Part[] FromNoScript = [Part.PolarPieces, Part.LroNac, Part.Artemis, Part.Field, Part.Craters];

    public static string? ReasonToSkip(Part[] parts)
    {
        if (Environment.GetEnvironmentVariable("CI") == "true" && !parts.Any(FromNoScript.Contains))
        {
            return null;
        }

        string[] missing = [.. parts.Where(part => !IsHere(part)).Select(part => part.ToString())];
        return missing.Length == 0 ? null : $"missing: {string.Join(", ", missing)}";
    }

    private static bool IsHere(Part part) => part switch
    {
        Part.Ldem4 => TestParts.Ldem4Label is not null,
        Part.CSpice => TestParts.CSpiceLibrary is not null,
        Part.PovRay => TestParts.Program("povray") is not null,
        Part.Xmllint => TestParts.Program("xmllint") is not null,
        Part.CFitsio => System.Runtime.InteropServices.NativeLibrary.TryLoad("libcfitsio.so.10", out _),
        Part.Fitsverify => TestParts.Program("fitsverify") is not null,
        Part.Astropy => TestParts.PythonPackage("astropy") is not null,
        Part.Gdal => TestParts.Program("gdal_translate") is not null && TestParts.PythonPackage("osgeo") is not null,
        Part.GdalLibrary => Enumerable.Range(26, 20).Any(
            version => System.Runtime.InteropServices.NativeLibrary.TryLoad($"libgdal.so.{version}", out _)),
        Part.Slurm => TestParts.Program("sbatch") is not null,
        Part.Shellcheck => TestParts.Program("shellcheck") is not null,
        Part.Parallel => TestParts.Program("parallel") is not null,
        Part.PolarPieces => TestParts.PolarPiece("NPB") is not null && TestParts.PolarPiece("NPC") is not null,
        Part.Python => TestParts.Python is not null,
        Part.Numpy => TestParts.PythonPackage("numpy") is not null,
        Part.Chromium => TestParts.Program("chromium") is not null,
        Part.MariaDb => TestParts.MariaDb is not null && TestParts.Program("mariadb-install-db") is not null,
        Part.LroNac => LroNac.IsThere,
        Part.Artemis => TestParts.ArtemisOem is not null,
        Part.Craters => TestParts.HeadCraters is not null,
        Part.Field => Directory.Exists(TestParts.Field),
        _ => throw new ArgumentOutOfRangeException(nameof(part)),
    };
}
