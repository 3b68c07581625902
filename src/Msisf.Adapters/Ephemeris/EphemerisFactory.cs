using Msisf.Adapters.Interop;
using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Opens the ephemeris engine that the user asks for, or the best one that is installed.</summary>
public static class EphemerisFactory
{
    /// <summary>Opens an engine.</summary>
    /// <param name="request">What to open.</param>
    /// <exception cref="BadInputException">A kernel is missing or can't be read.</exception>
    /// <exception cref="ExternalPartException">CSPICE was asked for and can't be used.</exception>
    /// <exception cref="SpiceException">CSPICE refuses a kernel.</exception>
    public static OpenedEphemeris Open(EphemerisRequest request)
    {
        IReadOnlyList<string> kernels = KernelList.Expand(request.KernelFiles);
        if (request.Choice == EphemerisChoice.BuiltIn)
        {
            return OpenBuiltIn(kernels, request.Body, "as asked for");
        }

        RefuseDamaged(kernels);
        if (CSpice.Shared.TryStart(request.CSpicePath, request.InstallationRoot, out string pathOrReason))
        {
            SpiceEphemeris engine = new(CSpice.Shared, kernels, request.Body);
            return new OpenedEphemeris(
                engine, EphemerisChoice.CSpice, $"Ephemeris: {engine.EngineName} ({pathOrReason}).", engine,
                () => new KernelCatalogue(kernels));
        }

        return request.Choice == EphemerisChoice.Auto
            ? OpenBuiltIn(kernels, request.Body, $"because {pathOrReason}")
            : throw new ExternalPartException(
                $"{pathOrReason}. Name the library in MSISF_CSPICE (scripts/get-cspice.sh of the source builds one), or use "
                    + "--ephemeris builtin.");
    }

    /// <summary>Looks at the structure of binary kernels, because CSPICE says of a damaged one only what its own search met.</summary>
    private static void RefuseDamaged(IReadOnlyList<string> kernels)
    {
        foreach (string path in kernels.Where(
            path => KernelFile.IdWordOf(path) is "" or ['D', 'A', 'F', '/', ..] && KernelFile.IsBinary(path)))
        {
            DafFile.Open(path).Dispose();
        }
    }

    private static OpenedEphemeris OpenBuiltIn(IReadOnlyList<string> kernels, CelestialBody body, string reason)
    {
        BuiltInKernels opened = new(kernels, body);
        return new OpenedEphemeris(
            opened.Ephemeris, EphemerisChoice.BuiltIn, $"Ephemeris: {opened.Ephemeris.EngineName}, {reason}.", opened,
            () => opened.Catalogue);
    }
}

/// <summary>Which ephemeris engine to open, and with what.</summary>
/// <param name="KernelFiles">A meta-kernel, or kernels in load order; relative names start at the working directory.</param>
/// <param name="InstallationRoot">The folder that holds lib/native.</param>
/// <param name="CSpicePath">MSISF_CSPICE: the only library to try; null or empty to look in the usual places.</param>
public sealed record EphemerisRequest(
    EphemerisChoice Choice,
    IReadOnlyList<string> KernelFiles,
    string InstallationRoot,
    string? CSpicePath)
{
    /// <summary>The body from whose centre, and in whose frame, the Sun is given.</summary>
    public CelestialBody Body { get; init; } = CelestialBody.Moon;
}

/// <summary>What the user asks for with --ephemeris (auto, cspice, builtin).</summary>
public enum EphemerisChoice
{
    /// <summary>CSPICE if its library loads, otherwise the built-in reader.</summary>
    Auto,

    /// <summary>CSPICE or an error.</summary>
    CSpice,

    /// <summary>The built-in reader.</summary>
    BuiltIn,
}
