using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Kernels that the built-in reader holds open, and the engine that works on them.</summary>
public sealed class BuiltInKernels : IDisposable
{
    private readonly List<DafFile> _binaryKernels = [];

    /// <summary>Opens kernels.</summary>
    /// <param name="paths">Kernels (no meta-kernels) in load order; a later one wins over an earlier one.</param>
    /// <param name="body">The body whose frame is asked for; null for the Moon.</param>
    /// <exception cref="BadInputException">
    /// A kernel can't be read, or something that the body's frame or UTC needs is in none of them.
    /// </exception>
    public BuiltInKernels(IReadOnlyList<string> paths, CelestialBody? body = null)
    {
        try
        {
            KernelPool pool = KernelPool.Of(paths);
            foreach (string path in paths)
            {
                OpenBinary(path);
            }

            Ephemeris = new BuiltInEphemeris(
                LeapSecondsKernel.ReadScale(pool),
                SegmentsOf("DAF/SPK"),
                body is { IsMoon: false }
                    ? PoleKernel.Read(pool, body)
                    : new KernelOrientation(SegmentsOf("DAF/PCK"), FrameKernel.ReadBodyFixedFrame(pool, CelestialBody.Moon.Frame)),
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

    /// <inheritdoc/>
    public void Dispose()
    {
        foreach (DafFile kernel in _binaryKernels)
        {
            kernel.Dispose();
        }
    }

    /// <summary>Opens a kernel of positions or orientations; other kernels have nothing that the Sun or the body's frame needs.</summary>
    private void OpenBinary(string path)
    {
        if (KernelFile.IdWordOf(path) is not ("DAF/SPK" or "DAF/PCK"))
        {
            return;
        }

        FileStream stream = KernelFile.OpenBinary(path);
        try
        {
            _binaryKernels.Add(new DafFile(stream, path));
        }
        catch
        {
            stream.Dispose();
            throw;
        }
    }

    private SegmentTable SegmentsOf(string idWord) =>
        new(_binaryKernels.Where(kernel => kernel.IdWord == idWord).SelectMany(DafSegments.Of));
}
