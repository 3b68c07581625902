using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Server.Basilisk;

namespace Msisf.Server.Entry;

/// <summary>The server in a process of its own, which msis serve starts; the end of its standard input ends it.</summary>
internal static class ServerEntry
{
    /// <summary>Runs it until its end.</summary>
    /// <param name="arguments">Arguments as passed to <c>main</c>.</param>
    /// <returns>The exit code.</returns>
    public static async Task<int> RunAsync(string[] arguments)
    {
        ConsoleLog log = new(Console.Error);
        try
        {
            ProgramHost host = ServerHost.Create(Console.Out, log, TimeProvider.System, Environment.GetEnvironmentVariable);
            ServeSettings settings = ServeOptions.Read(ServeArguments.FromWords(arguments));
            if (settings.Basilisk is not null)
            {
                await using BasiliskServer basilisk = BasiliskServer.Start(settings, host);
                Console.Out.WriteLine(basilisk.Address);
                await BasiliskServer.RunAsync(Console.In).ConfigureAwait(false);
                return 0;
            }

            await using HttpServer server = await HttpServer.StartAsync(settings, host).ConfigureAwait(false);
            Console.Out.WriteLine(server.Address);
            await server.RunAsync(Console.In).ConfigureAwait(false);
            return 0;
        }
        catch (MsisfException exception)
        {
            log.Error(exception.Message);
            return exception.ExitCode;
        }
        catch (Exception exception)
        {
            log.Error(
                $"a bug in msis, please report it with the command line and this text: {exception.GetType().Name}: {exception.Message}");
            log.Raw(exception.StackTrace ?? string.Empty);
            return 70;
        }
    }
}
