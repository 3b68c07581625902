using System.Text;
using Msisf.Adapters.Input;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Turns what the user names (a meta-kernel, or kernels) into the kernels' absolute paths, in load order.</summary>
public static class KernelList
{
    private const string Kernels = "KERNELS_TO_LOAD";
    private const string PathSymbols = "PATH_SYMBOLS";
    private const string PathValues = "PATH_VALUES";

    /// <summary>Replaces each meta-kernel by the kernels that it lists.</summary>
    /// <param name="files">Kernels and meta-kernels (files that begin with KPL/MK, or end in .tm).</param>
    /// <returns>Absolute paths; each file exists.</returns>
    /// <exception cref="BadInputException">A file is missing, or a meta-kernel can't be used.</exception>
    /// <remarks>
    /// A relative name in a meta-kernel starts at the meta-kernel's own folder or, if no file is there, at the working directory, as in
    /// SPICE. SPICE's limit of 80 characters a value does not apply; '+' at a value's end goes on with the next one, as in SPICE. Blanks
    /// around a value are left out. A backslash separates folders, as on Windows, unless a file has it in its name.
    /// </remarks>
    public static IReadOnlyList<string> Expand(IReadOnlyList<string> files)
    {
        List<string> kernels = [];
        foreach (string file in files)
        {
            string path = Existing(file);
            if (IsMetaKernel(path))
            {
                kernels.AddRange(ReadMetaKernel(path));
            }
            else
            {
                kernels.Add(path);
            }
        }

        return kernels.Count > 0 ? kernels : throw new BadInputException("No kernel is named. Name a meta-kernel with --kernels.");
    }

    /// <summary>The kernels of a run, in load order: a later one wins.</summary>
    /// <param name="installed">The meta-kernel of the installation.</param>
    /// <param name="named">What the user names: meta-kernels, which replace the installed one, and kernels on top of them.</param>
    /// <param name="ofSpacecraft">Kernels of the camera's spacecraft, which come last.</param>
    /// <returns>Meta-kernels, and kernels.</returns>
    /// <exception cref="BadInputException">A file is missing, or a kernel of the spacecraft is of another kind.</exception>
    public static IReadOnlyList<string> OnTop(string installed, IReadOnlyList<string> named, SpacecraftKernels ofSpacecraft)
    {
        ILookup<bool, string> byKind = named.ToLookup(file => IsMetaKernel(Existing(file)));
        ofSpacecraft.Check();
        return [.. byKind[true].DefaultIfEmpty(installed), .. byKind[false], .. ofSpacecraft.All];
    }

    private static bool IsMetaKernel(string path) =>
        path.EndsWith(".tm", StringComparison.OrdinalIgnoreCase)
        || KernelFile.IdWordOf(path) == KernelFile.MetaKernel;

    private static IEnumerable<string> ReadMetaKernel(string path)
    {
        KernelPool pool = new();
        using (StreamReader reader = KernelFile.OpenText(path))
        {
            TextKernelReader.Read(reader, path, pool);
        }

        string? other = pool.Names.FirstOrDefault(name => name is not (Kernels or PathSymbols or PathValues));
        if (other is not null)
        {
            throw new BadInputException(
                $"{pool.Existing(other).Source}: a meta-kernel may assign {Kernels}, {PathSymbols} and {PathValues} only. "
                    + $"Put {other} into a text kernel of its own and list that.");
        }

        List<string> names = JoinContinued(pool, Kernels);
        List<string> symbols = JoinContinued(pool, PathSymbols);
        List<string> values = JoinContinued(pool, PathValues);
        if (names.Count == 0 || symbols.Count != values.Count)
        {
            throw new BadInputException(names.Count == 0
                ? $"{path}: {Kernels} is missing: the meta-kernel lists no kernel."
                : $"{path}: {symbols.Count} {PathSymbols} and {values.Count} {PathValues}; each symbol needs one value.");
        }

        string folder = Path.GetDirectoryName(path)!;
        foreach (string name in names)
        {
            string file = ReplaceSymbols(name, symbols, values);
            if (file.Length == 0)
            {
                throw new BadInputException($"{pool.Existing(Kernels).Source}: {Kernels} has an empty name. Remove it.");
            }

            if (file.Contains('\0', StringComparison.Ordinal))
            {
                throw new BadInputException(
                    $"{path}: {NumberText.Shown(file)} in {Kernels} holds a NUL character, as no file name does. "
                        + $"Is the meta-kernel damaged?");
            }

            string kernel = Found(file, folder, path);
            yield return IsMetaKernel(kernel)
                ? throw new BadInputException($"{path}: {name} is a meta-kernel itself; SPICE allows no nesting. List its kernels instead.")
                : kernel;
        }
    }

    private static List<string> JoinContinued(KernelPool pool, string variable)
    {
        List<string> whole = [];
        StringBuilder current = new();
        foreach (string part in pool.Find(variable)?.Texts ?? [])
        {
            string trimmed = part.TrimEnd();
            if (trimmed.EndsWith('+'))
            {
                current.Append(trimmed, 0, trimmed.Length - 1);
                continue;
            }

            whole.Add(current.Append(trimmed).ToString().Trim());
            current.Clear();
        }

        return current.Length == 0
            ? whole
            : throw new BadInputException(
                $"{pool.Existing(variable).Source}: the last value of {variable} ends in '+', but nothing follows.");
    }

    /// <summary>Replaces each $SYMBOL. If several symbols fit, the longest counts, so that $KERNELS is not taken for $K.</summary>
    private static string ReplaceSymbols(string name, List<string> symbols, List<string> values)
    {
        StringBuilder replaced = new();
        for (int i = 0; i < name.Length;)
        {
            int best = name[i] == '$' ? LongestAt(name, i + 1, symbols) : -1;
            replaced.Append(best < 0 ? name[i..(i + 1)] : values[best]);
            i += best < 0 ? 1 : 1 + symbols[best].Length;
        }

        return replaced.ToString();
    }

    /// <summary>Index of the longest symbol at a place of a name; -1 if there is none.</summary>
    private static int LongestAt(string name, int start, List<string> symbols)
    {
        int best = -1;
        for (int i = 0; i < symbols.Count; i++)
        {
            bool fits = string.CompareOrdinal(name, start, symbols[i], 0, symbols[i].Length) == 0;
            best = fits && (best < 0 || symbols[i].Length > symbols[best].Length) ? i : best;
        }

        return best;
    }

    /// <summary>The path of a kernel that a meta-kernel lists.</summary>
    private static string Found(string file, string folder, string metaKernel)
    {
        string besideMetaKernel = Path.GetFullPath(file, folder);
        string inWorkingFolder = Path.GetFullPath(file);
        string also = inWorkingFolder == besideMetaKernel ? string.Empty : $", nor {inWorkingFolder}";
        string withSlashes = file.Replace('\\', '/');
        return ((string[])[
            besideMetaKernel, inWorkingFolder, Path.GetFullPath(withSlashes, folder), Path.GetFullPath(withSlashes)])
            .FirstOrDefault(File.Exists) ?? throw new BadInputException(
                $"{besideMetaKernel}: no such kernel, which {metaKernel} lists{also}. Correct the name, or get the kernel "
                    + "('msis fetch kernels' gets those of msis).");
    }

    /// <summary>The absolute path of a kernel that the user names.</summary>
    internal static string Existing(string file) => Path.GetFullPath(file) is var path && File.Exists(path)
        ? path
        : throw new BadInputException(
            $"{path}: no such kernel. Correct the name, or get the kernel ('msis fetch kernels' gets those of msis).");
}
