using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using Msisf.TestSupport;

namespace Msisf.Stress.Time;

/// <summary>The kernels that the project ships.</summary>
internal static class ProjectKernels
{
    /// <summary>The meta-kernel.</summary>
    public static string MetaKernel => Path.Combine(TestParts.Kernels, "msisf.tm");

    private static readonly Lazy<TimeScale> Scale = new(ReadScale);

    /// <summary>The moment of an MJD, UTC.</summary>
    public static Instant OfMjd(double mjd) => Scale.Value.InstantOfMjd(mjd);

    /// <summary>The time scale of the leap seconds kernel, as the built-in engine reads it.</summary>
    public static TimeScale ReadScale()
    {
        KernelPool pool = new();
        string path = Path.Combine(TestParts.Kernels, "naif0012.tls");
        using StreamReader reader = File.OpenText(path);
        TextKernelReader.Read(reader, path, pool);
        return LeapSecondsKernel.ReadScale(pool);
    }

    /// <summary>Opens the built-in engine.</summary>
    public static BuiltInKernels Open() => new(KernelList.Expand([MetaKernel]));

    /// <summary>Opens CSPICE.</summary>
    public static OpenedEphemeris OpenCSpice() => EphemerisFactory.Open(new EphemerisRequest(
        EphemerisChoice.CSpice, [MetaKernel], TestParts.RepositoryRoot, TestParts.CSpiceLibrary));
}
