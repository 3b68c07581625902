using Msisf.App.Illumination;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;

namespace Msisf.Cli.Commands;

/// <summary><c>msis illumination</c>: maps and tables of light over an interval.</summary>
internal static class IlluminationCommand
{
    public static int Run(CommandCall call, CancellationToken cancellation)
    {
        IlluminationSettings settings = IlluminationSettings.Read(call.Values);
        OptionValues values = call.Values.With([new(RendererOptions.Renderer.Name, new OptionValue(["native"]))]);
        RenderSettings models = RenderSettingsReader.Read(values, geoTiffs: call.Host.GeoTiffs);
        IlluminationRun.Run(settings, models, call.Host, cancellation);
        return 0;
    }
}
