using Msisf.App.Host;
using Msisf.App.Illumination;
using Msisf.App.Preview;
using Msisf.App.Rendering;
using Msisf.App.Settings.Specs;
using Msisf.App.Settings;
using Msisf.App.States;
using Msisf.Cli.Output;

namespace Msisf.Cli.Commands;

/// <summary>The commands that take the options of a run: what draws its frames, or says something of them.</summary>
internal static class RunCommands
{
    /// <summary><c>msis</c> without a command: renders a run, or tells what it would show.</summary>
    public static async Task<int> RenderAsync(CommandCall call, CancellationToken cancellation)
    {
        TrajectorySettings trajectory = TrajectorySettingsReader.Read(call.Values);
        IReadOnlyList<RenderSettings> cameras = RigOptions.Read(call.Values, call.Host.GeoTiffs);
        RenderSettings settings = cameras[0];
        if (DryRunOptions.Read(call.Values) is { } format)
        {
            PreviewPrinter.Print(
                await Task.Run(() => DryRun.Of(trajectory, cameras, call.Host, cancellation), cancellation).ConfigureAwait(false),
                format,
                call.Host.Results);
            PrintTimes(settings, call.Host, []);
            return 0;
        }

        if (settings.ListPatterns)
        {
            PatternList.Print(trajectory, settings, call.Host, cancellation);
            return 0;
        }

        IReadOnlyList<FrameOutputs> outputs = await RenderRun.RunAsync(trajectory, cameras, call.Host, cancellation).ConfigureAwait(false);
        PrintTimes(settings, call.Host, outputs);
        return 0;
    }

    /// <summary><c>msis patterns</c>: makes patterns before a run, either for the whole Moon or for the frames of a run.</summary>
    public static async Task<int> MakePatternsAsync(CommandCall call, CancellationToken cancellation)
    {
        string folder = PatternsOptions.ReadRun(call.Values) is (TrajectorySettings trajectory, RenderSettings settings)
            ? await PatternRun.MakeForFramesAsync(trajectory, settings, call.Host, cancellation).ConfigureAwait(false)
            : await Task.Run(
                () => PatternRun.MakeForWholeMoon(PatternsOptions.ReadWholeMoon(call.Values), call.Host, cancellation),
                cancellation).ConfigureAwait(false);
        call.Host.Results.WriteLine(folder);
        return 0;
    }

    /// <summary><c>msis states</c>: writes the states of a run for other programs.</summary>
    public static int WriteStates(CommandCall call, CancellationToken cancellation)
    {
        StatesFormat format = StatesOptions.Format.Read(call.Values);
        string? path = StatesOptions.ReadPath(call.Values);
        TrajectorySettings trajectory = TrajectorySettingsReader.Read(call.Values);
        IReadOnlyList<RenderSettings> cameras = RigOptions.Read(call.Values, call.Host.GeoTiffs);
        StatesExport.Write(trajectory, cameras, format, path, call.Host, cancellation);
        return 0;
    }

    /// <summary><c>msis illumination</c>: maps and tables of light over an interval.</summary>
    public static int Illuminate(CommandCall call, CancellationToken cancellation)
    {
        IlluminationSettings settings = IlluminationSettings.Read(call.Values);
        OptionValues values = call.Values.With([new(RendererOptions.Renderer.Name, new OptionValue(["native"]))]);
        RenderSettings models = RenderSettingsReader.Read(values, geoTiffs: call.Host.GeoTiffs);
        IlluminationRun.Run(settings, models, call.Host, cancellation);
        return 0;
    }

    private static void PrintTimes(RenderSettings settings, ProgramHost host, IReadOnlyList<FrameOutputs> outputs)
    {
        if (settings.Timing)
        {
            host.Log.Raw(TimingReport.Of(host.Times, outputs));
        }
    }
}
