using System.Runtime.InteropServices;
using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Interop;

/// <summary>
/// CSPICE with every call checked. CSPICE is not thread-safe and has one kernel pool and one error state per process, so there is one
/// object, and one lock around each sequence of calls.
/// </summary>
internal sealed class CSpice
{
    private const double MetresPerKilometre = 1000.0;

    /// <summary>The versions that the tests ran with.</summary>
    private static readonly string[] TestedVersions = ["CSPICE_N0067"];

    private readonly Lock _gate = new();
    private readonly CSpiceLibrary _library = new();
    private readonly FurnishedKernels _furnished = new();

    private CSpice()
    {
    }

    /// <summary>The process's CSPICE. It is loaded by <see cref="TryStart"/>.</summary>
    public static CSpice Shared { get; } = new();

    /// <summary>The toolkit's version, e.g. "CSPICE_N0067"; empty before <see cref="TryStart"/>.</summary>
    public string Version { get; private set; } = string.Empty;

    /// <summary>Loads the library at first use, makes SPICE report errors instead of ending the process, and checks the version.</summary>
    /// <param name="explicitPath">MSISF_CSPICE, or null.</param>
    /// <param name="installationRoot">The folder that holds lib/native.</param>
    /// <param name="pathOrReason">The library's path; on failure why it can't be used.</param>
    public bool TryStart(string? explicitPath, string installationRoot, out string pathOrReason)
    {
        lock (_gate)
        {
            if (!_library.TryLoad(explicitPath, installationRoot, out string found))
            {
                pathOrReason = $"CSPICE's library could not be loaded; looked at {found}";
                return false;
            }

            if (Version.Length == 0)
            {
                Version = Configure();
            }

            bool isTested = TestedVersions.Contains(Version);
            pathOrReason = isTested
                ? found
                : $"{found} is version {Version}; MSISF was tested with {string.Join(", ", TestedVersions)}";
            return isTested;
        }
    }

    /// <summary>Loads these kernels and unloads all others.</summary>
    /// <param name="paths">Absolute paths in load order.</param>
    /// <exception cref="SpiceException">CSPICE refuses a kernel.</exception>
    public void Furnish(IReadOnlyList<string> paths)
    {
        lock (_gate)
        {
            _furnished.Use(paths);
        }
    }

    /// <summary>Unloads these kernels if they are the loaded ones.</summary>
    /// <param name="paths">As given to <see cref="Furnish"/>.</param>
    public void Unload(IReadOnlyList<string> paths)
    {
        lock (_gate)
        {
            _furnished.Drop(paths);
        }
    }

    /// <summary>
    /// Position of the Sun relative to a body's centre: m, in the body's frame at the time (SPICE turns it by the light time from the
    /// frame's centre to the observer, which is 0).
    /// </summary>
    /// <param name="kernels">The kernels to work with.</param>
    /// <param name="ephemerisSeconds">TDB seconds past J2000.</param>
    /// <param name="aberration">What of light's finite speed is taken in.</param>
    /// <exception cref="SpiceException">CSPICE failed.</exception>
    public Vector3D SunPosition(IReadOnlyList<string> kernels, CelestialBody body, double ephemerisSeconds, Aberration aberration)
    {
        string correction = aberration switch
        {
            Aberration.None => "NONE",
            Aberration.LightTime => "LT",
            Aberration.LightTimeAndStellar => "LT+S",
            _ => throw new ArgumentOutOfRangeException(nameof(aberration)),
        };
        Span<double> positionKm = stackalloc double[3];
        lock (_gate)
        {
            _furnished.Use(kernels);
            CSpiceNative.spkpos_c("SUN", ephemerisSeconds, body.Frame, correction, body.CapitalName, ref positionKm[0], out _);
            CSpiceError.ThrowIfFailed("spkpos_c", ephemerisSeconds);
        }

        return MetresPerKilometre * new Vector3D(positionKm[0], positionKm[1], positionKm[2]);
    }

    /// <summary>The rotation that turns J2000 components into those of a frame.</summary>
    /// <param name="kernels">The kernels to work with.</param>
    /// <param name="ephemerisSeconds">TDB seconds past J2000.</param>
    /// <exception cref="SpiceException">CSPICE failed.</exception>
    public RotationMatrix FrameFromJ2000(IReadOnlyList<string> kernels, string frame, double ephemerisSeconds)
    {
        Span<double> rows = stackalloc double[9];
        lock (_gate)
        {
            _furnished.Use(kernels);
            CSpiceNative.pxform_c("J2000", frame, ephemerisSeconds, ref rows[0]);
            CSpiceError.ThrowIfFailed("pxform_c", ephemerisSeconds);
        }

        return new RotationMatrix(
            new Vector3D(rows[0], rows[1], rows[2]),
            new Vector3D(rows[3], rows[4], rows[5]),
            new Vector3D(rows[6], rows[7], rows[8]));
    }

    /// <summary>How fast a frame turns: rad/s relative to J2000, along J2000's axes.</summary>
    /// <param name="kernels">The kernels to work with.</param>
    /// <param name="ephemerisSeconds">TDB seconds past J2000.</param>
    /// <exception cref="SpiceException">CSPICE failed.</exception>
    public Vector3D RateJ2000(IReadOnlyList<string> kernels, string frame, double ephemerisSeconds)
    {
        Span<double> ofStates = stackalloc double[36];
        Span<double> rotation = stackalloc double[9];
        Span<double> rate = stackalloc double[3];
        lock (_gate)
        {
            _furnished.Use(kernels);
            CSpiceNative.sxform_c("J2000", frame, ephemerisSeconds, ref ofStates[0]);
            CSpiceError.ThrowIfFailed("sxform_c", ephemerisSeconds);
            CSpiceNative.xf2rav_c(in ofStates[0], ref rotation[0], ref rate[0]);
            CSpiceError.ThrowIfFailed("xf2rav_c", ephemerisSeconds);
        }

        return new Vector3D(rate[0], rate[1], rate[2]);
    }

    /// <summary>State of a body relative to another one's centre: m, m/s, J2000, light time left out.</summary>
    /// <param name="kernels">The kernels to work with.</param>
    /// <param name="target">NAIF's number.</param>
    /// <param name="observer">The other body.</param>
    /// <param name="ephemerisSeconds">TDB seconds past J2000.</param>
    /// <exception cref="SpiceException">CSPICE failed.</exception>
    public StateVector StateOf(IReadOnlyList<string> kernels, int target, CelestialBody observer, double ephemerisSeconds)
    {
        Span<double> km = stackalloc double[6];
        lock (_gate)
        {
            _furnished.Use(kernels);
            CSpiceNative.spkgeo_c(target, ephemerisSeconds, "J2000", observer.NaifNumber, ref km[0], out _);
            CSpiceError.ThrowIfFailed("spkgeo_c", ephemerisSeconds);
        }

        return MetresPerKilometre * new StateVector(new Vector3D(km[0], km[1], km[2]), new Vector3D(km[3], km[4], km[5]));
    }

    /// <summary>Whether a text kernel has a variable of a body, such as POLE_RA.</summary>
    /// <param name="kernels">The kernels to work with.</param>
    /// <param name="item">The variable's name after that number.</param>
    /// <exception cref="SpiceException">CSPICE failed.</exception>
    public bool HasVariable(IReadOnlyList<string> kernels, int naifNumber, string item)
    {
        lock (_gate)
        {
            _furnished.Use(kernels);
            bool isThere = CSpiceNative.bodfnd_c(naifNumber, item) != 0;
            CSpiceError.ThrowIfFailed("bodfnd_c", item);
            return isThere;
        }
    }

    private static string Configure()
    {
        // The default ends the process and prints on standard output.
        CSpiceNative.erract_c("SET", 0, "RETURN");
        CSpiceError.ThrowIfFailed("erract_c", "RETURN");
        CSpiceNative.errprt_c("SET", 0, "NONE");
        CSpiceError.ThrowIfFailed("errprt_c", "NONE");
        nint toolkit = CSpiceNative.tkvrsn_c("TOOLKIT");
        CSpiceError.ThrowIfFailed("tkvrsn_c", "TOOLKIT");
        return Marshal.PtrToStringUTF8(toolkit) ?? string.Empty;
    }
}
