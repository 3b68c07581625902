using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;

namespace Msisf.Benchmarks.Programs;

/// <summary>The ephemeris that msis itself uses without options, so that both see the same Sun.</summary>
internal sealed class Sun : IDisposable
{
    private readonly OpenedEphemeris _opened;

    private Sun(OpenedEphemeris opened) => _opened = opened;

    public IEphemeris Ephemeris => _opened.Engine;

    /// <summary>Opens it.</summary>
    /// <param name="root">The repository's folder, which holds the kernels.</param>
    public static Sun Open(string root) => new(EphemerisFactory.Open(new EphemerisRequest(
        EphemerisChoice.Auto, [Path.Combine(root, "kernels", "msisf.tm")], root, Environment.GetEnvironmentVariable("MSISF_CSPICE"))));

    public void Dispose() => _opened.Dispose();
}
