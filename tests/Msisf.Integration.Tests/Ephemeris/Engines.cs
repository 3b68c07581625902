using Msisf.Adapters.Ephemeris;
using Msisf.TestSupport;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>Opens the engines as the program does.</summary>
internal static class Engines
{
    public static string MetaKernel => Path.Combine(TestParts.Kernels, "msisf.tm");

    public static OpenedEphemeris CSpice(params string[] kernels) => Open(EphemerisChoice.CSpice, kernels);

    public static OpenedEphemeris BuiltIn(params string[] kernels) => Open(EphemerisChoice.BuiltIn, kernels);

    public static OpenedEphemeris Open(EphemerisChoice choice, params string[] kernels) => EphemerisFactory.Open(new EphemerisRequest(
        choice,
        kernels.Length == 0 ? [MetaKernel] : kernels,
        TestParts.RepositoryRoot,
        TestParts.CSpiceLibrary));
}
