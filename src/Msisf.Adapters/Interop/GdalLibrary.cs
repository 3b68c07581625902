using System.Runtime.InteropServices;
using System.Text;

namespace Msisf.Adapters.Interop;

/// <summary>Finds and loads GDAL's C library, once per process.</summary>
internal static unsafe class GdalLibrary
{
    private const int NewestVersion = 45;

    /// <summary>GDAL 3.0, the first whose functions are all there.</summary>
    private const int OldestVersion = 26;

    /// <summary>
    /// Memory of decoded blocks in MB, where GDAL takes a twentieth of the machine's; how long it waits for other computers, s: for a
    /// connection, for <see cref="LeastBytesPerSecond"/>, and for one answer as a whole; that it asks once more; and that it lists no
    /// folders of theirs.
    /// </summary>
    private static readonly (string Name, string Value)[] Settings =
    [
        ("GDAL_CACHEMAX", "64"), ("GDAL_HTTP_CONNECTTIMEOUT", "10"), ("GDAL_HTTP_LOW_SPEED_TIME", "10"),
        ("GDAL_HTTP_LOW_SPEED_LIMIT", LeastBytesPerSecond), ("GDAL_HTTP_TIMEOUT", "60"), ("GDAL_HTTP_MAX_RETRY", "1"),
        ("GDAL_HTTP_RETRY_DELAY", "1"), ("GDAL_DISABLE_READDIR_ON_OPEN", "TRUE"),
    ];

    /// <summary>A server that sends fewer for 10 s counts as broken off.</summary>
    private const string LeastBytesPerSecond = "1000";

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

    /// <summary>A library that was loaded before, for what its virtual files need; null if none was.</summary>
    public static GdalNative? AnyLoaded()
    {
        lock (Gate)
        {
            return Loaded.Values.FirstOrDefault();
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
                foreach ((string name, string value) in Settings)
                {
                    SetDefault(gdal, name, value);
                }

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

    /// <summary>Sets an option of GDAL's that neither its own configuration nor the environment has.</summary>
    private static void SetDefault(GdalNative gdal, string name, string value)
    {
        fixed (byte* key = Encoding.UTF8.GetBytes(name + '\0'), text = Encoding.UTF8.GetBytes(value + '\0'))
        {
            if (gdal.CPLGetConfigOption(key, null) is null)
            {
                gdal.CPLSetConfigOption(key, text);
            }
        }
    }

    private static IEnumerable<string> Candidates()
    {
        yield return "libgdal.so";
        for (int version = NewestVersion; version >= OldestVersion; version--)
        {
            yield return Invariant($"libgdal.so.{version}");
        }

        yield return "libgdal.dylib";
        yield return "gdal.dll";
    }
}
