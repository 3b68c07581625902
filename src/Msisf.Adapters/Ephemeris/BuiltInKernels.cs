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
            KernelPool pool = new();
            foreach (string path in paths)
            {
                Load(path, pool);
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

    private void Load(string path, KernelPool pool)
    {
        string idWord = KernelFile.IdWordOf(path);
        switch (idWord)
        {
            case "DAF/SPK" or "DAF/PCK":
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

                break;
            case "DAF/CK" or "DAS/DSK" or "DAS/EK":
                // Spacecraft attitudes, shapes and events: nothing that the Sun or the Moon's frame needs.
                break;
            default:
                if (idWord.Contains('\0', StringComparison.Ordinal) || idWord is "NAIF/DAF" or "DAFETF")
                {
                    throw new BadInputException(
                        $"{path}: neither a text kernel nor a binary SPK or PCK: the file begins with \"{idWord.Replace('\0', '?')}\". "
                            + $"Get the file anew, or convert it with NAIF's tobin.");
                }

                using (StreamReader reader = KernelFile.OpenText(path))
                {
                    TextKernelReader.Read(reader, path, pool);
                }

                break;
        }
    }

    private SegmentTable SegmentsOf(string idWord) =>
        new(_binaryKernels.Where(kernel => kernel.IdWord == idWord).SelectMany(DafSegments.Of));
}
