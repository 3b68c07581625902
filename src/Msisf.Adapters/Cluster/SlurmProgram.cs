using Msisf.Adapters.Programs;

namespace Msisf.Adapters.Cluster;

/// <summary>Calls Slurm's commands, and scripts that call them.</summary>
public sealed class SlurmProgram
{
    private readonly string _searchPath;

    /// <summary>Takes the folders in which the commands are.</summary>
    /// <param name="searchPath">In the form of the PATH variable.</param>
    public SlurmProgram(string searchPath) => _searchPath = searchPath;

    /// <summary>Whether a command is there.</summary>
    public bool Has(string name) => SearchPath.Find(_searchPath, name) is not null;

    /// <summary>Runs a command to its end.</summary>
    /// <param name="name">One that is on the path.</param>
    /// <param name="cancellation">Ends it, with all that it started.</param>
    /// <exception cref="ExternalPartException">It is missing or can't be started.</exception>
    public Task<ProcessResult> CallAsync(string name, IReadOnlyList<string> arguments, CancellationToken cancellation)
    {
        string program = SearchPath.Find(_searchPath, name) ?? throw new ExternalPartException($"no {name} on the PATH.");
        Dictionary<string, string> environment = new() { ["PATH"] = _searchPath };
        return new ChildProgram(program, arguments) { Environment = environment }.RunAsync(cancellation);
    }
}
