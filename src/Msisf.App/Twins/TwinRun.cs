using Msisf.Adapters.Ephemeris;
using Msisf.Adapters.IO;
using Msisf.Adapters.Input;
using Msisf.Adapters.Layers;
using Msisf.Adapters.RealImages;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Comparison;
using Msisf.Core.Ephemeris;
using Msisf.Core.Layers;
using Msisf.Core.Scene;
using Msisf.Core.Time;
using System.Runtime.InteropServices;

namespace Msisf.App.Twins;

/// <summary><c>msis twin</c>: draws the twin of a real image with the run's own machinery, and compares the two.</summary>
internal sealed class TwinRun
{
    private readonly ImageLabel _label;
    private readonly ProgramHost _host;
    private readonly string _folder;
    private readonly string _name;

    private TwinRun(ImageLabel label, OptionValues values, ProgramHost host)
    {
        (_label, _host) = (label, host);
        _folder = OutputOptions.Folder.Read(values);
        string given = values.Words(OutputOptions.Name) is null
            ? Path.GetFileNameWithoutExtension(label.Path) + ".twin"
            : OutputOptions.Name.Read(values);
        _name = new FrameNaming(given).NameOf(1, 0.0);
    }

    /// <summary>Draws and compares; the paths of the files are written to the host's results.</summary>
    /// <param name="cancellation">Cancels the work; no incomplete file is left.</param>
    /// <exception cref="MsisfException">The label, its data or an option is wrong, or a file can't be written.</exception>
    public static Task RunAsync(OptionValues line, ProgramHost host, CancellationToken cancellation)
    {
        OptionValues values = TwinOptionValues.Begin(line);
        ImageLabel label = ImageLabelReader.Read(line.Argument!);
        return new TwinRun(label, values, host).RunAsync(values, cancellation);
    }

    private async Task RunAsync(OptionValues values, CancellationToken cancellation)
    {
        RequireBody(values);
        TwinBand band = TwinBand.Of(_label, values);
        TwinCamera camera = TwinCamera.Of(_label, band.Nanometres, values);
        float[]? real = null;
        camera = camera.WithKeywords(_label, Path.Combine(_folder, $"{_name}.camera.yaml"), TwinOptions.ReadHasKernels(values));
        (TwinPlan plan, OptionValues ofRun, double? sunOffset) = Plan(TwinOptionValues.WithBand(values, band.Nanometres), camera);
        if (camera.OwnText is not null)
        {
            MadeFolder();
            camera.Save(_host.Log.Note);
        }

        RenderSettings settings = RenderSettingsReader.Read(ofRun, geoTiffs: _host.GeoTiffs);
        if (_label.Pixels.AreThere())
        {
            real = _label.Pixels.Read(band.Index, FirstLine(values), plan.Pixels.Lines);
            RequireValues(real);
        }
        else
        {
            _host.Log.Note($"{_label.Path}: the label stands alone, without its pixels: the twin is drawn, and compared with nothing.");
        }

        if (plan.Pixels.LineStep > 1)
        {
            _host.Log.Note(Invariant(
                $"{_label.Path}: each pixel is taken as the mean of {plan.Pixels.SampleStep} x {plan.Pixels.LineStep} of the camera's."));
        }

        IReadOnlyList<FrameOutputs> outputs = await RenderRun.RunAsync(
            TrajectorySettingsReader.Read(ofRun), [settings], _host, cancellation).ConfigureAwait(false);
        string stem = Path.Combine(_folder, _name);
        float[] drawn = MeansOf($"{stem}.{TwinOptionValues.RadianceFactor}.npy", plan.Pixels, ofSky: 0.0);
        float[] phase = MeansOf($"{stem}.{TwinOptionValues.Phase}.npy", plan.Pixels, ofSky: double.NaN);
        TwinResult result = new(_label, camera, band, plan, settings, _host.Version)
        {
            Drawn = drawn,
            SunOffsetDegrees = sunOffset,
            Image = outputs.Count > 0 ? Path.GetFileName(outputs[0].Paths[0]) : string.Empty,
            Comparison = real is null ? null : TwinComparison.Of(real, drawn, phase, plan.Pixels.Samples, cancellation),
        };
        if (real is not null && result.Comparison is null)
        {
            _host.Log.Warning($"{_label.Path}: the twin shows no lit surface where the image has pixels: nothing is compared.");
        }

        if (result.Comparison is { } compared && (compared.Agreement.Correlation is null || compared.Agreement.Rms is null))
        {
            string why = compared.Agreement.Correlation is null
                ? "the image, or its twin, is the same everywhere"
                : "the image's mean is 0";
            _host.Log.Note($"{_label.Path}: {why}: figures that have no value are null.");
        }

        Write(result, stem);
    }

    private static int FirstLine(OptionValues values) => (TwinOptions.ReadLines(values)?.First ?? 1) - 1;

    private void RequireValues(float[] real)
    {
        if (Array.FindAll(real, float.IsFinite).Length < 2)
        {
            throw new BadInputException(
                $"{_label.Pixels.Path}: none of its pixels has a value: all are marked as missing. Choose another band, by "
                    + $"{TwinOptions.Band.Name}, or image.");
        }
    }

    private void RequireBody(OptionValues values)
    {
        CelestialBody body = CelestialBody.Of(SurfaceOptions.Body.Read(values));
        string target = _label.Text("TARGETNAME");
        if (target.Length == 0)
        {
            throw new BadInputException($"{_label.Path}: the label does not say of which body the image is (TargetName).");
        }

        if (!target.Equals(body.Name, StringComparison.OrdinalIgnoreCase))
        {
            throw new BadInputException(
                $"{_label.Path}: the image is of {target}, and {body.NameInText} is drawn"
                    + (CelestialBody.Find(target) is { } other
                        ? $". Give --body {other.Name.ToLowerInvariant()} and a model of it."
                        : "."));
        }
    }

    /// <summary>What is drawn, the options of the run, and how far the Sun of a cube's table is from the one that is drawn.</summary>
    private (TwinPlan Plan, OptionValues OfRun, double? SunOffsetDegrees) Plan(OptionValues values, TwinCamera camera)
    {
        bool hasKernels = TwinOptions.ReadHasKernels(values);
        CubeStates? states = hasKernels || _label.Tables is null ? null : new CubeStates(_label.Tables, _label.Path);
        if (!hasKernels && states is null)
        {
            throw new UsageException(
                $"{_label.Path}: a {_label.Kind} label does not say where the camera was. Name its kernels: --spk, --ck and --kernels.");
        }

        CelestialBody body = CelestialBody.Of(SurfaceOptions.Body.Read(values));
        using OpenedEphemeris kernels = EphemerisSource.Open(
            _host, LightOptions.Ephemeris.Read(values), body, LightOptions.Kernels.ReadAll(values),
            MissionOptions.ReadKernels(values));
        TwinTimes times = camera.Times(
            _label, new TwinClock(_label, kernels, camera.Known?.Spacecraft ?? 0), ScanOptions.Period.ReadIfGiven(values));
        TwinPlan plan = TwinPlan.Of(_label, camera.File, times, camera.Known, TwinOptions.ReadLines(values));
        OptionValues ofRun = TwinOptionValues.With(
            TwinOptionValues.WithCamera(values, camera, plan),
            [(OutputOptions.Name, _name)]);
        return states is null
            ? (plan, OfKernels(ofRun, camera, plan, kernels), null)
            : OfTables(ofRun.Replacing([MissionOptions.InstrumentAxes], []), states, camera, plan, kernels);
    }

    private OptionValues OfKernels(OptionValues values, TwinCamera camera, TwinPlan plan, OpenedEphemeris kernels)
    {
        List<(OptionSpec, string)> more =
        [
            (CameraOptions.Time, TimeText.Of(kernels.Engine.TimeScale.InstantOf(plan.Start))),
            (MissionOptions.InstrumentAxes, camera.AxesText),
        ];
        if (camera.Known is null
            && ((OptionSpec[])[MissionOptions.Spacecraft, MissionOptions.Instrument])
                .FirstOrDefault(option => values.Words(option) is null) is { } missing)
        {
            throw new UsageException(
                $"{_label.Path}: which spacecraft and instrument the kernels are to be asked for is not known of this camera. Give "
                    + $"{missing.Name}.").About(missing);
        }

        if (camera.Known is { } known)
        {
            more.Add((MissionOptions.Spacecraft, known.Spacecraft.ToString(CultureInfo.InvariantCulture)));
            more.Add((MissionOptions.Instrument, known.Instrument(_label).ToString(CultureInfo.InvariantCulture)));
        }

        return TwinOptionValues.With(values, more);
    }

    private (TwinPlan Plan, OptionValues OfRun, double? SunOffsetDegrees) OfTables(
        OptionValues values, CubeStates tables, TwinCamera camera, TwinPlan plan, OpenedEphemeris kernels)
    {
        SpacecraftState StateAt(double seconds)
        {
            CameraState state = tables.At(seconds, camera.Axes);
            return new SpacecraftState(kernels.Engine.TimeScale.InstantOf(seconds), state.PositionBodyFixed, state.MoonFromCamera);
        }

        SpacecraftState first = StateAt(plan.Start);
        Vector3D sun = kernels.Engine.SunPositionBodyFixed(first.Time, LightOptions.Aberration.Read(values));
        double offset = double.RadiansToDegrees(Vector3D.AngleBetween(sun, tables.SunAt(plan.Start)));
        const double noticed = 0.01; // degrees: the Sun's parallax in a low orbit is 1e-3 degrees
        if (offset > noticed)
        {
            _host.Log.Warning(Invariant(
                $"{_label.Path}: the Sun of its table SunPosition is {offset:F3} degrees away from where the kernels have it, by which "
                    + $"it is drawn."));
        }

        if (camera.File.Scan is null)
        {
            return (plan, TwinOptionValues.With(values, [(CameraOptions.FixedState, StateText(first))]), offset);
        }

        List<SpacecraftState> states =
            [.. Enumerable.Range(0, plan.Exposures).Select(exposure => StateAt(plan.Start + (exposure * plan.Period)))];
        if (states.Count == 1)
        {
            states.Add(StateAt(plan.Start + (0.5 * plan.Period)));
        }

        string path = Path.Combine(MadeFolder(), $"{_name}.states.tab");
        AtomicFile.WriteText(path, writer => BatchFileWriter.Write(
            writer, $"states of {Path.GetFileName(_label.Path)} by its SPICE tables, msis {_host.Version}", states));
        return (plan, TwinOptionValues.With(values, [(ScanOptions.Trajectory, path)]), offset);
    }

    /// <summary>The folder of the files, which is made if it is not there.</summary>
    private string MadeFolder()
    {
        OutputOptions.Folder.NamedInErrors(() => FileErrors.ToExternalPart(
            $"--output-dir {_folder}: the folder can't be made", () => Directory.CreateDirectory(_folder)));
        return _folder;
    }

    private static string StateText(SpacecraftState state) =>
        $"{{{string.Join(',', [TimeText.Of(state.Time), .. state.ToNumbers().Skip(1).Select(NumberSpec.TextOf)])}}}";

    private static float[] MeansOf(string path, ProductPixels pixels, double ofSky) =>
        FileErrors.ToExternalPart($"{path}: can't be read", () =>
        {
            using FileStream stream = File.OpenRead(path);
            (double[] values, int width) = NpyFile.ReadReals(stream);
            return pixels.Means(values, width, ofSky);
        });

    private void Write(TwinResult result, string stem)
    {
        string[] paths = [$"{stem}.npy", $"{stem}.json", $"{stem}.html"];
        using AtomicFileSet files = new();
        files.Write(paths[0], stream =>
        {
            NpyFile.WriteHead(stream, LayerType.Real32, result.Plan.Pixels.Lines, result.Plan.Pixels.Samples);
            stream.Write(MemoryMarshal.AsBytes<float>(result.Drawn));
        });
        files.Write(paths[1], new TwinJson(result).Write);
        files.WriteText(paths[2], new TwinPage(result).Write);
        files.Commit();
        foreach (string path in paths)
        {
            _host.Results.WriteLine(path);
        }
    }
}
