using Msisf.App.Host;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>Makes the host of the server's program.</summary>
internal static class ServerHost
{
    /// <summary>Creates the host.</summary>
    /// <param name="results">Standard output.</param>
    /// <param name="log">Receives messages; those about a request go to its answer too.</param>
    /// <param name="clock">Clock.</param>
    /// <param name="environment">Gets a variable of the environment.</param>
    public static ProgramHost Create(TextWriter results, ILog log, TimeProvider clock, Func<string, string?> environment) =>
        new(clock, environment)
        {
            Results = results,
            Log = new RequestLog(log),
            Progress = new NoProgress(),
            StandardInput = () => TextReader.Null,
        };

    private sealed class NoProgress : IProgressDisplay, IRunProgress
    {
        public IRunProgress Start(string title, int total, bool unattended) => this;

        public void Advance(string name)
        {
        }

        public void Dispose()
        {
        }
    }
}
