using Msisf.App.Serving;
using Msisf.App.Settings;

namespace Msisf.Cli.Commands;

/// <summary><c>msis view</c>: runs a server until a signal ends it, and opens its page in the browser.</summary>
internal static class ViewCommand
{
    public static Task<int> RunAsync(CommandCall call, CancellationToken cancellation)
    {
        Browser browser = new(call.Host);
        return ServerProgram.RunAsync(
            ViewOptions.OfServer(call.Values),
            call.Host,
            cancellation,
            address =>
            {
                call.Host.Results.WriteLine(address);
                call.Host.Results.Flush();
                if (!ViewOptions.NoBrowser.Read(call.Values))
                {
                    browser.Open(address);
                }
            });
    }
}

/// <summary><c>msis serve</c>: runs the server until a signal ends it.</summary>
internal static class ServeCommand
{
    public static Task<int> RunAsync(CommandCall call, CancellationToken cancellation) =>
        ServerProgram.RunAsync(call.Values, call.Host, cancellation);
}
