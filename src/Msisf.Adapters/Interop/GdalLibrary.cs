using System.Globalization;
using System.Runtime.InteropServices;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Interop;

/// <summary>Finds and loads GDAL's C library, once per process.</summary>
internal static unsafe class GdalLibrary
{
    private const int NewestVersion = 45;

    /// <summary>GDAL 3.0, the first whose functions are all there.</summary>
    private const int OldestVersion = 26;

    private static readonly Lock Gate = new();
    private static readonly Dictionary<string, GdalNative> Loaded = new(StringComparer.Ordinal);

    /// <summary>The library's functions.</summary>
    /// <param name="explicitPath">MSISF_GDAL, or null to search the system.</param>
    /// <param name="purpose">What it is needed for, for the message.</param>
    /// <exception cref="ExternalPartException">
    /// It is missing, or it is another library; the message says where it was looked for.
    /// </exception>
    public static GdalNative Require(string? explicitPath, string purpose)
    {
        lock (Gate)
        {
            string key = explicitPath ?? string.Empty;
            return Loaded.TryGetValue(key, out GdalNative? gdal) ? gdal : Loaded[key] = Load(explicitPath, purpose);
        }
    }

    private static GdalNative Load(string? explicitPath, string purpose)
    {
        foreach (string candidate in explicitPath is null ? Candidates() : [explicitPath])
        {
            if (!NativeLibrary.TryLoad(candidate, out nint library))
            {
                continue;
            }

            try
            {
                GdalNative gdal = new(library);
                gdal.CPLSetErrorHandler(gdal.CPLQuietErrorHandler); // errors are taken from CPLGetLastErrorMsg
                gdal.GDALAllRegister();
                return gdal;
            }
            catch (EntryPointNotFoundException exception)
            {
                throw new ExternalPartException($"{candidate}: a library, but not GDAL 3. Set MSISF_GDAL to GDAL's.", exception);
            }
        }

        string places = explicitPath ?? "the system's libraries (libgdal.so, libgdal.dylib, gdal.dll)";
        throw new ExternalPartException(
            $"{purpose} needs GDAL's library, which is not in {places}. Install it (Debian, Ubuntu: apt-get install libgdal32 or "
                + $"python3-gdal) or set MSISF_GDAL to its path.");
    }

    private static IEnumerable<string> Candidates()
    {
        yield return "libgdal.so";
        for (int version = NewestVersion; version >= OldestVersion; version--)
        {
            yield return string.Create(CultureInfo.InvariantCulture, $"libgdal.so.{version}");
        }

        yield return "libgdal.dylib";
        yield return "gdal.dll";
    }
}
