using System.ComponentModel;
using System.Diagnostics;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Cluster;

/// <summary>Calls Slurm's commands, and scripts that call them.</summary>
public sealed class SlurmProgram
{
    private readonly string _searchPath;

    /// <summary>Takes the folders in which programs are.</summary>
    /// <param name="searchPath">In the form of the PATH variable.</param>
    public SlurmProgram(string searchPath) => _searchPath = searchPath;

    /// <summary>Whether a command is there.</summary>
    public bool Has(string name) => Find(name) is not null;

    /// <summary>Runs a command to its end.</summary>
    /// <param name="name">One that is on the path.</param>
    /// <param name="arguments">Its arguments.</param>
    /// <param name="cancellation">Ends it, with all that it started.</param>
    /// <exception cref="ExternalPartException">It is missing or can't be started.</exception>
    public async Task<ProcessResult> CallAsync(string name, IReadOnlyList<string> arguments, CancellationToken cancellation)
    {
        ProcessStartInfo start = new(Find(name) ?? throw new ExternalPartException($"no {name} on the PATH."), arguments)
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment["PATH"] = _searchPath;
        using Process process = new() { StartInfo = start };
        try
        {
            process.Start();
        }
        catch (Win32Exception exception)
        {
            throw new ExternalPartException($"{start.FileName}: can't be started: {exception.Message}", exception);
        }

        process.StandardInput.Close();
        Task<string> output = process.StandardOutput.ReadToEndAsync(CancellationToken.None);
        Task<string> error = process.StandardError.ReadToEndAsync(CancellationToken.None);
        try
        {
            await process.WaitForExitAsync(cancellation).ConfigureAwait(false);
        }
        catch (OperationCanceledException)
        {
            process.Kill(entireProcessTree: true);
            throw;
        }

        return new ProcessResult(process.ExitCode, await output.ConfigureAwait(false), await error.ConfigureAwait(false));
    }

    private string? Find(string name) => _searchPath
        .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
        .Select(folder => Path.Combine(folder, name))
        .FirstOrDefault(File.Exists);
}
