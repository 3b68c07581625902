using Msisf.Adapters.Input;
using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>What some kernels hold, whichever engine computes with them: text variables, segments, names. Thread-safe.</summary>
public sealed class KernelCatalogue : IDisposable
{
    private readonly List<DafFile> _files = [];

    /// <summary>Opens kernels: reads text kernels whole, and the summaries of binary ones.</summary>
    /// <param name="paths">Kernels of all kinds (no meta-kernels) in load order.</param>
    /// <exception cref="BadInputException">A kernel can't be read, or is damaged.</exception>
    public KernelCatalogue(IReadOnlyList<string> paths)
    {
        Pool = KernelPool.Of(paths);
        try
        {
            foreach (string path in paths.Where(path => KernelFile.IdWordOf(path) is "DAF/SPK" or "DAF/PCK" or "DAF/CK"))
            {
                _files.Add(DafFile.Open(path));
            }
        }
        catch
        {
            Dispose();
            throw;
        }

        Names = new BodyNames(Pool);
        Attitudes = new SpacecraftAttitudes(Pool, _files);
        Frames = new FrameSystem(Pool, () => SegmentsOf("DAF/PCK"), Attitudes);
    }

    /// <summary>What the text kernels assign.</summary>
    public KernelPool Pool { get; }

    /// <summary>The binary kernels of positions and orientations, in load order.</summary>
    public IReadOnlyList<DafFile> Files => _files;

    /// <summary>Names of bodies and instruments.</summary>
    public BodyNames Names { get; }

    /// <summary>The frames, computed by the built-in reader.</summary>
    internal FrameSystem Frames { get; }

    /// <summary>The CKs.</summary>
    internal SpacecraftAttitudes Attitudes { get; }

    /// <summary>The segments of a kind of kernel, in load order.</summary>
    /// <param name="idWord">"DAF/SPK" or "DAF/PCK".</param>
    public SegmentTable SegmentsOf(string idWord) =>
        new(_files.Where(kernel => kernel.IdWord == idWord).SelectMany(
            kernel => DafSegments.Of(kernel, Frames.FrameFromJ2000)));

    /// <summary>The number of a spacecraft that the kernels have positions of.</summary>
    /// <param name="cover">The times for which there are data.</param>
    /// <exception cref="BadInputException">No such name is known, or no kernel has the spacecraft; both name what there is.</exception>
    public int SpacecraftOf(string nameOrId, out TdbCover cover)
    {
        int[] bodies =
        [
            .. _files.Where(file => file.IdWord == "DAF/SPK").SelectMany(file => file.Summaries)
                .Select(summary => summary.Integers[0]).Distinct().Order(),
        ];
        string known = $"The kernels have {string.Join(", ", bodies.Select(Names.Describe))}.";
        int number = Names.NumberOf(nameOrId) ?? throw new BadInputException(
            $"No kernel and no list of SPICE has the name {NumberText.Shown(nameOrId)}. {known} Give one of them, or its number.");
        cover = TdbCover.Union(
            from file in _files
            where file.IdWord == "DAF/SPK"
            from summary in file.Summaries
            where summary.Integers[0] == number
            select summary.Interval);
        return bodies.Contains(number)
            ? number
            : throw new BadInputException(Invariant(
                $"No kernel has positions of {Names.Describe(number)}. {known} Add its SPK with --spk, or choose another object."));
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        foreach (DafFile file in _files)
        {
            file.Dispose();
        }
    }
}
