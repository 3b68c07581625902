namespace Msisf.Stress.Fuzz;

/// <summary>Files of one kind, each read by a call whose other inputs are right.</summary>
/// <param name="name">For the report.</param>
/// <param name="inputs">Right files; each gets its turn by chance.</param>
internal sealed class FileTarget(string name, IReadOnlyList<FuzzInput> inputs) : IFuzzTarget
{
    public string Name => name;

    public FuzzCase Make(string folder, CaseRandom random, bool isDamaged)
    {
        FuzzInput input = inputs[random.Below(inputs.Count)];
        string path = Path.Combine(folder, input.FileName);
        byte[] content = input.Prepare(folder);
        File.WriteAllBytes(path, isDamaged ? ByteMutator.Mutate(content, random) : content);
        IReadOnlyList<string>[] calls = [.. input.Calls(path)];
        return new FuzzCase(folder, calls[random.Below(calls.Length)], DamagedFile: path);
    }
}
