namespace Msisf.Adapters.Ephemeris;

/// <summary>
/// The variables that text kernels assign. A later assignment replaces an earlier one, as in SPICE; names are case-sensitive.
/// </summary>
public sealed class KernelPool
{
    private readonly Dictionary<string, KernelVariable> _variables = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _replaced = new(StringComparer.Ordinal);

    /// <summary>What the text kernels among some kernels assign.</summary>
    /// <param name="paths">Kernels of all kinds, no meta-kernels, in load order.</param>
    /// <exception cref="BadInputException">A kernel can't be read, or is of no kind that is known.</exception>
    public static KernelPool Of(IEnumerable<string> paths)
    {
        KernelPool pool = new();
        foreach (string path in paths.Where(path => !KernelFile.IsBinary(path)))
        {
            using StreamReader reader = KernelFile.OpenText(path);
            TextKernelReader.Read(reader, path, pool);
        }

        return pool;
    }

    /// <summary>All names, in no order.</summary>
    public IReadOnlyCollection<string> Names => _variables.Keys;

    /// <summary>Assigns (=).</summary>
    public void Assign(string name, KernelVariable values)
    {
        if (_variables.TryGetValue(name, out KernelVariable? before)
            && !(before.Numbers.SequenceEqual(values.Numbers) && before.Texts.SequenceEqual(values.Texts)))
        {
            _replaced.TryAdd(name, before.Source);
        }

        _variables[name] = values;
    }

    /// <summary>Where a name was first assigned, if it was later assigned another value; otherwise null.</summary>
    public string? FirstSource(string name) => _replaced.GetValueOrDefault(name);

    /// <summary>Appends (+=); a new name is assigned.</summary>
    /// <exception cref="BadInputException">Numbers are appended to texts, or the reverse.</exception>
    public void Append(string name, KernelVariable values)
    {
        if (!_variables.TryGetValue(name, out KernelVariable? present))
        {
            _variables[name] = values;
            return;
        }

        if ((present.Numbers.Count > 0) != (values.Numbers.Count > 0))
        {
            throw new BadInputException(
                $"{values.Source}: {name} += mixes numbers and texts; the values before are in {present.Source}.");
        }

        _variables[name] = new KernelVariable([.. present.Numbers, .. values.Numbers], [.. present.Texts, .. values.Texts], values.Source);
    }

    /// <summary>The values of a name, or null.</summary>
    public KernelVariable? Find(string name) => _variables.GetValueOrDefault(name);

    /// <summary>The numbers of a variable that must exist.</summary>
    /// <param name="count">How many values it must have.</param>
    /// <exception cref="BadInputException">Missing, texts, or another count.</exception>
    public IReadOnlyList<double> Numbers(string name, int count)
    {
        KernelVariable variable = Existing(name);
        return variable.Numbers.Count == count
            ? variable.Numbers
            : throw new BadInputException(Invariant($"{variable.Source}: {name} has {variable.Numbers.Count} numbers, {count} expected."));
    }

    /// <summary>The whole number of a variable that must exist.</summary>
    /// <exception cref="BadInputException">Missing, a text, several values, or not a whole number.</exception>
    public int WholeNumber(string name)
    {
        double value = Numbers(name, 1)[0];
        return value == Math.Truncate(value) && Math.Abs(value) <= int.MaxValue
            ? (int)value
            : throw new BadInputException(Invariant($"{Existing(name).Source}: {name} is {value:R}, a whole number expected."));
    }

    /// <summary>The single text of a variable that must exist.</summary>
    /// <exception cref="BadInputException">Missing, a number, or several values.</exception>
    public string Text(string name)
    {
        KernelVariable variable = Existing(name);
        return variable.Texts.Count == 1
            ? variable.Texts[0]
            : throw new BadInputException($"{variable.Source}: {name} must be one text in quotes.");
    }

    /// <summary>The variable of a name that must exist.</summary>
    /// <exception cref="BadInputException">Missing.</exception>
    public KernelVariable Existing(string name) =>
        Find(name) ?? throw new BadInputException($"No text kernel assigns {name}. Add the kernel that does to the list of kernels.");
}

/// <summary>The values of one name in text kernels: all numbers or all texts.</summary>
/// <param name="Numbers">
/// Empty if the values are texts. Dates (@1972-JAN-1) count as seconds past 2000-01-01T12:00:00, each day with 86 400 s.
/// </param>
/// <param name="Texts">Empty if the values are numbers.</param>
/// <param name="Source">The file and line that assigned last, for messages.</param>
public sealed record KernelVariable(IReadOnlyList<double> Numbers, IReadOnlyList<string> Texts, string Source);
