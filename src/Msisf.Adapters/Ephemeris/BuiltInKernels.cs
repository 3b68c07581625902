using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Kernels that the built-in reader holds open, and the engine that works on them.</summary>
public sealed class BuiltInKernels : IDisposable
{
    /// <summary>Opens kernels.</summary>
    /// <param name="paths">Kernels (no meta-kernels) in load order; a later one wins over an earlier one.</param>
    /// <param name="body">The body whose frame is asked for; null for the Moon.</param>
    /// <exception cref="BadInputException">
    /// A kernel can't be read, or something that the body's frame or UTC needs is in none of them.
    /// </exception>
    public BuiltInKernels(IReadOnlyList<string> paths, CelestialBody? body = null)
    {
        Catalogue = new KernelCatalogue(paths);
        try
        {
            Ephemeris = new BuiltInEphemeris(
                LeapSecondsKernel.ReadScale(Catalogue.Pool),
                Catalogue.SegmentsOf("DAF/SPK"),
                body is { IsMoon: false }
                    ? PoleKernel.Read(Catalogue.Pool, body)
                    : new KernelOrientation(
                        Catalogue.SegmentsOf("DAF/PCK"), FrameKernel.ReadBodyFixedFrame(Catalogue.Pool, CelestialBody.Moon.Frame)),
                body);
        }
        catch
        {
            Dispose();
            throw;
        }
    }

    /// <summary>The engine; it works until <see cref="Dispose"/>.</summary>
    public BuiltInEphemeris Ephemeris { get; }

    /// <summary>What the kernels hold.</summary>
    public KernelCatalogue Catalogue { get; }

    /// <inheritdoc/>
    public void Dispose() => Catalogue.Dispose();
}
