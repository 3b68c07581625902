using System.Runtime.InteropServices;

namespace Msisf.Adapters.Interop;

/// <summary>Finds CSPICE's shared library for <see cref="CSpiceNative"/>. Call it under <see cref="CSpice"/>'s lock.</summary>
internal sealed class CSpiceLibrary
{
    private static readonly string FileName = OperatingSystem.IsWindows() ? "cspice.dll" : "libcspice.so";

    private nint _loaded;

    /// <summary>
    /// Loads the library: the explicit path alone if one is given, otherwise beside the program, in the installation, in the system.
    /// </summary>
    /// <param name="explicitPath">MSISF_CSPICE, or null.</param>
    /// <param name="installationRoot">The folder that holds lib/native.</param>
    /// <param name="pathOrFailures">Where it was found; on failure each place with the reason why not.</param>
    public bool TryLoad(string? explicitPath, string installationRoot, out string pathOrFailures)
    {
        string[] candidates = string.IsNullOrEmpty(explicitPath)
            ? [
                Path.Combine(AppContext.BaseDirectory, FileName),
                Path.Combine(Path.GetFullPath(installationRoot), "lib", "native", FileName),
                FileName,
            ]
            : [Path.GetFullPath(explicitPath)];

        List<string> failures = [];
        foreach (string candidate in candidates)
        {
            string? failure = TryLoad(candidate);
            if (failure is null)
            {
                pathOrFailures = candidate;
                return true;
            }

            failures.Add($"{candidate} ({failure})");
        }

        pathOrFailures = string.Join(", ", failures);
        return false;
    }

    /// <returns>Why not, or null.</returns>
    private string? TryLoad(string candidate)
    {
        bool isFile = Path.IsPathRooted(candidate);
        if (isFile && !File.Exists(candidate))
        {
            return "no such file";
        }

        nint handle;
        try
        {
            handle = NativeLibrary.Load(candidate);
        }
        catch (Exception exception) when (exception is DllNotFoundException or BadImageFormatException)
        {
            return isFile ? LastLine(exception.Message) : "not installed in the system";
        }

        if (handle == _loaded)
        {
            return null;
        }

        if (_loaded != nint.Zero || !NativeLibrary.TryGetExport(handle, nameof(CSpiceNative.tkvrsn_c), out _))
        {
            NativeLibrary.Free(handle);
            return _loaded != nint.Zero ? "another CSPICE is loaded already; a process holds one" : "a library, but not CSPICE";
        }

        NativeLibrary.SetDllImportResolver(
            typeof(CSpiceNative).Assembly,
            (name, _, _) => name == CSpiceNative.Library ? handle : nint.Zero);
        _loaded = handle;
        return null;
    }

    /// <summary>The loader's own words are below .NET's general advice, after the path.</summary>
    private static string LastLine(string message)
    {
        string line = message.TrimEnd().Split('\n')[^1].Trim();
        int afterPath = line.IndexOf(": ", StringComparison.Ordinal);
        return afterPath < 0 ? line : line[(afterPath + 2)..];
    }
}
