using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Server;
using Msisf.Server.Basilisk;

// msis serve starts this program and closes its standard input to end it.
ConsoleLog log = new(Console.Error);
try
{
    ProgramHost host = ServerHost.Create(Console.Out, log, TimeProvider.System, Environment.GetEnvironmentVariable);
    ServeSettings settings = ServeOptions.Read(ServeArguments.FromWords(args));
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
    log.Error($"a bug in msis, please report it with the command line and this text: {exception.GetType().Name}: {exception.Message}");
    log.Raw(exception.StackTrace ?? string.Empty);
    return 70;
}
