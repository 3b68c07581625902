using System.Text;
using Msisf.Adapters.Input;

namespace Msisf.Adapters.Ephemeris;

/// <summary>The kernels that say where a spacecraft is and how it points.</summary>
/// <param name="Spk">Trajectories, in load order.</param>
/// <param name="Ck">Attitudes, in load order.</param>
public sealed record SpacecraftKernels(IReadOnlyList<string> Spk, IReadOnlyList<string> Ck)
{
    /// <summary>No kernel.</summary>
    public static SpacecraftKernels None { get; } = new([], []);

    /// <summary>All of them, in load order.</summary>
    public IReadOnlyList<string> All => [.. Spk, .. Ck];

    /// <summary>Checks that each file is of its kind.</summary>
    /// <exception cref="BadInputException">A file is missing, or of another kind; the message says which option takes it.</exception>
    internal void Check()
    {
        foreach ((IReadOnlyList<string> files, string option, string kind) in
            ((IReadOnlyList<string>, string, string)[])[(Spk, "--spk", "DAF/SPK"), (Ck, "--ck", "DAF/CK")])
        {
            foreach (string file in files)
            {
                string path = KernelList.Existing(file);
                KernelFile.Require(path, option, kind);
                if (!KernelFile.IsBinary(path))
                {
                    throw new BadInputException($"{path}: no binary kernel, which {option} takes. Text kernels are given with --kernels.");
                }
            }
        }
    }
}
