using System.Reflection;
using Msisf.Adapters.IO;

namespace Msisf.Cli.Run;

/// <summary>The world as the commands see it: streams, clock, environment, the program's own files. Tests bring their own.</summary>
internal sealed class ProgramHost
{
    private readonly Lazy<Installation> _installation;
    private readonly Func<string, string?> _environment;

    public ProgramHost(TextWriter results, TextWriter error, Func<TextReader> standardInput, TimeProvider clock, Func<string, string?> environment)
    {
        _environment = environment;
        Results = new ResultsWriter(results);
        Log = new Log(error);
        StandardInput = standardInput;
        Clock = clock;
        Times = new RunTimes(clock);
        _installation = new Lazy<Installation>(() => Installation.Above(AppContext.BaseDirectory));
    }

    public TextWriter Results { get; }

    public Log Log { get; }

    public Func<TextReader> StandardInput { get; }

    public TimeProvider Clock { get; }

    public RunTimes Times { get; }

    /// <summary>Version of the program, e.g. "1.0.0".</summary>
    public string Version { get; } =
        typeof(ProgramHost).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion;

    public Installation Installation => _installation.Value;

    /// <summary>A variable of the environment; null if it is not set or empty.</summary>
    public string? Environment(string name) => _environment(name) is { Length: > 0 } value ? value : null;
}
